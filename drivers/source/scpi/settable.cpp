#include "settable.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Error;
using drivers::Result;

namespace {

constexpr int kUsualMultiple = 4;
// So an upload is at most a quarter of a MB for each second at 8 kHz.
constexpr int kHighestMultiple = 16;
// With fewer points a period, the fundamental itself would be distorted.
constexpr double kFewestPerPeriod = 20.0;
constexpr double kRounding = 1e-9;
// Samples are single-precision: a peak at a step of the amplitude may be this part of it above.
constexpr double kRoundingOfPeak = 1e-3;

// The highest rate the instrument can be set to that is not above `wanted_hz`.
double settable_rate(const Instrument& instrument, double wanted_hz) {
  const auto points = static_cast<double>(instrument.memory.points);
  const bool as_frequency = instrument.rate.set_as == RateAs::kFrequency;
  const double step_hz = instrument.rate.resolution_hz * (as_frequency ? points : 1.0);
  return std::floor(wanted_hz / step_hz + kRounding) * step_hz;
}

std::optional<ChosenRate> fitting(const Instrument& instrument, double wanted_hz,
                                  double duration_s) {
  ChosenRate chosen;
  chosen.rate_hz = settable_rate(instrument, wanted_hz);
  const auto needed =
      static_cast<std::int64_t>(std::ceil(duration_s * chosen.rate_hz - kRounding)) + 1;
  if (needed > instrument.memory.points || chosen.rate_hz < instrument.rate.lowest_hz ||
      chosen.rate_hz > instrument.rate.highest_hz) {
    return std::nullopt;
  }
  chosen.points = instrument.has(Quirk::kFixedLength)
                      ? instrument.memory.points
                      : std::max(needed, instrument.memory.fewest_points);
  chosen.frequency_hz = chosen.rate_hz / static_cast<double>(chosen.points);
  return chosen;
}

struct Highest {
  double rate_hz;
  std::string is;
};

Highest highest_rate(const Instrument& instrument, double stimulus_hz, double duration_s) {
  const double filling_hz = static_cast<double>(instrument.memory.points - 1) / duration_s;
  const double multiple_hz = kHighestMultiple * stimulus_hz;
  if (instrument.rate.highest_hz <= std::min(filling_hz, multiple_hz)) {
    return {instrument.rate.highest_hz, "the highest rate of the instrument"};
  }
  if (filling_hz <= multiple_hz) {
    return {filling_hz, fmt::format("the highest rate at which the {:.1f} s of the waveform fit "
                                    "the memory of {} points",
                                    duration_s, instrument.memory.points)};
  }
  return {multiple_hz, fmt::format("{} times the rate of the stimulus, the most that is used",
                                   kHighestMultiple)};
}

}  // namespace

Result<Rates> choose_rates(const Instrument& instrument, const source::Stimulus& stimulus,
                           double duration_s) {
  const auto rate_hz = static_cast<double>(stimulus.sample_rate_hz());
  const Highest highest = highest_rate(instrument, rate_hz, duration_s);
  Rates rates;
  rates.highest_is = highest.is;
  for (int multiple = kUsualMultiple; multiple >= 1 && rates.rates.empty(); --multiple) {
    if (const auto usual = fitting(instrument, multiple * rate_hz, duration_s)) {
      rates.rates.push_back(*usual);
    }
  }
  if (!rates.rates.empty()) {
    const auto higher = fitting(instrument, highest.rate_hz, duration_s);
    if (higher && higher->rate_hz > rates.rates[0].rate_hz) {
      rates.rates.push_back(*higher);
    }
    return rates;
  }
  const double fewest_hz =
      std::max(instrument.rate.lowest_hz, kFewestPerPeriod * stimulus.nominal_hz());
  if (rate_hz > instrument.rate.highest_hz && fewest_hz > instrument.rate.highest_hz) {
    return Error{fmt::format("{}: plays at most {} points a second; at least {} are needed",
                             instrument.title, instrument.rate.highest_hz, fewest_hz)};
  }
  const auto chosen = fitting(instrument, std::min(highest.rate_hz, rate_hz), duration_s);
  if (!chosen || chosen->rate_hz < fewest_hz) {
    return Error{fmt::format(
        "{}: the memory holds {} points, {:.2f} s at the lowest usable rate of {} Sa/s; the "
        "waveform takes {:.2f} s, of which the stimulus is {:.2f} s",
        instrument.title, instrument.memory.points,
        static_cast<double>(instrument.memory.points) / fewest_hz, fewest_hz, duration_s,
        static_cast<double>(stimulus.total_ticks()) / rate_hz)};
  }
  rates.rates.push_back(*chosen);
  return rates;
}

Result<double> choose_amplitude(const Instrument& instrument, const Wiring& wiring,
                                double peak_pu) {
  const double limit_v = kSqrt2 * wiring.voltage_limit_v;
  const double peak_v = kSqrt2 * wiring.nominal_v * peak_pu;
  if (!(peak_v <= limit_v * (1.0 + kRounding))) {
    return Error{
        fmt::format("{}: {:.5g} V peak at the outlets are beyond the voltage limit of "
                    "{:.5g} V peak ({} V RMS)",
                    instrument.title, peak_v, limit_v, wiring.voltage_limit_v)};
  }
  const Amplitude& range = instrument.amplitude;
  const double needed_vpp = 2.0 * peak_v / wiring.gain;
  const double vpp =
      std::ceil(needed_vpp / range.resolution_vpp - kRoundingOfPeak) * range.resolution_vpp;
  if (vpp > range.highest_vpp * (1.0 + kRounding)) {
    return Error{
        fmt::format("{}: {:.5g} Vpp are needed for {:.5g} V peak at the outlets with a "
                    "gain of {}; the instrument puts out at most {} Vpp",
                    instrument.title, vpp, peak_v, wiring.gain, range.highest_vpp)};
  }
  if (vpp < range.lowest_vpp) {
    return Error{
        fmt::format("{}: {:.5g} Vpp are needed for {:.5g} V peak at the outlets with a "
                    "gain of {}; the instrument puts out at least {} Vpp",
                    instrument.title, needed_vpp, peak_v, wiring.gain, range.lowest_vpp)};
  }
  // Rounded up to a step of the instrument, it may exceed the limit, although no sample does.
  if (0.5 * vpp * wiring.gain > limit_v * (1.0 + kRounding)) {
    return Error{
        fmt::format("{}: an amplitude of {:.5g} Vpp, rounded up to steps of {} Vpp, means "
                    "up to {:.5g} V peak at the outlets; the voltage limit is {:.5g} V "
                    "peak ({} V RMS)",
                    instrument.title, vpp, range.resolution_vpp, 0.5 * vpp * wiring.gain, limit_v,
                    wiring.voltage_limit_v)};
  }
  return vpp;
}

}  // namespace gsbench::scpi
