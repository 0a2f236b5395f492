#include "checks.hpp"
#include "rules.hpp"

#include <array>
#include <ostream>

namespace gsbench::arch {
namespace {

bool has_token(std::string_view line, std::string_view token) {
  for (auto at = line.find(token); at != std::string_view::npos; at = line.find(token, at + 1)) {
    const auto end = at + token.size();
    if ((at == 0 || !is_identifier_char(line[at - 1])) &&
        (end == line.size() || !is_identifier_char(line[end]))) {
      return true;
    }
  }
  return false;
}

// `= delete` is not a deallocation.
bool is_deleted_function(std::string_view line) {
  const auto at = line.find("delete");
  const auto before = line.substr(0, at).find_last_not_of(" \t");
  return before != std::string_view::npos && line[before] == '=';
}

// True if an absolute path below `root` starts in the line; not within a relative path or a URL.
bool has_path_below(std::string_view line, std::string_view root) {
  for (auto at = line.find(root); at != std::string_view::npos; at = line.find(root, at + 1)) {
    constexpr std::string_view kGoesBefore = "_-./}~*";
    const char before = at == 0 ? ' ' : line[at - 1];
    if (!is_identifier_char(before) && kGoesBefore.find(before) == std::string_view::npos) {
      return true;
    }
  }
  return false;
}

// The literals are split so that this file passes its own check.
constexpr std::array<std::string_view, 3> kUnfinished = {
    "TO"
    "DO",
    "FIX"
    "ME",
    "XX"
    "X"};
constexpr std::array<std::string_view, 6> kMachinePaths = {
    "/"
    "home/",
    "/"
    "root/",
    "/"
    "work/",
    "/"
    "Users/",
    "/"
    "tmp/",
    "/"
    "mnt/"};

constexpr std::array<std::string_view, 13> kNotInFirmware = {
    "new", "delete", "malloc", "calloc",       "realloc", "free",    "throw",
    "try", "catch",  "typeid", "dynamic_cast", "float_t", "double_t"};

}  // namespace

std::ostream& operator<<(std::ostream& out, const Finding& finding) {
  out << finding.file;
  if (finding.line > 0) {
    out << ':' << finding.line;
  }
  return out << ": " << finding.broken_rule;
}

Findings check_firmware_keywords(const Tree& tree) {
  Findings findings;
  for (const auto& [path, text] : tree) {
    if (!is_cpp(path) || !is_within(path, "firmware")) {
      continue;
    }
    const std::string code = code_only(text);
    int number = 0;
    for (const std::string_view line : lines_of(code)) {
      ++number;
      for (const std::string_view token : kNotInFirmware) {
        if (!has_token(line, token) || (token == "delete" && is_deleted_function(line))) {
          continue;
        }
        findings.push_back({path, number, "no `" + std::string(token) + "` in firmware"});
      }
    }
  }
  return findings;
}

Findings check_text(const Tree& tree) {
  Findings findings;
  for (const auto& [path, text] : tree) {
    if (!is_text(path)) {
      continue;
    }
    const auto lines = lines_of(text);
    const auto count = static_cast<int>(lines.size());
    if (count > kLongestFile) {
      findings.push_back(
          {path, 0,
           std::to_string(count) + " lines; the limit is " + std::to_string(kLongestFile)});
    }
    for (int i = 0; i < count; ++i) {
      const std::string_view line = lines[static_cast<std::size_t>(i)];
      for (const std::string_view token : kUnfinished) {
        if (!has_token(line, token)) {
          continue;
        }
        findings.push_back(
            {path, i + 1, std::string(token) + ": finish the work or open an issue"});
      }
      for (const std::string_view root : kMachinePaths) {
        if (!has_path_below(line, root)) {
          continue;
        }
        findings.push_back({path, i + 1, std::string(root) + "…: an absolute path of one machine"});
      }
    }
  }
  return findings;
}

}  // namespace gsbench::arch
