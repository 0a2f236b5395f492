#include <algorithm>
#include <cmath>
#include <vector>

#include <judge/reading.hpp>

namespace gsbench::judge {
namespace {

constexpr std::uint8_t kValid = 1;
constexpr std::size_t kFewestReports = 10;
constexpr const char* kValidNaN =
    "a report marked valid contains a value that is not a finite number";

// Time for the tracker to settle after start-up; earlier reports do not count.
constexpr double kSettle_s = 1.0;

// The bus is dead below this voltage. A valid report counts as a false claim once the bus has been
// dead for longer than the tracker's window.
constexpr double kDeadBus_pu = 0.10;
constexpr double kDeadBusStep_s = 0.002;
constexpr int kDeadBusSteps = 30;
constexpr double kTrackerWindow_s = kDeadBusSteps * kDeadBusStep_s;

struct Sample {
  double t_s;
  double frequency_hz;
  double rocof_hz_s;
};

std::vector<Sample> valid_samples(const Case& c) {
  std::vector<Sample> samples;
  const record::MeasurementTrace& trace = c.outlet.trace;
  for (std::size_t i = 0; i < trace.tick.size(); ++i) {
    if (trace.validity[i] == kValid) {
      samples.push_back({c.seconds(trace.tick[i]), static_cast<double>(trace.frequency_hz[i]),
                         static_cast<double>(trace.rocof_hz_s[i])});
    }
  }
  return samples;
}

struct ErrorSums {
  double largest = 0.0;
  double mean = 0.0;
  double rms = 0.0;
};

using OfSample = double Sample::*;
using OfReference = double (waveform::ReferenceSignal::*)(double t_s) const;

// Errors of `measured` against the reference `delay_s` before each sample, in the measured unit.
ErrorSums errors(const waveform::ReferenceSignal& reference, const std::vector<Sample>& samples,
                 double delay_s, OfSample measured, OfReference expected) {
  ErrorSums sums;
  for (const Sample& sample : samples) {
    const double error =
        sample.*measured - (reference.*expected)(std::max(sample.t_s - delay_s, 0.0));
    sums.largest = std::max(sums.largest, std::fabs(error));
    sums.mean += error;
    sums.rms += error * error;
  }
  const auto count = static_cast<double>(samples.size());
  sums.mean /= count;
  sums.rms = std::sqrt(sums.rms / count);
  return sums;
}

Reading error(const Case& c, OfSample measured, OfReference expected, double ErrorSums::*sum,
              double scale, double uncertainty) {
  const std::vector<Sample> samples = valid_samples(c);
  if (samples.size() < kFewestReports) {
    return not_done("fewer than 10 valid reports");
  }
  const ErrorSums sums = errors(c.reference, samples, c.tracker_delay_s(), measured, expected);
  return std::isfinite(sums.rms) ? number(scale * sums.*sum, uncertainty) : not_done(kValidNaN);
}

template <double ErrorSums::*kSum>
Reading frequency_error(const Case& c) {
  return error(c, &Sample::frequency_hz, &waveform::ReferenceSignal::frequency_hz, kSum, 1e3,
               c.uncertainty.frequency_mhz);
}

Reading rocof_error_rms(const Case& c) {
  return error(c, &Sample::rocof_hz_s, &waveform::ReferenceSignal::rocof_hz_s, &ErrorSums::rms, 1.0,
               0.0);
}

Reading tracker_delay(const Case& c) {
  constexpr double kLongestDelay_s = 0.2;
  constexpr double kMoving_hz_s = 0.05;
  constexpr std::size_t kMostSamples = 2000;
  std::vector<Sample> moving;
  for (const Sample& sample : valid_samples(c)) {
    if (sample.t_s > kLongestDelay_s && moving.size() < kMostSamples &&
        std::fabs(c.reference.rocof_hz_s(sample.t_s)) > kMoving_hz_s) {
      moving.push_back(sample);
    }
  }
  if (moving.size() < kFewestReports) {
    return not_known("fewer than 10 valid reports while the reference moves faster than 0.05 Hz/s");
  }
  const auto rms_at = [&](double delay_s) {
    return errors(c.reference, moving, delay_s, &Sample::frequency_hz,
                  &waveform::ReferenceSignal::frequency_hz)
        .rms;
  };
  if (!std::isfinite(rms_at(0.0))) {
    return not_done(kValidNaN);
  }
  // The RMS error has one minimum over the delay, so a golden-section search finds it.
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.0;
  double high = kLongestDelay_s;
  while (high - low > 1e-4) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    if (rms_at(left) < rms_at(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return number(1e3 * 0.5 * (low + high), std::hypot(0.1, c.outlet.clock.uncertainty_ms));
}

Reading valid_share(const Case& c) {
  const record::MeasurementTrace& trace = c.outlet.trace;
  std::size_t all = 0;
  std::size_t valid = 0;
  for (std::size_t i = 0; i < trace.tick.size(); ++i) {
    if (c.seconds(trace.tick[i]) >= kSettle_s) {
      ++all;
      valid += trace.validity[i] == kValid ? 1 : 0;
    }
  }
  if (all < kFewestReports) {
    return not_done("fewer than 10 reports after the first second");
  }
  return number(100.0 * static_cast<double>(valid) / static_cast<double>(all));
}

Reading dead_bus_claims(const Case& c) {
  const record::MeasurementTrace& trace = c.outlet.trace;
  double claims = 0.0;
  for (std::size_t i = 0; i < trace.tick.size(); ++i) {
    const double t_s = c.seconds(trace.tick[i]);
    bool dead = trace.validity[i] == kValid && t_s > kTrackerWindow_s;
    for (int step = 0; dead && step <= kDeadBusSteps; ++step) {
      dead = c.reference_voltage_pu(t_s - step * kDeadBusStep_s) < kDeadBus_pu;
    }
    claims += dead ? 1.0 : 0.0;
  }
  return number(claims);
}

}  // namespace

Readings tracker_readings() {
  return {
      {"tracker.delay", tracker_delay},
      {"tracker.error.max", frequency_error<&ErrorSums::largest>},
      {"tracker.error.rms", frequency_error<&ErrorSums::rms>},
      {"tracker.bias", frequency_error<&ErrorSums::mean>},
      {"tracker.rocof_error.rms", rocof_error_rms},
      {"validity.valid_share", valid_share},
      {"validity.dead_bus_claims", dead_bus_claims},
  };
}

}  // namespace gsbench::judge
