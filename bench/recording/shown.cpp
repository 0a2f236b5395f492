#include "shown.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include <recording/trace.hpp>

namespace gsbench::recording {
namespace {

constexpr std::size_t kLongest = 60;

unsigned char byte_at(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

struct Character {
  std::size_t length = 0;  // bytes
  char32_t code = 0;
};

// The UTF-8 character at the start; length 0 if there is none.
Character first_character(std::string_view bytes) {
  const unsigned char first = byte_at(bytes, 0);
  if (first < 0x80) {
    return {1, first};
  }
  const std::size_t length = first >= 0xc2 && first <= 0xdf   ? 2
                             : first >= 0xe0 && first <= 0xef ? 3
                             : first >= 0xf0 && first <= 0xf4 ? 4
                                                              : 0;
  if (length == 0 || length > bytes.size()) {
    return {};
  }
  char32_t code = first & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(bytes, i) & 0xc0U) != 0x80) {
      return {};
    }
    code = (code << 6U) | (byte_at(bytes, i) & 0x3fU);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  const bool valid = code >= kLeast[length] && code <= 0x10ffff && !surrogate;
  return valid ? Character{length, code} : Character{};
}

// Its length if it can be printed, otherwise 0.
std::size_t printable_length(std::string_view bytes) {
  const Character character = first_character(bytes);
  const bool is_control =
      character.code < 0x20 || (character.code >= 0x7f && character.code < 0xa0);
  return is_control ? 0 : character.length;
}

bool is_unusual_blank_or_dash(char32_t code) {
  constexpr char32_t kOthers[] = {0xa0, 0x202f, 0x2060, 0x2212, 0x3000, 0xfeff};
  return (code >= 0x2000 && code <= 0x2015) ||
         std::find(std::begin(kOthers), std::end(kOthers), code) != std::end(kOthers);
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

std::string unusual_blank_or_dash(std::string_view text) {
  while (!text.empty()) {
    const Character character = first_character(text);
    if (is_unusual_blank_or_dash(character.code)) {
      return fmt::format("U+{:04X}", static_cast<std::uint32_t>(character.code));
    }
    text.remove_prefix(std::max<std::size_t>(character.length, 1));
  }
  return "";
}

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t length = first_character(bytes).length;
    if (length == 0) {
      return false;
    }
    bytes.remove_prefix(length);
  }
  return true;
}

}  // namespace gsbench::recording
