#include "csv.hpp"
#include "shown.hpp"
#include "trace_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include <recording/trace.hpp>

namespace gsbench::recording {
namespace {

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
      format.nominal_voltage ? *format.nominal_voltage : median_voltage(trace.points);
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
