#include "plan.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <source/chord.hpp>
#include <source/deviation.hpp>

namespace gsbench::head {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

constexpr double kSqrt2 = 1.4142135623730951;
constexpr std::int64_t kComputedAtOnce = 4096;
constexpr double kCode_s = 1.0 / gs::head::kCodeRate_hz;

// Interpolates a stimulus as the head does, and compares each code with the straight line between
// the samples.
class Rounding {
 public:
  explicit Rounding(const Amplitude& amplitude)
      : units_per_pu_(amplitude.samples_per_pu() * gs::head::kOversampling),
        amplitude_(amplitude) {}

  // Returns the mean deviation, per unit, of the codes from one sample to the next.
  double mean_pu(double from_pu, double to_pu) {
    double sum_pu = 0.0;
    for (int code = 0; code < static_cast<int>(gs::head::kOversampling); ++code) {
      const double wanted_pu = from_pu + (to_pu - from_pu) * code / gs::head::kOversampling;
      if (interpolator_.needs_sample()) {
        interpolator_.add(amplitude_.sample(to_pu));
      }
      const int units = (interpolator_.next() - gs::head::kMidScale) * 16 *
                        static_cast<int>(gs::head::kOversampling);
      const double off_pu = units / units_per_pu_ - wanted_pu;
      sum_pu += off_pu;
      largest_pu_ = std::max(largest_pu_, std::fabs(off_pu));
    }
    return sum_pu / gs::head::kOversampling;
  }
  void begin(double voltage_pu) { interpolator_.begin(amplitude_.sample(voltage_pu)); }
  double largest_pu() const { return largest_pu_; }

 private:
  double units_per_pu_;
  const Amplitude& amplitude_;
  gs::head::Interpolator interpolator_;
  double largest_pu_ = 0.0;
};

// Within full scale, so that the interpolator can compute what will be refused.
double bounded(const Amplitude& amplitude, float voltage_pu) {
  const double most_pu = amplitude.full_scale_pu();
  const auto pu = static_cast<double>(voltage_pu);
  return std::isnan(pu) ? 0.0 : std::clamp(pu, -most_pu, most_pu);
}

Status positive(const char* name, double value) {
  return value > 0.0 && std::isfinite(value)
             ? Status(Done{})
             : Error{fmt::format("DAC head: {} is {}: it must be above 0", name, value)};
}

Status not_negative(const char* name, double value) {
  return value >= 0.0 && std::isfinite(value)
             ? Status(Done{})
             : Error{fmt::format("DAC head: {} is {}: it must be 0 or more", name, value)};
}

std::vector<std::string> explanation(const HeadOptions& options, const Amplitude& amplitude,
                                     const source::Played& rounding, double highest_hz) {
  const double peak_v = amplitude.nominal_peak_v();
  return {
      fmt::format("streamed at {} kSa/s, {} s ahead; the head interpolates to {} kSa/s",
                  gs::head::kSampleRate_hz / 1000, kAhead_s, gs::head::kCodeRate_hz / 1000),
      fmt::format("nominal {:.1f} V RMS = {:.1f} V peak at the outlets = {:.3f} V peak at the DAC "
                  "(gain {:g}), {:.1f} % of its {:g} V",
                  options.nominal_v, peak_v, peak_v / options.gain, options.gain,
                  100.0 / amplitude.dac_full_scale_pu(), options.dac_full_scale_v),
      fmt::format("full scale {:.1f} V peak at the outlets, interlock {:.1f} V RMS = {:.1f} V peak",
                  amplitude.dac_full_scale_pu() * peak_v, options.voltage_limit_v,
                  options.voltage_limit_v * kSqrt2),
      fmt::format("12 bits: a step is {:.3f} V at the outlets; rounding leaves {:.4f} mHz",
                  amplitude.step_pu() * peak_v, 1e3 * rounding.frequency_hz),
      fmt::format("crystal ±{:g} ppm: ±{:.3f} mHz at {:g} Hz", options.clock_ppm,
                  1e-3 * options.clock_ppm * highest_hz, highest_hz),
      fmt::format("power-up: {} s ramp, then nominal voltage until the start", kRamp_s),
  };
}

}  // namespace

