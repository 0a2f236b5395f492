// The part of a recording to play, as instants of its time column.
#pragma once

#include "instant.hpp"

#include <optional>
#include <string>

#include <recording/trace.hpp>

namespace gsbench::recording {

class TimeWindow {
 public:
  // Throws FormatError if `from` or `until` is neither seconds nor date and time.
  explicit TimeWindow(const TraceFormat& format);

  // True if rows may precede the window.
  bool has_start() const { return from_.has_value(); }
  bool counts_from_first_row() const { return is_relative(from_) || is_relative(until_); }
  // True if the limits depend on the first row: on its time, or on its offset from UTC. After
  // start_at().
  bool needs_first_row() const {
    return counts_from_first_row() ||
           (first_.kind == Instant::Kind::kZoned && (is_local(from_) || is_local(until_)));
  }

  // `first`: the first instant of the recording. To be called before the functions below. Throws
  // FormatError if a limit cannot be compared with it, or if `until` is not after `from`.
  void start_at(const Instant& first);
  bool is_before(const Instant& instant) const;  // before the start
  bool is_after(const Instant& instant) const;   // after the end
  bool is_end(const Instant& instant) const;     // exactly at the end

 private:
  static bool is_relative(const std::optional<Instant>& limit) {
    return limit && limit->kind == Instant::Kind::kSeconds;
  }

  static bool is_local(const std::optional<Instant>& limit) {
    return limit && limit->kind == Instant::Kind::kLocal;
  }

  std::string from_text_;
  std::string until_text_;
  std::optional<Instant> from_;
  std::optional<Instant> until_;
  Instant first_;
  std::optional<double> from_s_;  // after the first instant
  std::optional<double> until_s_;
};

}  // namespace gsbench::recording
