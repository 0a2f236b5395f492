// The repository's files as the checks see them; a test can make up a tree of its own.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gsbench::arch {

// Path relative to the root, '/' between folders → content; empty for what is not text.
using Tree = std::map<std::string, std::string>;

// All of root except what git ignores by .gitignore's two lines (build/, runs/) and hidden entries
// that are not ours. Throws std::filesystem::filesystem_error.
Tree read_tree(const std::string& root);

bool is_text(std::string_view path);        // source, script, configuration, documentation
bool is_cpp(std::string_view path);         // .cpp, .hpp, .c or .h
bool is_cpp_source(std::string_view path);  // .cpp or .c

bool is_word(char c);  // of letters, digits and '_'
bool starts_with(std::string_view text, std::string_view prefix);
bool ends_with(std::string_view text, std::string_view suffix);

std::string_view file_name(std::string_view path);
std::string_view folder_of(std::string_view path);  // "" for a file at the top
std::vector<std::string_view> lines_of(std::string_view text);

// The same text with comments, and what stands within string and character literals, replaced by
// spaces: lines and columns stay where they are.
std::string code_only(std::string_view text);

}  // namespace gsbench::arch