Amplitude::Amplitude(const HeadOptions& options)
    : nominal_peak_v_(kSqrt2 * options.nominal_v),
      dac_full_scale_pu_(options.dac_full_scale_v * options.gain / nominal_peak_v_),
      voltage_limit_pu_(options.voltage_limit_v / options.nominal_v),
      samples_per_pu_(gs::head::kFullScale / dac_full_scale_pu_) {}

double Amplitude::full_scale_pu() const {
  return std::min(dac_full_scale_pu_, voltage_limit_pu_);
}

std::int16_t Amplitude::sample(double voltage_pu) const {
  return static_cast<std::int16_t>(std::lround(voltage_pu * samples_per_pu_));
}

Status check(const HeadOptions& options) {
  for (const Status& checked :
       {positive("nominal_v", options.nominal_v), positive("gain", options.gain),
        positive("dac_full_scale_v", options.dac_full_scale_v),
        positive("voltage_limit_v", options.voltage_limit_v),
        not_negative("clock_ppm", options.clock_ppm),
        not_negative("opto_close_delay_s", options.opto_close_delay_s),
        not_negative("opto_open_delay_s", options.opto_open_delay_s),
        not_negative("opto_uncertainty_s", options.opto_uncertainty_s)}) {
    if (!checked.ok()) {
      return checked;
    }
  }
  const Amplitude amplitude(options);
  if (amplitude.voltage_limit_pu() < 1.0) {
    return Error{
        fmt::format("DAC head: nominal voltage, {} V RMS, is beyond the voltage limit of "
                    "{} V RMS",
                    options.nominal_v, options.voltage_limit_v)};
  }
  if (amplitude.dac_full_scale_pu() < 1.0) {
    return Error{fmt::format(
        "DAC head: nominal voltage, {:.1f} V peak, is beyond full scale: {} V at the DAC with a "
        "gain of {} is {:.1f} V",
        amplitude.nominal_peak_v(), options.dac_full_scale_v, options.gain,
        amplitude.dac_full_scale_pu() * amplitude.nominal_peak_v())};
  }
  return Done{};
}

source::Played deviation(const HeadOptions& options, const source::Stimulus& stimulus) {
  const Amplitude amplitude(options);
  const std::int64_t total = stimulus.total_ticks();
  source::DeviationMeter meter(stimulus.sample_rate_hz(), stimulus.nominal_hz());
  // The head joins the samples by straight lines.
  source::ChordMeter chord(stimulus.sample_rate_hz() / stimulus.nominal_hz());
  Rounding rounding(amplitude);
  std::vector<float> ideal_pu;
  std::vector<float> played_pu;
  double highest_hz = 0.0;
  for (std::int64_t tick = 0; tick + 1 < total; tick += kComputedAtOnce) {
    const std::int64_t count = std::min(kComputedAtOnce, total - 1 - tick);
    ideal_pu.resize(static_cast<std::size_t>(count + 1));
    stimulus.render(tick, ideal_pu.size(), ideal_pu.data());
    played_pu.resize(static_cast<std::size_t>(count));
    if (tick == 0) {
      rounding.begin(bounded(amplitude, ideal_pu[0]));
    }
    for (std::size_t n = 0; n < played_pu.size(); ++n) {
      const double off_pu =
          rounding.mean_pu(bounded(amplitude, ideal_pu[n]), bounded(amplitude, ideal_pu[n + 1]));
      played_pu[n] = ideal_pu[n] + static_cast<float>(off_pu);
    }
    meter.add(ideal_pu.data(), played_pu.data(), played_pu.size());
    chord.add(ideal_pu.data(), played_pu.size());
    highest_hz =
        std::max({highest_hz, stimulus.frequency_hz(tick), stimulus.frequency_hz(tick + count)});
  }
  source::Played played = meter.largest();
  played.how = explanation(options, amplitude, played, highest_hz);
  played.frequency_hz += 1e-6 * options.clock_ppm * highest_hz;
  played.voltage_pu = rounding.largest_pu() + chord.largest();
  // The DAC holds each code.
  played.time_s = 1e-6 * options.clock_ppm * static_cast<double>(total) /
                      static_cast<double>(stimulus.sample_rate_hz()) +
                  0.5 * kCode_s;
  return played;
}

}  // namespace gsbench::head
