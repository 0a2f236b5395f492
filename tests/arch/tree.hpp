// The files of the repository, as input of the checks. Tests can create artificial trees.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gsbench::arch {

// Path relative to the root, with '/', → content; the content is empty for files that are not text.
using Tree = std::map<std::string, std::string>;

// All files below `root`, without build/, runs/ and foreign hidden entries. Throws
// std::filesystem::filesystem_error.
Tree read_tree(const std::string& root);

bool is_text(std::string_view path);        // source, script, configuration, documentation
bool is_cpp(std::string_view path);         // .cpp, .hpp, .c or .h
bool is_cpp_source(std::string_view path);  // .cpp or .c

bool is_identifier_char(char c);  // letter, digit or '_'
bool starts_with(std::string_view text, std::string_view prefix);
bool ends_with(std::string_view text, std::string_view suffix);

std::string_view file_name(std::string_view path);
std::string_view folder_of(std::string_view path);  // "" for a file at the top
std::vector<std::string_view> lines_of(std::string_view text);

// The same text with comments and the contents of string and character literals replaced by spaces.
// Lines and columns do not move.
std::string code_only(std::string_view text);

}  // namespace gsbench::arch
