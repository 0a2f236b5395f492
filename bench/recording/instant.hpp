// Numbers and points in time as recordings write them, the same in every locale.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

namespace gsbench::recording {

// The whole text as a finite number.
inline std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

struct Instant {
  // Only instants of one kind can be compared.
  enum class Kind { kSeconds, kLocal, kZoned };

  Kind kind = Kind::kSeconds;
  std::int64_t whole_s = 0;  // since an origin of the kind's own
  double fraction_s = 0.0;   // in [0, 1)

  double seconds_since(const Instant& start) const {
    return static_cast<double>(whole_s - start.whole_s) + (fraction_s - start.fraction_s);
  }
};

// "12.5" · "28-Apr-2025 11:00:02" · "2025-04-28 11:00:02.5" · "2025-04-28T11:00:02Z" or with an
// offset such as "+02:00". Nothing where the text is none of them, or no such time exists.
std::optional<Instant> parse_instant(std::string_view text);

}  // namespace gsbench::recording
