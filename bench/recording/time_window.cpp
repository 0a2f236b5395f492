#include "time_window.hpp"

#include "shown.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

namespace gsbench::recording {
namespace {

constexpr const char* kFrom = "from_s";
constexpr const char* kUntil = "until_s";

// The format without its seconds, and without its time of day at the end; as far as it has them.
std::vector<std::string> shorter(const std::string& format) {
  std::vector<std::string> formats = {format};
  if (const std::size_t seconds = format.find(":%S"); seconds != std::string::npos) {
    formats.push_back(std::string(format).erase(seconds, 3));
  }
  const std::size_t hour = std::min(format.find("%H"), format.find("%I"));
  if (hour != std::string::npos && hour > 0) {
    formats.push_back(format.substr(0, format.find_last_not_of(" T", hour - 1) + 1));
  }
  return formats;
}

std::optional<Instant> limit(const char* key, const std::string& text, const std::string& format) {
  if (text.empty()) {
    return std::nullopt;
  }
  std::optional<Instant> instant;
  if (!format.empty()) {
    for (const std::string& one : shorter(format)) {
      instant = instant ? instant : parse_by_format(text, one);
    }
  }
  if (const std::optional<double> seconds = parse_number(text); !instant && seconds) {
    instant = instant_of_number(*seconds);
  }
  if (!instant) {
    instant = parse_date_and_time(text, Lacking::kSecondsOrTime);
  }
  if (!instant) {
    throw FormatError(key,
                      fmt::format("{} is `{}`; it must be seconds after the first row, or date "
                                  "and time {}, also without seconds, or a date",
                                  key, shown(text),
                                  format.empty() ? "such as `2025-04-28 11:00:02.5`"
                                                 : "as `" + shown(format) + '`'));
  }
  if (instant->kind == Instant::Kind::kSeconds && instant->whole_s < 0) {
    throw FormatError(
        key, fmt::format("{} is {}; it must be at least 0 s after the first row", key, text));
  }
  return instant;
}

double seconds_after(const Instant& first, const Instant& limit, const char* key,
                     const std::string& text) {
  using Kind = Instant::Kind;
  if (limit.kind == Kind::kSeconds) {
    return static_cast<double>(limit.whole_s) + limit.fraction_s;
  }
  if (first.kind == Kind::kSeconds) {
    throw FormatError(key, fmt::format("{} is `{}`, but the recording's times are numbers; give "
                                       "seconds after the first row",
                                       key, shown(text)));
  }
  if (limit.kind == Kind::kZoned && first.kind == Kind::kLocal) {
    throw FormatError(key, fmt::format("{} is `{}`, but the recording's times have no offset from "
                                       "UTC; omit it",
                                       key, shown(text)));
  }
  Instant same = limit;
  if (limit.kind == Kind::kLocal && first.kind == Kind::kZoned) {
    same.whole_s -= first.offset_s;
  }
  return same.seconds_since(first);
}

}  // namespace

TimeWindow::TimeWindow(const TraceFormat& format)
    : from_text_(format.from),
      until_text_(format.until),
      from_(limit(kFrom, format.from, format.time_format)),
      until_(limit(kUntil, format.until, format.time_format)) {
  if (is_relative(from_) && from_->whole_s == 0 && from_->fraction_s == 0.0) {
    from_.reset();
  }
}

void TimeWindow::start_at(const Instant& first) {
  first_ = first;
  if (from_) {
    from_s_ = seconds_after(first, *from_, kFrom, from_text_);
  }
  if (until_) {
    until_s_ = seconds_after(first, *until_, kUntil, until_text_);
  }
  if (until_s_ && *until_s_ <= from_s_.value_or(0.0)) {
    throw FormatError(kUntil, from_ ? fmt::format("until_s is {}; it must be above {}, the start",
                                                  shown(until_text_), shown(from_text_))
                                    : fmt::format("until_s is {}; it must be after the first row",
                                                  shown(until_text_)));
  }
}

bool TimeWindow::is_before(const Instant& instant) const {
  return from_s_ && instant.seconds_since(first_) < *from_s_;
}

bool TimeWindow::is_end(const Instant& instant) const {
  return until_s_ && instant.seconds_since(first_) == *until_s_;
}

bool TimeWindow::is_after(const Instant& instant) const {
  return until_s_ && instant.seconds_since(first_) > *until_s_;
}

}  // namespace gsbench::recording
