#include "trace_reader.hpp"

#include "columns.hpp"
#include "shown.hpp"
#include "text_check.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsbench::recording {
namespace {

// The slope of the frequency must be a finite number.
constexpr double kLeastStep_s = 1e-12;

// What cannot be seen in a text that is no number.
std::string unusual_in(const std::string& text) {
  if (text.find('\0') != std::string::npos) {
    return ", it has NUL bytes";
  }
  const std::string character = unusual_blank_or_dash(text);
  return character.empty() ? "" : ", it has the character " + character;
}

}  // namespace

TraceReader::TraceReader(std::string_view text, const TraceFormat& format,
                         const TraceLimits& limits)
    : format_(format),
      limits_(limits),
      dialect_(format, limits.nominal_hz),
      csv_(text, dialect_.delimiter()),
      window_(format),
      where_(window_.has_start() ? Where::kBefore : Where::kInside) {
  check_is_text(text);
  read_header();
  trace_.text = csv_.text_so_far();
}

void TraceReader::read_header() {
  for (std::size_t i = 0; i < dialect_.skip_rows(); ++i) {
    csv_.skip_line();
  }
  Row row;
  for (std::size_t i = 0; i < dialect_.header_rows(); ++i) {
    if (!csv_.next(row)) {
      refuse_header(i);
    }
    if (i == 0) {
      header_ = row;
    }
  }
  const std::string advice = option("skip_rows") + " skips lines above the names";
  time_ = column_of("time", format_.time, header_, advice);
  frequency_ = column_of("frequency", format_.frequency, header_, advice);
  if (!format_.voltage.empty()) {
    voltage_ = column_of("voltage", format_.voltage, header_, advice);
  }
  if (!header_.empty()) {
    check_is_header();
  }
}

// The file ends before header row `row`, from 0.
void TraceReader::refuse_header(std::size_t row) const {
  const std::size_t skipped = dialect_.skip_rows();
  throw CsvError(csv_.row_end(),
                 row > 0 ? fmt::format("the file ends within the {} rows above the data ({})",
                                       dialect_.header_rows(), option("header_rows"))
                 : skipped > 0
                     ? fmt::format("no row follows the {} line{} that {} skips; a row of column "
                                   "names must",
                                   skipped, skipped == 1 ? "" : "s", option("skip_rows"))
                     : "the file is empty; it must start with a row of column names");
}

std::string TraceReader::option(const char* key) const {
  return limits_.option_name != nullptr ? limits_.option_name(key) : key;
}

// Without this, a file without a header would lose its first row.
void TraceReader::check_is_header() const {
  const std::string& time = header_.at(time_).text;
  if (dialect_.instant(time) && time != format_.time &&
      dialect_.number(header_.at(frequency_).text) &&
      header_.at(frequency_).text != format_.frequency) {
    throw CsvError(header_[time_].place,
                   fmt::format("this row has values, but the names of the columns are expected; "
                               "for a file without them, {} must be 0",
                               option("header_rows")));
  }
}

Trace TraceReader::trace() {
  Row row;
  while (!reached_duration() && next(row)) {
    const std::optional<Instant> instant = instant_of(row);
    if (instant && is_played(*instant, row)) {
      take(*instant, row);
    }
  }
  if (trace_.points.size() < 2) {
    refuse_too_few();
  }
  check_length();
  return std::move(trace_);
}

Place TraceReader::voltage_place() const {
  return header_.empty() ? Place{} : header_[*voltage_].place;
}

bool TraceReader::reached_duration() const {
  return !trace_.points.empty() && trace_.points.back().t_s >= limits_.duration_s;
}

bool TraceReader::next(Row& row) {
  while (true) {
    try {
      return csv_.next(row);
    } catch (const CsvError&) {
      // Rows outside the window may have any content.
      if (!tolerates_flaws() && !leaves_the_window(row)) {
        throw;
      }
      csv_.skip_failed_row();
    }
  }
}

