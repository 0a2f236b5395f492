#include <algorithm>
#include <cmath>
#include <vector>

#include <judge/reading.hpp>

namespace gsbench::judge {
namespace {

constexpr std::size_t kFewestReports = 10;
constexpr const char* kValidNaN =
    "a report marked valid contains a value that is not a finite number";

Reading error(const ErrorSums& sums, double value, double uncertainty) {
  if (sums.count < kFewestReports) {
    return not_done("fewer than 10 valid reports");
  }
  return std::isfinite(sums.squares) ? number(value, uncertainty) : not_done(kValidNaN);
}

Reading largest_error(const Case& c) {
  const ErrorSums& sums = c.traces.frequency;
  return error(sums, 1e3 * sums.largest, c.uncertainty.frequency_mhz);
}

Reading rms_error(const Case& c) {
  const ErrorSums& sums = c.traces.frequency;
  return error(sums, 1e3 * sums.rms(), c.uncertainty.frequency_mhz);
}

Reading bias(const Case& c) {
  const ErrorSums& sums = c.traces.frequency;
  return error(sums, 1e3 * sums.mean(), c.uncertainty.frequency_mhz);
}

Reading rocof_error_rms(const Case& c) {
  return error(c.traces.rocof, c.traces.rocof.rms(), 0.0);
}

// RMS of the frequency errors if the tracker has this delay.
double rms_of_moving(const Case& c, double delay_s) {
  ErrorSums sums;
  for (const ValidReport& report : c.traces.moving) {
    const double true_s = std::max(report.t_s - delay_s, 0.0);
    sums.add(report.frequency_hz - c.reference.frequency_hz(true_s));
  }
  return sums.rms();
}

Reading tracker_delay(const Case& c) {
  if (c.traces.moving.size() < kFewestReports) {
    return not_known("fewer than 10 valid reports while the reference moves faster than 0.05 Hz/s");
  }
  if (!std::isfinite(rms_of_moving(c, 0.0))) {
    return not_done(kValidNaN);
  }
  // The RMS error has one minimum over the delay, so a golden-section search finds it.
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.0;
  double high = kLongestDelay_s;
  while (high - low > 1e-4) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    if (rms_of_moving(c, left) < rms_of_moving(c, right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return number(1e3 * 0.5 * (low + high), std::hypot(0.1, c.outlet.clock.uncertainty_ms));
}

Reading valid_share(const Case& c) {
  if (c.traces.settled < kFewestReports) {
    return not_done("fewer than 10 reports after the first second");
  }
  return number(100.0 * static_cast<double>(c.traces.settled_valid) /
                static_cast<double>(c.traces.settled));
}

Reading dead_bus_claims(const Case& c) {
  return number(static_cast<double>(c.traces.dead_bus_claims));
}

}  // namespace

Readings tracker_readings() {
  return {
      {"tracker.delay", tracker_delay},
      {"tracker.error.max", largest_error},
      {"tracker.error.rms", rms_error},
      {"tracker.bias", bias},
      {"tracker.rocof_error.rms", rocof_error_rms},
      {"validity.valid_share", valid_share},
      {"validity.dead_bus_claims", dead_bus_claims},
  };
}

}  // namespace gsbench::judge
