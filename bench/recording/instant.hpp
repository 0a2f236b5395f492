// Parses numbers and times of recordings, independently of the locale.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gsbench::recording {

// Returns the number if the whole text is a finite number, otherwise nullopt. A plus sign may
// precede it.
inline std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

struct Instant {
  // Only instants of the same kind can be compared.
  enum class Kind { kSeconds, kLocal, kZoned };

  Kind kind = Kind::kSeconds;
  std::int64_t whole_s = 0;   // since an origin that depends on the kind
  double fraction_s = 0.0;    // in [0, 1)
  std::int64_t offset_s = 0;  // of a zoned instant: local time less UTC

  double seconds_since(const Instant& start) const {
    return static_cast<double>(whole_s - start.whole_s) + (fraction_s - start.fraction_s);
  }
};

// nullopt beyond ± 10¹⁵ s.
std::optional<Instant> instant_of_number(double seconds);

// Digits that a time of the kind below may lack.
enum class Lacking { kNothing, kSecondsOrTime };

// Accepts "28-Apr-2025 11:00:02" · "2025-04-28 11:00:02.5" · "2025-04-28T11:00:02Z" or with an
// offset such as "+02:00"; if permitted, also "2025-04-28 11:00", and "2025-04-28" as its midnight.
// nullopt for other texts and for times that do not exist.
std::optional<Instant> parse_date_and_time(std::string_view text,
                                           Lacking lacking = Lacking::kNothing);

// A time by a format with kTimeDirectives. A date or time of day that the format lacks is 1 January
// 1970 or midnight.
std::optional<Instant> parse_by_format(std::string_view text, const std::string& format);
// The first directive of the format that is unknown; empty: all are known.
std::string unknown_directive(const std::string& format);

}  // namespace gsbench::recording
