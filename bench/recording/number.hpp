// Numbers in text, the same in every locale.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace gsbench::recording {

// The whole text as a finite number.
inline std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace gsbench::recording
