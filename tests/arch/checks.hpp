// The checks. Each takes a tree and returns its violations of a rule, with their places.
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

// Each #include must be of a folder, a library or a standard header that is allowed there.
Findings check_includes(const Tree& tree);
// The actual includes must not form a cycle between folders (the table alone would allow one).
Findings check_cycles(const Tree& tree);
// A folder's CMakeLists.txt may link only targets whose folder, or one header of it, is allowed.
Findings check_links(const Tree& tree);
// No heap, exceptions or run-time type information in firmware/.
Findings check_firmware_keywords(const Tree& tree);
// No file over kLongestFile lines, no notes of unfinished work, no absolute paths of a machine.
Findings check_text(const Tree& tree);
// The top level has only allowed entries. Each folder with code is in the table and has its CMake
// target, and each source is listed in a CMakeLists.txt.
Findings check_layout(const Tree& tree);

inline constexpr int kLongestFile = 500;

}  // namespace gsbench::arch
