#include "csv.hpp"
#include "instant.hpp"
#include "shown.hpp"
#include "time_window.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <recording/trace.hpp>

namespace gsbench::recording {
namespace {

using Row = std::vector<Cell>;

std::string column_list(const Row& header) {
  std::string list;
  for (const Cell& cell : header) {
    list += (list.empty() ? "`" : ", `") + shown(cell.text) + '`';
  }
  return list;
}

std::size_t column_of(const std::string& name, const Row& header) {
  const auto is_it = [&name](const Cell& cell) { return cell.text == name; };
  const auto found = std::find_if(header.begin(), header.end(), is_it);
  if (found == header.end()) {
    throw CsvError(header.front().place, fmt::format("no column `{}`; the columns are {}",
                                                     shown(name), column_list(header)));
  }
  const auto again = std::find_if(found + 1, header.end(), is_it);
  if (again != header.end()) {
    throw CsvError(again->place,
                   fmt::format("a second column `{}`; the name must be unique", shown(name)));
  }
  return static_cast<std::size_t>(found - header.begin());
}

double number_in(const Cell& cell) {
  const std::optional<double> number = parse_number(cell.text);
  if (!number) {
    throw CsvError(cell.place, fmt::format("`{}` is not a finite number; it must be one, or empty "
                                           "or `NaN` for a gap",
                                           shown(cell.text)));
  }
  return *number;
}

// Recorders mark missing measurements like this.
bool is_gap(const Cell& cell) {
  std::string word = cell.text;
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word.empty() || word == "nan" || word == "na" || word == "null";
}

// Reads the rows one by one and checks those of the played part against the previous ones.
class TraceReader {
 public:
  TraceReader(std::string_view text, const TraceFormat& format, const TraceLimits& limits)
      : format_(format), limits_(limits), csv_(text), window_(format) {
    if (!csv_.next(header_)) {
      throw CsvError({}, "the file is empty; it must start with a row of column names");
    }
    time_ = column_of(format.time, header_);
    frequency_ = column_of(format.frequency, header_);
    if (!format.voltage.empty()) {
      voltage_ = column_of(format.voltage, header_);
    }
    trace_.text = csv_.text_so_far();
  }

