// The checks themselves: each takes a tree and says what breaks a rule, and where.
#pragma once

#include "tree.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace gsbench::arch {

struct Finding {
  std::string file;
  int line = 0;  // from 1; 0: the file or folder as a whole
  std::string broken_rule;
};
std::ostream& operator<<(std::ostream& out, const Finding& finding);  // file:line: rule
using Findings = std::vector<Finding>;

// Every #include is of a folder, library or standard header that its folder may include.
Findings check_includes(const Tree& tree);
// What folders really include makes no cycle (drivers may include each other by the table).
Findings check_cycles(const Tree& tree);
// What a folder's CMakeLists.txt names is only targets whose folder, or a header of it, it may
// include.
Findings check_links(const Tree& tree);
// No heap, no exceptions, no run-time types in firmware/.
Findings check_firmware_words(const Tree& tree);
// No file over kLongestFile lines, no note of work left undone, no path of somebody's machine.
Findings check_text(const Tree& tree);
// The top level holds what it may; each folder with code is in the table and has its CMake target,
// and each source is named in it.
Findings check_layout(const Tree& tree);

inline constexpr int kLongestFile = 500;

}  // namespace gsbench::arch
