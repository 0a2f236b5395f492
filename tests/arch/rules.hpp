// Who may include whom. This table is the architecture; the CMake targets follow it, and the
// checks hold both to it.
#pragma once

#include <string_view>
#include <vector>

namespace gsbench::arch {

struct FolderRule {
  std::string_view folder;
  // Folders, each with all below it ("drivers"), or one header alone ("record/run_record.hpp").
  std::vector<std::string_view> may_include;
  // <root/…> where it is not the folder's own name: <drivers/result.hpp> of drivers/common.
  std::string_view include_root = folder.substr(folder.rfind('/') + 1);
};

// A library's headers and the folders (each with all below it) where they may appear; in tests/
// all may.
struct LibraryRule {
  std::string_view library;
  std::vector<std::string_view> headers;  // beginnings; "Q^" stands for Q and a capital letter
  std::vector<std::string_view> folders;
};

const std::vector<FolderRule>& folder_rules();
const std::vector<LibraryRule>& library_rules();

bool is_standard_header(std::string_view header);      // by its form: lower case, no dot
bool is_freestanding_header(std::string_view header);  // what freestanding code may use of them
// Firmware, but for the board that is a process of the host.
bool is_freestanding(std::string_view path);
bool may_stand_at_top_level(std::string_view entry);

// The table's folder a file is in; nullptr: in none.
const FolderRule* rule_of(std::string_view path);

// The table's folder that owns <grid/grid.hpp>: "bench/grid"; nullptr: not one of ours.
const FolderRule* owner_of_header(std::string_view header);

// Whether the table grants one folder another, or at least a header of it.
bool may_link(const FolderRule& from, const FolderRule& to);

bool is_within(std::string_view path, std::string_view folder);
bool is_within_any(std::string_view path, const std::vector<std::string_view>& folders);

}  // namespace gsbench::arch
