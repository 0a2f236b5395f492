// Reads the rows of a recording one by one, and checks those of the played part against the
// previous ones.
#pragma once

#include "csv.hpp"
#include "dialect.hpp"
#include "instant.hpp"
#include "time_window.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <recording/trace.hpp>

namespace gsbench::recording {

class TraceReader {
 public:
  // `text` and `format` must outlive this. Throws CsvError or FormatError, as trace() does.
  TraceReader(std::string_view text, const TraceFormat& format, const TraceLimits& limits);

  // Once. Voltages are still in the column's unit.
  Trace trace();

  // Position for errors of the voltage column as a whole.
  Place voltage_place() const;

 private:
  using Row = std::vector<Cell>;
  // Of the row that was read last, in the window. At its end: exactly, so that it may end there.
  enum class Where { kBefore, kInside, kAtTheEnd, kAfter };

  void read_header();
  [[noreturn]] void refuse_header(std::size_t row) const;
  void check_is_header() const;
  std::string option(const char* key) const;  // its name, in advice
  // The next row may have any content: it is outside the window, or may be.
  bool tolerates_flaws() const { return where_ != Where::kInside; }
  bool reached_duration() const;
  bool next(Row& row);
  bool leaves_the_window(const Row& row);
  const Cell& cell(const Row& row, std::size_t column) const;
  std::optional<Instant> instant_of(const Row& row);
  [[noreturn]] void refuse_time(const Cell& time) const;
  void take_gap();
  bool is_played(const Instant& instant, const Row& row);
  void take(const Instant& instant, const Row& row);
  double number_in(const Cell& cell) const;
  double frequency_in(const Cell& cell) const;
  double voltage_in(const Cell& cell) const;
  [[noreturn]] void refuse_too_few() const;
  void check_length() const;

  const TraceFormat& format_;
  TraceLimits limits_;
  Dialect dialect_;
  CsvReader csv_;
  TimeWindow window_;
  Row header_;  // empty without one
  std::size_t time_ = 0;
  std::size_t frequency_ = 0;
  std::optional<std::size_t> voltage_;
  std::optional<Instant> first_;  // of the recording
  std::string_view first_row_;
  Cell first_time_;  // the first time of the recording, and the last one that was read
  Cell read_time_;
  std::optional<Instant> start_;  // of the first point
  std::optional<Instant> last_;   // of the row that was taken last
  Place last_place_;
  Where where_;
  Place left_at_;  // if after: the row that ended the window
  Trace trace_;
};

}  // namespace gsbench::recording
