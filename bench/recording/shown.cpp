#include "shown.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include <recording/trace.hpp>

namespace gsbench::recording {
namespace {

constexpr std::size_t kLongest = 60;

unsigned char byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

// Length of the UTF-8 character at the start; 0 if there is none.
std::size_t character_length(std::string_view bytes) {
  const unsigned char first = byte_at(bytes, 0);
  if (first < 0x80) {
    return 1;
  }
  const std::size_t length = first >= 0xc2 && first <= 0xdf   ? 2
                             : first >= 0xe0 && first <= 0xef ? 3
                             : first >= 0xf0 && first <= 0xf4 ? 4
                                                              : 0;
  if (length == 0 || length > bytes.size()) {
    return 0;
  }
  char32_t code = first & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(bytes, i) & 0xc0U) != 0x80) {
      return 0;
    }
    code = (code << 6U) | (byte_at(bytes, i) & 0x3fU);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code >= kLeast[length] && code <= 0x10ffff && !surrogate ? length : 0;
}

// The same for a printable character.
std::size_t printable_length(std::string_view bytes) {
  const unsigned char first = byte_at(bytes, 0);
  const std::size_t length = character_length(bytes);
  const bool is_control = length == 1 ? first < 0x20 || first == 0x7f
                                      : length == 2 && first == 0xc2 && byte_at(bytes, 1) < 0xa0;
  return is_control ? 0 : length;
}

}  // namespace

std::string shown(std::string_view bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size();) {
    if (text.size() >= kLongest) {
      return text + "…";
    }
    const std::size_t length = printable_length(bytes.substr(i));
    text += length > 0 ? std::string(bytes.substr(i, length))
                       : fmt::format("\\x{:02x}", byte_at(bytes, i));
    i += std::max<std::size_t>(length, 1);
  }
  return text;
}

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length == 0) {
      return false;
    }
    bytes.remove_prefix(length);
  }
  return true;
}

}  // namespace gsbench::recording
