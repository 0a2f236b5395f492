#pragma once

#include <string>
#include <string_view>

namespace gsbench::recording {

// Bytes of a file for a message: control characters and bytes that are not UTF-8 as \xNN, at most
// 60 bytes, then "…".
std::string shown(std::string_view bytes);

// The first space or dash of the text that is not ASCII, as "U+00A0"; empty: none.
std::string unusual_blank_or_dash(std::string_view text);

}  // namespace gsbench::recording