// For a row of which only the cells before a mistake are known.
bool TraceReader::leaves_the_window(const Row& row) {
  if (!last_ || time_ >= row.size()) {
    return false;
  }
  const std::optional<Instant> instant = dialect_.instant(row[time_].text);
  if (!instant || instant->kind != first_->kind || !window_.is_after(*instant)) {
    return false;
  }
  where_ = Where::kAfter;
  left_at_ = row[time_].place;
  return true;
}

const Cell& TraceReader::cell(const Row& row, std::size_t column) const {
  if (column < row.size()) {
    return row[column];
  }
  throw CsvError(
      csv_.row_end(),
      fmt::format(
          "the row has {} cell{}; it must have at least {}{}", row.size(),
          row.size() == 1 ? "" : "s", column + 1,
          header_.empty() ? "" : fmt::format(", up to column `{}`", shown(header_[column].text))));
}

// nullopt: a row without a time, which is outside the window or a gap.
std::optional<Instant> TraceReader::instant_of(const Row& row) {
  if (tolerates_flaws() && time_ >= row.size()) {
    return std::nullopt;
  }
  const Cell& time = cell(row, time_);
  const std::optional<Instant> instant = dialect_.instant(time.text);
  if (instant && !first_) {
    first_ = instant;
    first_row_ = csv_.row_text();
    first_time_ = time;
    window_.start_at(*first_);
  }
  if (instant && instant->kind == first_->kind) {
    read_time_ = time;
    return instant;
  }
  if (tolerates_flaws()) {
    return std::nullopt;
  }
  if (dialect_.is_gap(time.text)) {
    take_gap();
    return std::nullopt;
  }
  if (instant) {
    throw CsvError(
        time.place,
        fmt::format("time `{}` has another format than the first; all must have the same",
                    shown(time.text)));
  }
  refuse_time(time);
}

void TraceReader::refuse_time(const Cell& time) const {
  const std::string what = '`' + shown(time.text) + '`';
  const std::string heading =
      first_ ? ""
             : fmt::format("; if this is a heading, {} counts the rows above the data",
                           option("header_rows"));
  if (!format_.time_format.empty()) {
    throw CsvError(time.place, fmt::format("{} is not a time{}; it must be as {}, `{}`{}", what,
                                           unusual_in(time.text), option("time_format"),
                                           shown(format_.time_format), heading));
  }
  if (dialect_.number(time.text)) {
    throw CsvError(time.place, fmt::format("{} is beyond 10¹⁵ s; {} gives another unit, such as ns",
                                           what, option("time_unit")));
  }
  throw CsvError(
      time.place,
      fmt::format("{} is not a time{}; it must be a number, `28-Apr-2025 11:00:02`, "
                  "`2025-04-28 11:00:02.5` or `2025-04-28T11:00:02Z`{}; {} gives another format{}",
                  what, unusual_in(time.text),
                  time.text.find(":59:60") != std::string::npos ? " (a second 60 is not read)" : "",
                  option("time_format"), heading));
}

bool TraceReader::is_played(const Instant& instant, const Row& row) {
  const bool inside = !window_.is_before(instant) && !window_.is_after(instant);
  if (!last_) {
    return inside;
  }
  const double step_s = instant.seconds_since(*last_);
  const bool later = step_s >= kLeastStep_s;
  if (where_ == Where::kAfter) {
    if (inside && later) {
      throw CsvError(left_at_, fmt::format("this time is after the end of the played part, but "
                                           "line {} is within it; times must increase",
                                           row[time_].place.line));
    }
    return false;
  }
  if (!later && where_ == Where::kAtTheEnd && last_->seconds_since(instant) > 0.0) {
    return false;
  }
  if (!later) {
    throw CsvError(row[time_].place,
                   fmt::format("time `{}` is not later than in the previous row; times must "
                               "increase{}",
                               shown(row[time_].text), step_s > 0.0 ? " by at least 1 ps" : ""));
  }
  if (!inside) {
    where_ = Where::kAfter;
    left_at_ = row[time_].place;
  }
  return inside;
}

void TraceReader::take_gap() {
  trace_.text += csv_.row_text();
  ++trace_.rows;
  ++trace_.gaps;
}

