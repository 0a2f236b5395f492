#include "check_signal.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace gsbench::waveform {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t kHighestRate_hz = 1'000'000;

void check_within(const std::string& what, double value, double low, double high) {
  if (!std::isfinite(value) || value < low || value > high) {
    throw std::invalid_argument(
        high < kInfinity
            ? fmt::format("{} is {}; it must be from {} to {}", what, value, low, high)
            : fmt::format("{} is {}; it must be finite and at least {}", what, value, low));
  }
}

void check_finite(const std::string& what, double value) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("{} is {}; it must be finite", what, value));
  }
}

void check_harmonics(const SignalSpec& spec, double nominal_hz, std::int64_t sample_rate_hz) {
  std::set<double> orders;
  for (const Harmonic& harmonic : spec.harmonics) {
    const std::string name = fmt::format("harmonic {}", harmonic.order);
    check_within("harmonic order", harmonic.order, kLowestOrder, kInfinity);
    if (harmonic.order == 1.0) {
      throw std::invalid_argument("harmonic order is 1, the fundamental; it must be another");
    }
    check_within(name + ": amplitude in %", harmonic.amplitude_pct, 0, 100);
    check_finite(name + ": phase in degrees", harmonic.phase_deg);
    if (!orders.insert(harmonic.order).second) {
      throw std::invalid_argument(name + " is given twice; give each order once");
    }
    if (harmonic.order * nominal_hz >= 0.5 * static_cast<double>(sample_rate_hz)) {
      throw std::invalid_argument(
          fmt::format("{} of {} Hz is {} Hz; it must be below half the sample rate of {} Hz", name,
                      nominal_hz, harmonic.order * nominal_hz, sample_rate_hz));
    }
  }
}

void check_tones(const SignalSpec& spec, std::int64_t sample_rate_hz) {
  const double limit_hz = 0.5 * static_cast<double>(sample_rate_hz);
  for (const Tone& tone : spec.tones) {
    check_within("tone: time in s", tone.at_s, 0, kInfinity);
    if (!(tone.duration_s > 0.0)) {
      throw std::invalid_argument(
          fmt::format("tone: duration in s is {}; it must be above 0", tone.duration_s));
    }
    if (!(tone.frequency_hz > 0.0 && tone.frequency_hz < limit_hz)) {
      throw std::invalid_argument(
          fmt::format("tone: frequency in Hz is {}; it must be above 0 and below {} (half of the "
                      "sample rate)",
                      tone.frequency_hz, limit_hz));
    }
    check_within("tone: amplitude in %", tone.amplitude_pct, 0, 100);
    check_finite("tone: phase in degrees", tone.phase_deg);
    for (const Pulse& pulse : tone.pulses) {
      check_within("tone: start of a pulse in s", pulse.from_s, 0, kInfinity);
      if (!(pulse.to_s > pulse.from_s)) {
        throw std::invalid_argument(
            fmt::format("tone: end of a pulse in s is {}; it must be above "
                        "{}, its start",
                        pulse.to_s, pulse.from_s));
      }
    }
  }
}

void check_flickers(const SignalSpec& spec, std::int64_t sample_rate_hz) {
  const double limit_hz = 0.5 * static_cast<double>(sample_rate_hz);
  for (const Flicker& flicker : spec.flickers) {
    check_within("flicker: time in s", flicker.at_s, 0, kInfinity);
    if (!(flicker.duration_s > 0.0)) {
      throw std::invalid_argument(
          fmt::format("flicker: duration in s is {}; it must be above 0", flicker.duration_s));
    }
    if (!(flicker.frequency_hz > 0.0 && flicker.frequency_hz < limit_hz)) {
      throw std::invalid_argument(
          fmt::format("flicker: frequency in Hz is {}; it must be above 0 and below {} (half of "
                      "the sample rate)",
                      flicker.frequency_hz, limit_hz));
    }
    check_within("flicker: depth in %", flicker.depth_pct, 0, 100);
  }
}

}  // namespace

void check_signal(const SignalSpec& spec, double nominal_hz, std::int64_t sample_rate_hz) {
  if (sample_rate_hz <= 0 || sample_rate_hz % 1000 != 0 || sample_rate_hz > kHighestRate_hz) {
    throw std::invalid_argument(
        fmt::format("sample rate is {} Hz; it must be a multiple of 1000 Hz, at most {} Hz",
                    sample_rate_hz, kHighestRate_hz));
  }
  check_within("nominal frequency in Hz", nominal_hz, 1,
               0.25 * static_cast<double>(sample_rate_hz));
  check_harmonics(spec, nominal_hz, sample_rate_hz);
  for (const AmplitudeStep& step : spec.amplitude_steps) {
    check_within("amplitude step: time in s", step.at_s, 0, kInfinity);
    if (!(step.duration_s > 0.0)) {
      throw std::invalid_argument(
          fmt::format("amplitude step: duration in s is {}; it must be above 0", step.duration_s));
    }
    check_within("amplitude step: level in %", step.level_pct, 0, 1000);
  }
  for (const PhaseJump& jump : spec.phase_jumps) {
    check_within("phase step: time in s", jump.at_s, 0, kInfinity);
    check_finite("phase step: degrees", jump.degrees);
  }
  check_tones(spec, sample_rate_hz);
  check_flickers(spec, sample_rate_hz);
  check_within("DC offset in %", spec.dc_offset_pct, -100, 100);
  check_finite("initial phase in degrees", spec.initial_phase_deg);
}

}  // namespace gsbench::waveform
