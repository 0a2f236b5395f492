#include "tree.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace gsbench::arch {
namespace {

namespace fs = std::filesystem;

bool is_ignored(const std::string& top_level_name) {
  constexpr std::array<std::string_view, 4> kHiddenButOurs = {".ci", ".clang-format", ".clang-tidy",
                                                              ".gitignore"};
  if (top_level_name == "build" || top_level_name == "runs") {
    return true;
  }
  return top_level_name.front() == '.' && std::find(kHiddenButOurs.begin(), kHiddenButOurs.end(),
                                                    top_level_name) == kHiddenButOurs.end();
}

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Replaces literals and comments by spaces, one at a time.
class Blanker {
 public:
  explicit Blanker(std::string_view text) : text_(text), code_(text) {}

  std::string run() {
    while (at_ < text_.size()) {
      if (here("//")) {
        blank_until("\n", 0);
      } else if (here("/*")) {
        blank_until("*/", 2);
      } else if (here("R\"") && (at_ == 0 || !is_identifier_char(text_[at_ - 1]))) {
        blank_raw_string();
      } else if (text_[at_] == '"') {
        blank_quoted('"');
      } else if (text_[at_] == '\'' && !is_digit_separator()) {
        blank_quoted('\'');
      } else {
        ++at_;
      }
    }
    return code_;
  }

 private:
  bool here(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

  bool is_digit_separator() const {
    return at_ > 0 && at_ + 1 < text_.size() && is_identifier_char(text_[at_ - 1]) &&
           is_identifier_char(text_[at_ + 1]);
  }

  void blank_to(std::size_t end) {
    for (; at_ < end; ++at_) {
      if (text_[at_] != '\n') {
        code_[at_] = ' ';
      }
    }
  }

  void blank_until(std::string_view terminator, std::size_t and_then) {
    const auto found = text_.find(terminator, at_);
    blank_to(found == std::string_view::npos ? text_.size() : found + and_then);
  }

  void blank_raw_string() {
    const auto open = text_.find('(', at_);
    if (open == std::string_view::npos) {
      blank_to(text_.size());
      return;
    }
    const std::string delimiter(text_.substr(at_ + 2, open - at_ - 2));
    blank_until(")" + delimiter + "\"", delimiter.size() + 2);
  }

  void blank_quoted(char quote) {
    auto end = at_ + 1;
    while (end < text_.size() && text_[end] != quote && text_[end] != '\n') {
      end += text_[end] == '\\' ? 2 : 1;
    }
    ++at_;
    blank_to(std::min(end, text_.size()));
    if (at_ < text_.size()) {
      ++at_;
    }
  }

  std::string_view text_;
  std::string code_;
  std::size_t at_ = 0;
};

}  // namespace

Tree read_tree(const std::string& root) {
  Tree tree;
  for (auto entry = fs::recursive_directory_iterator(root);
       entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename().string();
    if ((entry.depth() == 0 && is_ignored(name)) || name == "__pycache__") {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      const std::string path = fs::relative(entry->path(), root).generic_string();
      tree[path] = is_text(path) ? read_file(entry->path()) : std::string();
    }
  }
  return tree;
}

bool starts_with(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

bool ends_with(std::string_view text, std::string_view suffix) {
  return text.size() >= suffix.size() && text.substr(text.size() - suffix.size()) == suffix;
}

bool is_cpp_source(std::string_view path) {
  return ends_with(path, ".cpp") || ends_with(path, ".c");
}

bool is_cpp(std::string_view path) {
  return is_cpp_source(path) || ends_with(path, ".hpp") || ends_with(path, ".h");
}

bool is_identifier_char(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_text(std::string_view path) {
  constexpr std::array<std::string_view, 10> kEndings = {
      ".py", ".sh", ".cmake", ".txt", ".md", ".toml", ".mustache", ".html", ".css", ".js"};
  const bool known =
      std::any_of(kEndings.begin(), kEndings.end(), [&](auto end) { return ends_with(path, end); });
  return known || is_cpp(path) || file_name(path).find('.') == std::string_view::npos;
}

std::string_view file_name(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

std::string_view folder_of(std::string_view path) {
  const auto slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::string code_only(std::string_view text) {
  return Blanker(text).run();
}

}  // namespace gsbench::arch