void TraceReader::take(const Instant& instant, const Row& row) {
  if (!last_ && window_.needs_first_row() && first_row_.data() != csv_.row_text().data()) {
    trace_.text += first_row_;
  }
  last_ = instant;
  last_place_ = row[time_].place;
  where_ = window_.is_end(instant) ? Where::kAtTheEnd : Where::kInside;
  trace_.text += csv_.row_text();
  ++trace_.rows;
  const Cell& frequency = cell(row, frequency_);
  const Cell* voltage = voltage_ ? &cell(row, *voltage_) : nullptr;
  if (dialect_.is_gap(frequency.text) || (voltage != nullptr && dialect_.is_gap(voltage->text))) {
    ++trace_.gaps;
    return;
  }
  if (!start_) {
    start_ = instant;
  }
  trace_.points.push_back({instant.seconds_since(*start_), frequency_in(frequency),
                           voltage != nullptr ? voltage_in(*voltage) : 1.0});
  if (voltage != nullptr) {
    trace_.voltage_at.push_back(voltage->place);
  }
}

double TraceReader::number_in(const Cell& cell) const {
  const std::optional<double> number = dialect_.number(cell.text);
  if (!number) {
    throw CsvError(cell.place,
                   fmt::format("`{}` is not a finite number{}; it must be one, or empty or `NaN` "
                               "for a gap; {} gives further words",
                               shown(cell.text), unusual_in(cell.text), option("gaps")));
  }
  return *number;
}

double TraceReader::frequency_in(const Cell& cell) const {
  const double frequency_hz = dialect_.frequency_hz(number_in(cell));
  if (frequency_hz > 0.0 && frequency_hz >= limits_.lowest_hz &&
      frequency_hz <= limits_.highest_hz) {
    return frequency_hz;
  }
  const std::string wanted =
      std::isfinite(limits_.highest_hz)
          ? fmt::format("{} … {} Hz (0.5 … 1.5 of nominal)", limits_.lowest_hz, limits_.highest_hz)
          : "above 0";
  throw CsvError(
      cell.place,
      fmt::format("the frequency is {} Hz; it must be {}; {} and {} give another unit and "
                  "deviations",
                  frequency_hz, wanted, option("frequency_unit"), option("frequency_offset_hz")));
}

double TraceReader::voltage_in(const Cell& cell) const {
  const double voltage = number_in(cell);
  if (voltage < 0.0) {
    throw CsvError(cell.place,
                   fmt::format("the RMS voltage is {}; it must be at least 0", voltage));
  }
  return voltage;
}

void TraceReader::refuse_too_few() const {
  if (!format_.from.empty() || !format_.until.empty()) {
    const char* key = format_.from.empty() ? "until_s" : "from_s";
    throw FormatError(
        key, first_ ? fmt::format("{} leaves fewer than two rows to play; the times of the file "
                                  "are `{}` (line {}, column {}) … `{}` (line {}, column {}){}",
                                  key, shown(first_time_.text), first_time_.place.line,
                                  first_time_.place.column, shown(read_time_.text),
                                  read_time_.place.line, read_time_.place.column,
                                  window_.counts_from_first_row()
                                      ? ", and numbers are seconds after the first row"
                                      : "")
                    : fmt::format("{} leaves no row to play; the file has no times", key));
  }
  throw CsvError(csv_.row_end(),
                 trace_.rows > 0 ? "fewer than two rows have values; at least two are needed"
                 : header_.empty()
                     ? "no data; at least two rows are needed"
                     : "no data below the column names; at least two rows are needed");
}

void TraceReader::check_length() const {
  const double length_s = trace_.points.back().t_s;
  const bool is_short = length_s < limits_.shortest_s;
  if (is_short || length_s > limits_.longest_s) {
    throw CsvError(last_place_, fmt::format("the recording is {} s long; it must be at {} {} s",
                                            length_s, is_short ? "least" : "most",
                                            is_short ? limits_.shortest_s : limits_.longest_s));
  }
}

}  // namespace gsbench::recording
