#include "codes.hpp"
#include "loaded_waveform.hpp"
#include "playback.hpp"
#include "resample.hpp"
#include "settable.hpp"
#include <source_scpi/planner.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Error;
using drivers::Result;
using source::Played;

namespace {

double peak_of(const std::vector<float>& values) {
  float peak = 0.0F;
  for (const float value : values) {
    peak = std::max(peak, std::fabs(value));
  }
  return static_cast<double>(peak);
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
                {"the voltage", 1e2 * played.voltage_pu, 1e2 * allowed.voltage_pu, "%"},
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
      fmt::format("{} points at {:.8g} Sa/s, played once", plan.codes.size(), plan.rate_hz),
      fmt::format("{:.2f} s; points are {}", plan.duration_s, between),
      fmt::format("{} s soft rise, {} s for outlets to boot, {} s margin; the stimulus begins "
                  "after {:.3f} s",
                  options.rise_s, options.boot_s, options.margin_s, plan.lead_s),
      fmt::format("{} Vpp at the instrument's terminals, times {} at the outlets, where one step "
                  "of the DAC is {:.3g} V",
                  plan.amplitude_vpp, options.wiring.gain, step_v),
      fmt::format("upload of {} bytes, {}", plan.bytes(), verified),
      fmt::format(
          "deviations: frequency {:.3g} mHz from the waveform and {:.3g} mHz from the "
          "clock; voltage {:.2g} % from the waveform and {:.2g} % from the amplitude; "
          "time {:.3g} ms",
          1e3 * waveform.frequency_hz, 1e3 * (plan.played.frequency_hz - waveform.frequency_hz),
          1e2 * waveform.voltage_pu, 1e2 * plan.played.amplitude_pu, 1e3 * plan.played.time_s)};
  if (plan.largest_nudge > 0) {
    how.push_back(
        fmt::format("codes that contain a newline are moved by up to {} of {} of full "
                    "scale",
                    plan.largest_nudge, instrument.full_scale_code()));
  }
  how.push_back(
      fmt::format("accuracy from the instrument's table: clock ±{} ppm, amplitude ±{} %, trigger "
                  "±{} ms",
                  table.clock_ppm, table.amplitude_pct, 1e3 * table.trigger_uncertainty_s));
  return how;
}

}  // namespace

double full_scale_pu(const Instrument& instrument, const Wiring& wiring) {
  const Amplitude& range = instrument.amplitude;
  const double limit_vpp = 2.0 * kSqrt2 * wiring.voltage_limit_v / wiring.gain;
  const double settable_vpp =
      std::floor(limit_vpp / range.resolution_vpp + 1e-6) * range.resolution_vpp;
  return 0.5 * std::min(range.highest_vpp, settable_vpp) * wiring.gain /
         (kSqrt2 * wiring.nominal_v);
}

Result<Plan> make_plan(const source::Stimulus& stimulus, const Instrument& instrument,
                       const PlanOptions& options) {
  const LoadedWaveform ideal = loaded_waveform(stimulus, options);
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
  plan.played.voltage_pu = waveform.voltage_pu;
  plan.played.amplitude_pu = 0.01 * table.amplitude_pct * peak_of(ideal.voltage_pu);
  // The trigger's uncertainty shifts the whole run: it is that of the source's host_clock().
  plan.played.time_s = 1e-6 * table.clock_ppm * plan.duration_s;
  if (const auto accepted = within_tolerances(instrument, rate, plan.played, options.tolerances);
      !accepted.ok()) {
    return Error{accepted.error()};
  }
  plan.played.how = described(instrument, options, plan, waveform);
  return plan;
}

}  // namespace gsbench::scpi
