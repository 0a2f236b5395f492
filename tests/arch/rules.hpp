// The architecture: which folder may include which. The checks compare the includes and the CMake
// targets with this table.
#pragma once

#include <string_view>
#include <vector>

namespace gsbench::arch {

struct FolderRule {
  std::string_view folder;
  // Folders with their subfolders ("drivers"), or a single header ("record/run_record.hpp").
  std::vector<std::string_view> may_include;
  // <root/…> if it is not the folder's name: <drivers/result.hpp> of drivers/common.
  std::string_view include_root = folder.substr(folder.rfind('/') + 1);
};

// A library's headers and the folders, with their subfolders, that may include them. tests/ may
// include all.
struct LibraryRule {
  std::string_view library;
  std::vector<std::string_view> headers;  // prefixes; "Q^" is Q and a capital letter
  std::vector<std::string_view> folders;
};

const std::vector<FolderRule>& folder_rules();
const std::vector<LibraryRule>& library_rules();

bool is_standard_header(std::string_view header);      // recognised by its form: lower case, no dot
bool is_freestanding_header(std::string_view header);  // allowed in freestanding code
// Firmware, except for the board that runs as a process of the host.
bool is_freestanding(std::string_view path);
bool may_stand_at_top_level(std::string_view entry);

// The row of the folder that contains a file; nullptr if there is none.
const FolderRule* rule_of(std::string_view path);

// The row of the folder that owns a header (<grid/grid.hpp>: "bench/grid"); nullptr if not ours.
const FolderRule* owner_of_header(std::string_view header);

// True if the table allows `from` to include `to` or at least one of its headers.
bool may_link(const FolderRule& from, const FolderRule& to);

bool is_within(std::string_view path, std::string_view folder);
bool is_within_any(std::string_view path, const std::vector<std::string_view>& folders);

}  // namespace gsbench::arch
