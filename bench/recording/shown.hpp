#pragma once

#include <string>
#include <string_view>

namespace gsbench::recording {

// Bytes of a file for a message: control characters and bytes that are not UTF-8 as \xNN, at most
// 60 bytes, then "…".
std::string shown(std::string_view bytes);

}  // namespace gsbench::recording
