#include "codes.hpp"
#include "loaded_waveform.hpp"
#include "playback.hpp"
#include "resample.hpp"
#include <source_scpi/planner.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Error;
using drivers::Result;
using source::Played;

namespace {

constexpr double kSqrt2 = 1.41421356237309515;
constexpr int kHighestMultiple = 4;
// Fewer points a period would not even carry the fundamental well.
constexpr double kFewestPerPeriod = 20.0;
constexpr double kRounding = 1e-9;

struct ChosenRate {
  double rate_hz = 0.0;
  double frequency_hz = 0.0;  // of the whole memory
  std::int64_t points = 0;
};

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

Result<ChosenRate> choose_rate(const Instrument& instrument, const source::Stimulus& stimulus,
                               double duration_s) {
  const auto rate_hz = static_cast<double>(stimulus.sample_rate_hz());
  for (int multiple = kHighestMultiple; multiple >= 1; --multiple) {
    if (const auto chosen = fitting(instrument, multiple * rate_hz, duration_s)) {
      return *chosen;
    }
  }
  const double fewest_hz =
      std::max(instrument.rate.lowest_hz, kFewestPerPeriod * stimulus.nominal_hz());
  if (rate_hz > instrument.rate.highest_hz && fewest_hz > instrument.rate.highest_hz) {
    return Error{fmt::format("{}: plays at most {} points a second; at least {} are needed",
                             instrument.title, instrument.rate.highest_hz, fewest_hz)};
  }
  const double filling_hz = static_cast<double>(instrument.memory.points - 1) / duration_s;
  const auto chosen =
      fitting(instrument, std::min({filling_hz, rate_hz, instrument.rate.highest_hz}), duration_s);
  if (!chosen || chosen->rate_hz < fewest_hz) {
    return Error{fmt::format(
        "{}: the memory holds {} points, {:.4g} s at the lowest usable rate of {} Sa/s; the "
        "waveform takes {:.4g} s, of which the stimulus is {:.4g} s",
        instrument.title, instrument.memory.points,
        static_cast<double>(instrument.memory.points) / fewest_hz, fewest_hz, duration_s,
        static_cast<double>(stimulus.total_ticks()) / rate_hz)};
  }
  return *chosen;
}

double peak_of(const std::vector<float>& values) {
  float peak = 0.0F;
  for (const float value : values) {
    peak = std::max(peak, std::fabs(value));
  }
  return static_cast<double>(peak);
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
  const double vpp = std::ceil(needed_vpp / range.resolution_vpp - 1e-6) * range.resolution_vpp;
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

double highest_frequency(const source::Stimulus& stimulus) {
  const std::int64_t every = std::max<std::int64_t>(1, stimulus.sample_rate_hz() / 50);
  double highest_hz = stimulus.nominal_hz();
  for (std::int64_t tick = 0; tick < stimulus.total_ticks(); tick += every) {
    highest_hz = std::max(highest_hz, stimulus.frequency_hz(tick));
  }
  return highest_hz;
}

drivers::Status within_tolerances(const Instrument& instrument, const ChosenRate& rate,
                                  const Played& played, const Tolerances& allowed) {
  const struct {
    const char* what;
    double found;
    double limit;
    const char* unit;
  } checks[] = {{"the frequency", played.frequency_hz * 1e3, allowed.frequency_hz * 1e3, "mHz"},
                {"the voltage", played.voltage_pu, allowed.voltage_pu, "pu"},
                {"the time", played.time_s * 1e3, allowed.time_s * 1e3, "ms"}};
  for (const auto& check : checks) {
    if (!(check.found <= check.limit)) {
      return Error{
          fmt::format("{}: at {:.6g} Sa/s, the highest rate that is possible for {} "
                      "points of memory, {} would deviate by up to {:.4g} {}; the "
                      "tolerance is {:.4g} {}",
                      instrument.title, rate.rate_hz, instrument.memory.points, check.what,
                      check.found, check.unit, check.limit, check.unit)};
    }
  }
  return drivers::Done{};
}

std::vector<std::string> described(const Instrument& instrument, const PlanOptions& options,
                                   const Plan& plan, const Played& waveform) {
  const Accuracy& table = instrument.accuracy;
  const double step_v = 0.5 * plan.amplitude_vpp * options.wiring.gain * instrument.code_step() /
                        instrument.full_scale_code();
  const char* const between = instrument.rate.interpolation == Interpolation::kHold
                                  ? "held until the next"
                                  : "joined by straight lines";
  const char* const verified = instrument.verification == Verification::kReadBack
                                   ? "verified by reading it back"
                               : instrument.verification == Verification::kErrorQueue
                                   ? "verified by the instrument's error queue"
                                   : "not verified: the instrument has no means for it";
  std::vector<std::string> how = {
      instrument.title,
      fmt::format("{} points at {:.8g} Sa/s, {}; {:.2f} s, played once", plan.codes.size(),
                  plan.rate_hz, between, plan.duration_s),
      fmt::format("{} s soft rise, {} s for outlets to boot, {} s margin; the stimulus begins "
                  "after {:.3f} s",
                  kRise_s, options.boot_s, kMargin_s, plan.lead_s),
      fmt::format("{} Vpp at the instrument's terminals, times {} at the outlets, where one step "
                  "of the DAC is {:.3g} V",
                  plan.amplitude_vpp, options.wiring.gain, step_v),
      fmt::format("upload of {} bytes, {}", plan.bytes(), verified),
      fmt::format("deviations: frequency {:.3g} mHz from the waveform and {:.3g} mHz from the "
                  "clock; voltage {:.2g} pu from the waveform and {:.2g} pu from the amplitude; "
                  "time {:.3g} ms",
                  1e3 * waveform.frequency_hz,
                  1e3 * (plan.played.frequency_hz - waveform.frequency_hz), waveform.voltage_pu,
                  plan.played.voltage_pu - waveform.voltage_pu, 1e3 * plan.played.time_s)};
  if (plan.largest_nudge > 0) {
    how.push_back(
        fmt::format("codes that contain a newline are moved by up to {} of {} of full "
                    "scale",
                    plan.largest_nudge, instrument.full_scale_code()));
  }
  how.push_back(
      fmt::format("not calibrated: accuracy from the instrument's table (clock {} ppm, "
                  "amplitude {} %, trigger ±{} ms)",
                  table.clock_ppm, table.amplitude_pct, 1e3 * table.trigger_uncertainty_s));
  return how;
}

}  // namespace

double full_scale_pu(const Instrument& instrument, const Wiring& wiring) {
  const double instrument_v = 0.5 * instrument.amplitude.highest_vpp * wiring.gain / kSqrt2;
  return std::min(instrument_v, wiring.voltage_limit_v) / wiring.nominal_v;
}

Result<Plan> make_plan(const source::Stimulus& stimulus, const Instrument& instrument,
                       const PlanOptions& options) {
  const LoadedWaveform ideal = loaded_waveform(stimulus, options.boot_s);
  const auto stimulus_hz = static_cast<double>(stimulus.sample_rate_hz());
  Plan plan;
  plan.duration_s = static_cast<double>(ideal.voltage_pu.size()) / stimulus_hz;
  const Result<ChosenRate> chosen = choose_rate(instrument, stimulus, plan.duration_s);
  if (!chosen.ok()) {
    return Error{chosen.error()};
  }
  const ChosenRate& rate = chosen.value();
  const double step = stimulus_hz / rate.rate_hz;
  // A held point has the voltage of the middle of its time.
  const double offset = instrument.rate.interpolation == Interpolation::kHold ? 0.5 * step : 0.0;
  const auto points = static_cast<std::size_t>(rate.points);
  const std::vector<float> quiet = resampled(ideal.voltage_pu, offset, step, points);
  std::vector<float> noisy;
  if (stimulus.noise().rms_pu > 0.0F) {
    noisy = band_limited(noise_of(stimulus, ideal), offset, step, points);
    std::transform(noisy.begin(), noisy.end(), quiet.begin(), noisy.begin(), std::plus<>());
  }
  const std::vector<float>& sent = noisy.empty() ? quiet : noisy;
  const Result<double> vpp =
      choose_amplitude(instrument, options.wiring, std::max(peak_of(sent), peak_of(quiet)));
  if (!vpp.ok()) {
    return Error{vpp.error()};
  }
  plan.rate_hz = rate.rate_hz;
  plan.frequency_hz = rate.frequency_hz;
  plan.amplitude_vpp = vpp.value();
  plan.lead_s = static_cast<double>(ideal.lead_ticks) / stimulus_hz;
  const double scale_pu =
      0.5 * vpp.value() * options.wiring.gain / (kSqrt2 * options.wiring.nominal_v);
  Quantised codes = quantised(quiet, scale_pu, instrument);
  const Played waveform =
      Playback(instrument, rate.rate_hz, scale_pu, codes.codes).deviation(stimulus, ideal, quiet);
  if (!noisy.empty()) {
    codes = quantised(noisy, scale_pu, instrument);
  }
  plan.codes = std::move(codes.codes);
  plan.largest_nudge = codes.largest_nudge;

  const Accuracy& table = instrument.accuracy;
  plan.played.frequency_hz =
      waveform.frequency_hz + 1e-6 * table.clock_ppm * highest_frequency(stimulus);
  plan.played.voltage_pu =
      waveform.voltage_pu + 0.01 * table.amplitude_pct * peak_of(ideal.voltage_pu);
  // The trigger's uncertainty shifts the whole run: it is that of the source's host_clock().
  plan.played.time_s = 1e-6 * table.clock_ppm * plan.duration_s;
  const Played judged{plan.played.frequency_hz, waveform.voltage_pu, plan.played.time_s};
  if (const auto accepted = within_tolerances(instrument, rate, judged, options.tolerances);
      !accepted.ok()) {
    return Error{accepted.error()};
  }
  plan.played.how = described(instrument, options, plan, waveform);
  return plan;
}

}  // namespace gsbench::scpi
