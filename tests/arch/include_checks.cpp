#include "checks.hpp"
#include "rules.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <set>

#include <fmt/ranges.h>

namespace gsbench::arch {
namespace {

struct Include {
  std::string_view file;
  int line;
  std::string_view header;
  bool quoted;
};

std::string_view skip_spaces(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

// The text after `#include` in a line of code_only text; empty if there is no #include.
std::string_view after_include(std::string_view code) {
  code = skip_spaces(code);
  if (!starts_with(code, "#")) {
    return {};
  }
  code = skip_spaces(code.substr(1));
  constexpr std::string_view kDirective = "include";
  return starts_with(code, kDirective) ? skip_spaces(code.substr(kDirective.size()))
                                       : std::string_view();
}

std::vector<Include> includes_of(std::string_view path, std::string_view text) {
  std::vector<Include> includes;
  const std::string code = code_only(text);
  const auto code_lines = lines_of(code);
  const auto lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view rest = after_include(code_lines[i]);
    if (rest.empty()) {
      continue;
    }
    // code_only blanks literals, so the name is read from the original text at the same column.
    const auto column = static_cast<std::size_t>(rest.data() - code_lines[i].data());
    const std::string_view name = lines[i].substr(column + 1);
    const bool quoted = lines[i][column] == '"';
    includes.push_back(
        {path, static_cast<int>(i) + 1, name.substr(0, name.find(quoted ? '"' : '>')), quoted});
  }
  return includes;
}

std::vector<Include> includes_of(const Tree& tree) {
  std::vector<Include> all;
  for (const auto& [path, text] : tree) {
    if (!is_cpp(path)) {
      continue;
    }
    const auto some = includes_of(path, text);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

bool is_headers(std::string_view header, std::string_view beginning) {
  if (!ends_with(beginning, "^")) {
    return starts_with(header, beginning);
  }
  beginning.remove_suffix(1);
  return starts_with(header, beginning) && header.size() > beginning.size() &&
         std::isupper(static_cast<unsigned char>(header[beginning.size()])) != 0;
}

const LibraryRule* library_of(std::string_view header) {
  for (const LibraryRule& rule : library_rules()) {
    for (const std::string_view beginning : rule.headers) {
      if (is_headers(header, beginning)) {
        return &rule;
      }
    }
  }
  return nullptr;
}

bool may_include(const FolderRule& from, const FolderRule& to, std::string_view header) {
  if (from.folder == to.folder) {
    return true;
  }
  return std::any_of(from.may_include.begin(), from.may_include.end(), [&](std::string_view what) {
    return what == header || is_within(to.folder, what);
  });
}

std::string joined(const std::vector<std::string_view>& names) {
  return names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", "));
}

// Empty if the include is allowed.
std::string objection(const FolderRule& from, const Include& include) {
  const std::string name(include.header);
  const std::string folder(from.folder);
  if (include.quoted && starts_with(include.header, "/")) {
    return "includes " + name + " by an absolute path";
  }
  if (include.quoted && include.header.find("..") != std::string_view::npos) {
    return "includes " + name + ": a quoted include must stay within its folder";
  }
  if (const FolderRule* to = owner_of_header(include.header); to != nullptr) {
    if (may_include(from, *to, include.header)) {
      return {};
    }
    return folder + " may not include <" + name + "> of " + std::string(to->folder) +
           " (allowed: " + joined(from.may_include) + ")";
  }
  if (include.quoted) {
    return {};  // a private header beside the file
  }
  if (from.folder == "tests") {
    return {};  // any library and any test helper
  }
  if (const LibraryRule* library = library_of(include.header); library != nullptr) {
    if (is_within_any(include.file, library->folders)) {
      return {};
    }
    return std::string(library->library) + " (<" + name + ">) is allowed in " +
           joined(library->folders) + " only";
  }
  if (!is_standard_header(include.header)) {
    return "<" + name + "> is not in the table in tests/arch/rules.cpp";
  }
  if (is_freestanding(include.file) && !is_freestanding_header(include.header)) {
    return "<" + name + "> is not for firmware, which has no heap, exceptions, libm or clock";
  }
  return {};
}

using Graph = std::map<std::string_view, std::map<std::string_view, Include>>;

Graph folder_graph(const Tree& tree) {
  Graph graph;
  for (const Include& include : includes_of(tree)) {
    const FolderRule* from = rule_of(include.file);
    const FolderRule* to = owner_of_header(include.header);
    if (from == nullptr || to == nullptr || from == to) {
      continue;
    }
    graph[from->folder].emplace(to->folder, include);
  }
  return graph;
}

}  // namespace

Findings check_includes(const Tree& tree) {
  Findings findings;
  for (const Include& include : includes_of(tree)) {
    const FolderRule* from = rule_of(include.file);
    if (from == nullptr) {
      continue;  // check_layout reports the folder
    }
    const std::string broken_rule = objection(*from, include);
    if (!broken_rule.empty()) {
      findings.push_back({std::string(include.file), include.line, broken_rule});
    }
  }
  return findings;
}

Findings check_cycles(const Tree& tree) {
  const Graph graph = folder_graph(tree);
  Findings findings;
  std::set<std::string_view> finished;
  std::vector<std::string_view> path;
  const std::function<void(std::string_view)> visit = [&](std::string_view folder) {
    path.push_back(folder);
    const auto edges = graph.find(folder);
    if (edges != graph.end()) {
      for (const auto& [next, include] : edges->second) {
        const auto again = std::find(path.begin(), path.end(), next);
        if (again != path.end()) {
          std::vector<std::string_view> cycle(again, path.end());
          cycle.push_back(next);
          findings.push_back({std::string(include.file), include.line,
                              "closes a cycle between folders: " + joined(cycle)});
        } else if (finished.count(next) == 0) {
          visit(next);
        }
      }
    }
    path.pop_back();
    finished.insert(folder);
  };
  for (const auto& [folder, edges] : graph) {
    if (finished.count(folder) == 0) {
      visit(folder);
    }
  }
  return findings;
}

}  // namespace gsbench::arch
