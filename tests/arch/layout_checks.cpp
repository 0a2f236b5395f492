#include "checks.hpp"
#include "rules.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace gsbench::arch {
namespace {

const std::string* find_text(const Tree& tree, const std::string& path) {
  const auto found = tree.find(path);
  return found == tree.end() ? nullptr : &found->second;
}

// The nearest folder with a CMakeLists.txt, from `folder` up to `top`; empty if there is none.
std::string cmake_folder_of(const Tree& tree, std::string_view folder, std::string_view top) {
  while (is_within(folder, top)) {
    std::string here(folder);
    if (find_text(tree, here + "/CMakeLists.txt") != nullptr) {
      return here;
    }
    folder = folder_of(folder);
  }
  return {};
}

bool declares_target(const std::string& cmake, const std::string& target) {
  constexpr std::array<std::string_view, 3> kCommands = {"gs_library", "add_library",
                                                         "add_executable"};
  return std::any_of(kCommands.begin(), kCommands.end(), [&](std::string_view command) {
    const std::string call = std::string(command) + "(";
    for (auto at = cmake.find(call); at != std::string::npos; at = cmake.find(call, at + 1)) {
      const auto name = cmake.find_first_not_of(" \t\n", at + call.size());
      const auto end = cmake.find_first_of(" \t\n)", name);
      if (name != std::string::npos && cmake.substr(name, end - name) == target) {
        return true;
      }
    }
    return false;
  });
}

// "bench/grid" → "bench_grid"; the program has its own name.
std::string target_of(std::string_view folder) {
  if (folder == "bench/cli") {
    return "gsbench";
  }
  std::string name(folder);
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

std::vector<std::string_view> tokens_of(std::string_view cmake_line) {
  constexpr std::string_view kBetween = " \t()\"";
  cmake_line = cmake_line.substr(0, cmake_line.find('#'));
  std::vector<std::string_view> tokens;
  for (auto at = cmake_line.find_first_not_of(kBetween); at != std::string_view::npos;) {
    const auto end = std::min(cmake_line.find_first_of(kBetween, at), cmake_line.size());
    tokens.push_back(cmake_line.substr(at, end - at));
    at = cmake_line.find_first_not_of(kBetween, end);
  }
  return tokens;
}

void check_top_level(const Tree& tree, Findings& findings) {
  std::set<std::string_view> entries;
  for (const auto& file : tree) {
    entries.insert(std::string_view(file.first).substr(0, file.first.find('/')));
  }
  for (const std::string_view entry : entries) {
    if (may_stand_at_top_level(entry)) {
      continue;
    }
    findings.push_back({std::string(entry), 0, "is not allowed at the top level"});
  }
}

void check_source(const Tree& tree, const std::string& path, std::string_view top,
                  Findings& findings) {
  const std::string folder = cmake_folder_of(tree, folder_of(path), top);
  if (folder.empty()) {
    findings.push_back({path, 0, "is built by no CMakeLists.txt"});
    return;
  }
  const std::string below = path.substr(folder.size() + 1);
  if (is_cpp_source(path) &&
      find_text(tree, folder + "/CMakeLists.txt")->find(below) == std::string::npos) {
    findings.push_back({path, 0, "is not named in " + folder + "/CMakeLists.txt"});
  }
}

}  // namespace

Findings check_links(const Tree& tree) {
  Findings findings;
  for (const auto& [path, text] : tree) {
    const FolderRule* from = rule_of(path);
    if (from == nullptr || file_name(path) != "CMakeLists.txt") {
      continue;
    }
    int number = 0;
    for (const std::string_view line : lines_of(text)) {
      ++number;
      for (const std::string_view token : tokens_of(line)) {
        for (const FolderRule& to : folder_rules()) {
          if (token != target_of(to.folder) || may_link(*from, to)) {
            continue;
          }
          findings.push_back(
              {path, number, std::string(from->folder) + " may not link " + std::string(token)});
        }
      }
    }
  }
  return findings;
}

Findings check_layout(const Tree& tree) {
  Findings findings;
  check_top_level(tree, findings);
  std::set<std::string_view> with_code;
  for (const auto& file : tree) {
    const std::string& path = file.first;
    if (!is_cpp(path)) {
      continue;
    }
    const FolderRule* rule = rule_of(path);
    if (rule == nullptr) {
      findings.push_back({path, 0, "its folder is not in the table in tests/arch/rules.cpp"});
      continue;
    }
    with_code.insert(rule->folder);
    check_source(tree, path, rule->folder, findings);
  }
  for (const std::string_view folder : with_code) {
    if (folder == "tests") {
      continue;  // many programs; check_source checks each source
    }
    const std::string* cmake = find_text(tree, std::string(folder) + "/CMakeLists.txt");
    if (cmake == nullptr || !declares_target(*cmake, target_of(folder))) {
      findings.push_back({std::string(folder), 0, "has code but no target " + target_of(folder)});
    }
  }
  return findings;
}

}  // namespace gsbench::arch