  // Voltages still in the column's unit.
  Trace trace() {
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

  // Position for errors of the voltage column as a whole.
  Place voltage_place() const { return header_[*voltage_].place; }

 private:
  // Rows outside the window may have any content.
  bool is_outside() const { return (window_.has_start() && !last_) || left_at_; }

  bool reached_duration() const {
    return !trace_.points.empty() && trace_.points.back().t_s >= limits_.duration_s;
  }

  bool next(Row& row) {
    while (true) {
      try {
        return csv_.next(row);
      } catch (const CsvError&) {
        if (!is_outside() && !is_after_the_window(row)) {
          throw;
        }
        csv_.skip_failed_row();
      }
    }
  }

  // For a row of which only the cells before a mistake are known.
  bool is_after_the_window(const Row& row) {
    if (!last_ || time_ >= row.size()) {
      return false;
    }
    const std::optional<Instant> instant = parse_instant(row[time_].text);
    if (!instant || instant->kind != first_->kind || !window_.is_after(*instant)) {
      return false;
    }
    left_at_ = row[time_].place;
    return true;
  }

  const Cell& cell(const Row& row, std::size_t column) const {
    if (column < row.size()) {
      return row[column];
    }
    throw CsvError(csv_.row_end(),
                   fmt::format("the row has {} cells; it must have at least {}, up to column `{}`",
                               row.size(), column + 1, shown(header_[column].text)));
  }

  // nullopt: a row outside the window without a time.
  std::optional<Instant> instant_of(const Row& row) {
    if (is_outside() && time_ >= row.size()) {
      return std::nullopt;
    }
    const Cell& time = cell(row, time_);
    const std::optional<Instant> instant = parse_instant(time.text);
    if (instant && !first_) {
      first_ = instant;
      first_row_ = csv_.row_text();
      window_.start_at(*first_);
    }
    if (instant && instant->kind == first_->kind) {
      return instant;
    }
    if (is_outside()) {
      return std::nullopt;
    }
    throw CsvError(
        time.place,
        instant ? fmt::format("time `{}` has another format than the first; all must have the same",
                              shown(time.text))
                : fmt::format("`{}` is not a time; it must be seconds, `28-Apr-2025 11:00:02`, "
                              "`2025-04-28 11:00:02.5` or `2025-04-28T11:00:02Z`",
                              shown(time.text)));
  }

  bool is_played(const Instant& instant, const Row& row) {
    const bool inside = !window_.is_before(instant) && !window_.is_after(instant);
    if (!last_) {
      return inside;
    }
    const bool later = instant.seconds_since(*last_) > 0.0;
    if (left_at_) {
      if (inside && later) {
        throw CsvError(*left_at_, fmt::format("this time is after the end of the played part, but "
                                              "line {} is within it; times must increase",
                                              row[time_].place.line));
      }
      return false;
    }
    if (!later) {
      throw CsvError(row[time_].place,
                     fmt::format("time `{}` is not later than in the previous row; times must "
                                 "increase",
                                 shown(row[time_].text)));
    }
    if (!inside) {
      left_at_ = row[time_].place;
    }
    return inside;
  }

  void take(const Instant& instant, const Row& row) {
    if (!last_ && window_.counts_from_first_row() && first_row_.data() != csv_.row_text().data()) {
      trace_.text += first_row_;
    }
    last_ = instant;
    last_place_ = row[time_].place;
    trace_.text += csv_.row_text();
    ++trace_.rows;
    const Cell& frequency = cell(row, frequency_);
    const Cell* voltage = voltage_ ? &cell(row, *voltage_) : nullptr;
    if (is_gap(frequency) || (voltage != nullptr && is_gap(*voltage))) {
      ++trace_.gaps;
      return;
    }
    if (!start_) {
      start_ = instant;
    }
    trace_.points.push_back({instant.seconds_since(*start_), frequency_in(frequency),
                             voltage != nullptr ? voltage_in(*voltage) : 1.0});
  }

  double frequency_in(const Cell& cell) const {
    const double frequency_hz = number_in(cell);
    if (frequency_hz <= 0.0 || frequency_hz < limits_.lowest_hz ||
        frequency_hz > limits_.highest_hz) {
      throw CsvError(cell.place,
                     fmt::format("the frequency is {} Hz; it must be {}", frequency_hz,
                                 std::isfinite(limits_.highest_hz)
                                     ? fmt::format("{} … {} Hz (0.5 … 1.5 of nominal)",
                                                   limits_.lowest_hz, limits_.highest_hz)
                                     : "above 0"));
    }
    return frequency_hz;
  }

  static double voltage_in(const Cell& cell) {
    const double voltage = number_in(cell);
    if (voltage < 0.0) {
      throw CsvError(cell.place,
                     fmt::format("the RMS voltage is {}; it must be at least 0", voltage));
    }
    return voltage;
  }

  [[noreturn]] void refuse_too_few() const {
    if (!format_.from.empty() || !format_.until.empty()) {
      throw FormatError(format_.from.empty() ? "until_s" : "from_s",
                        "from_s and until_s leave fewer than two rows to play");
    }
    throw CsvError(csv_.row_end(),
                   trace_.rows == 0 ? "no data below the column names; at least two rows are needed"
                                    : "fewer than two rows have values; at least two are needed");
  }

  void check_length() const {
    const double length_s = trace_.points.back().t_s;
    const bool is_short = length_s < limits_.shortest_s;
    if (is_short || length_s > limits_.longest_s) {
      throw CsvError(last_place_, fmt::format("the recording is {} s long; it must be at {} {} s",
                                              length_s, is_short ? "least" : "most",
                                              is_short ? limits_.shortest_s : limits_.longest_s));
    }
  }

  const TraceFormat& format_;
  TraceLimits limits_;
  CsvReader csv_;
  TimeWindow window_;
  Row header_;
  std::size_t time_ = 0;
  std::size_t frequency_ = 0;
  std::optional<std::size_t> voltage_;
  std::optional<Instant> first_;  // of the recording
  std::string_view first_row_;
  std::optional<Instant> start_;  // of the first point
  std::optional<Instant> last_;   // of the row that was taken last
  Place last_place_;
  std::optional<Place> left_at_;  // the row that ended the window
  Trace trace_;
};

double median_voltage(const std::vector<TracePoint>& points) {
  std::vector<double> voltages;
  voltages.reserve(points.size());
  for (const TracePoint& point : points) {
    voltages.push_back(point.voltage_pu);
  }
  const auto middle = voltages.begin() + static_cast<std::ptrdiff_t>(voltages.size() / 2);
  std::nth_element(voltages.begin(), middle, voltages.end());
  return *middle;
}

Trace trace_in(const std::string& text, const TraceFormat& format, const TraceLimits& limits) {
  TraceReader reader(text, format, limits);
  Trace trace = reader.trace();
  if (format.voltage.empty()) {
    return trace;
  }
  const double nominal =
      format.nominal_voltage == 0.0 ? median_voltage(trace.points) : format.nominal_voltage;
  if (!std::isfinite(nominal) || nominal <= 0.0) {
    throw CsvError(reader.voltage_place(),
                   fmt::format("the nominal voltage of `{}` is {}; it must be finite and above 0 "
                               "(default: the median of the played part)",
                               shown(format.voltage), nominal));
  }
  for (TracePoint& point : trace.points) {
    point.voltage_pu /= nominal;
  }
  return trace;
}

[[noreturn]] void refuse(const std::string& path, const Place& place, const std::string& what) {
  throw std::runtime_error(fmt::format("{}:{}:{}: {}", path, place.line, place.column, what));
}

}  // namespace

Trace read_trace(const std::string& text, const std::string& path, const TraceFormat& format,
                 const TraceLimits& limits) {
  try {
    return trace_in(text, format, limits);
  } catch (const CsvError& error) {
    refuse(path, error.place, error.what());
  }
}

std::string read_trace_file(const std::string& path) {
  errno = 0;
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file.is_open()) {
    errno = 0;
    text << file.rdbuf();
  }
  // A folder can be opened and fails at the first read; an empty file fails without errno.
  if (!file.is_open() || (text.fail() && errno != 0)) {
    refuse(path, {}, "cannot be read: " + std::generic_category().message(errno));
  }
  return text.str();
}

}  // namespace gsbench::recording
