#include "csv.hpp"
#include "instant.hpp"

#include <algorithm>
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

std::string file_text(const std::string& path) {
  errno = 0;
  const std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file.is_open()) {
    errno = 0;
    text << file.rdbuf();
  }
  // A folder can be opened and fails at the first read; an empty file fails without errno.
  if (!file.is_open() || (text.fail() && errno != 0)) {
    throw CsvError({}, "cannot be read: " + std::generic_category().message(errno));
  }
  return text.str();
}

std::string column_list(const Row& header) {
  std::string list;
  for (const Cell& cell : header) {
    list += (list.empty() ? "`" : ", `") + cell.text + '`';
  }
  return list;
}

std::size_t column_of(const std::string& name, const Row& header) {
  const auto is_it = [&name](const Cell& cell) { return cell.text == name; };
  const auto found = std::find_if(header.begin(), header.end(), is_it);
  if (found == header.end()) {
    throw CsvError(header.front().place,
                   fmt::format("no column `{}`; the columns are {}", name, column_list(header)));
  }
  const auto again = std::find_if(found + 1, header.end(), is_it);
  if (again != header.end()) {
    throw CsvError(again->place,
                   fmt::format("a second column `{}`; the name must be unique", name));
  }
  return static_cast<std::size_t>(found - header.begin());
}

double number_in(const Cell& cell) {
  const std::optional<double> number = parse_number(cell.text);
  if (!number) {
    throw CsvError(
        cell.place,
        fmt::format("`{}` is not a finite number; it must be one, or `NaN` for a gap", cell.text));
  }
  return *number;
}

// Recorders mark missing measurements like this.
bool is_gap(const Cell& cell) {
  return cell.text == "NaN" || cell.text == "nan" || cell.text == "NAN";
}

// Reads the rows one by one and checks each against the previous ones.
class TraceReader {
 public:
  TraceReader(std::string_view text, const TraceColumns& columns) : csv_(text) {
    if (!csv_.next(header_)) {
      throw CsvError({}, "the file is empty; it must start with a row of column names");
    }
    time_ = column_of(columns.time, header_);
    frequency_ = column_of(columns.frequency, header_);
    if (!columns.voltage.empty()) {
      voltage_ = column_of(columns.voltage, header_);
    }
  }

  // Voltages still in the column's unit.
  std::vector<TracePoint> points() {
    std::vector<TracePoint> points;
    Row row;
    while (csv_.next(row)) {
      const double t_s = time_in(cell(row, time_));
      const Cell& frequency = cell(row, frequency_);
      const Cell* voltage = voltage_ ? &cell(row, *voltage_) : nullptr;
      if (is_gap(frequency) || (voltage != nullptr && is_gap(*voltage))) {
        continue;
      }
      points.push_back(
          {t_s, frequency_in(frequency), voltage != nullptr ? voltage_in(*voltage) : 1.0});
    }
    if (points.empty()) {
      throw CsvError(csv_.row_end(), "no data below the column names; at least one row is needed");
    }
    return points;
  }

  // Position for errors of the voltage column as a whole.
  Place voltage_place() const { return header_[*voltage_].place; }

 private:
  const Cell& cell(const Row& row, std::size_t column) const {
    if (column < row.size()) {
      return row[column];
    }
    throw CsvError(csv_.row_end(),
                   fmt::format("the row has {} cells; it must have at least {}, up to column `{}`",
                               row.size(), column + 1, header_[column].text));
  }

  double time_in(const Cell& cell) {
    const std::optional<Instant> instant = parse_instant(cell.text);
    if (!instant) {
      throw CsvError(cell.place,
                     fmt::format("`{}` is not a time; it must be seconds, `28-Apr-2025 11:00:02`, "
                                 "`2025-04-28 11:00:02.5` or `2025-04-28T11:00:02Z`",
                                 cell.text));
    }
    if (!start_) {
      start_ = instant;
    }
    if (instant->kind != start_->kind) {
      throw CsvError(cell.place, fmt::format("time `{}` has another format than the first; all "
                                             "must have the same",
                                             cell.text));
    }
    const double t_s = instant->seconds_since(*start_);
    if (last_t_s_ && t_s <= *last_t_s_) {
      throw CsvError(cell.place,
                     fmt::format("time `{}` is not later than in the previous row; times must "
                                 "increase",
                                 cell.text));
    }
    last_t_s_ = t_s;
    return t_s;
  }

  static double frequency_in(const Cell& cell) {
    const double frequency_hz = number_in(cell);
    if (frequency_hz <= 0.0) {
      throw CsvError(cell.place,
                     fmt::format("the frequency is {} Hz; it must be above 0", frequency_hz));
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

  CsvReader csv_;
  Row header_;
  std::size_t time_ = 0;
  std::size_t frequency_ = 0;
  std::optional<std::size_t> voltage_;
  std::optional<Instant> start_;
  std::optional<double> last_t_s_;
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

std::vector<TracePoint> points_in(const std::string& text, const TraceColumns& columns) {
  TraceReader reader(text, columns);
  std::vector<TracePoint> points = reader.points();
  if (columns.voltage.empty()) {
    return points;
  }
  const double nominal =
      columns.nominal_voltage == 0.0 ? median_voltage(points) : columns.nominal_voltage;
  if (!std::isfinite(nominal) || nominal <= 0.0) {
    throw CsvError(reader.voltage_place(),
                   fmt::format("the nominal voltage of `{}` is {}; it must be finite and above 0 "
                               "(default: the median of the column)",
                               columns.voltage, nominal));
  }
  for (TracePoint& point : points) {
    point.voltage_pu /= nominal;
  }
  return points;
}

}  // namespace

std::vector<TracePoint> read_trace(const std::string& path, const TraceColumns& columns) {
  try {
    return points_in(file_text(path), columns);
  } catch (const CsvError& error) {
    throw std::runtime_error(
        fmt::format("{}:{}:{}: {}", path, error.place.line, error.place.column, error.what()));
  }
}

}  // namespace gsbench::recording
