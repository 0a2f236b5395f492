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

struct Excess {
  std::string what;  // for messages; empty: none

  void compare(const char* name, double found, double limit, const char* unit) {
    if (what.empty() && !(found <= limit)) {
      what = fmt::format("the {} would deviate by up to {:.4g} {}; the tolerance is {:.4g} {}",
                         name, found, unit, limit, unit);
    }
  }
};

// What no rate changes: the clock alone.
drivers::Status clock_within_tolerances(const Instrument& instrument, const Played& clock,
                                        const PlanOptions& options, double duration_s,
                                        double stimulus_s) {
  const double clock_ppm = instrument.accuracy.clock_ppm;
  Excess frequency;
  frequency.compare("frequency", 1e3 * clock.frequency_hz, 1e3 * options.tolerances.frequency_hz,
                    "mHz");
  if (!frequency.what.empty()) {
    return Error{fmt::format("{}: by its clock alone, ±{:g} ppm, {}", instrument.title, clock_ppm,
                             frequency.what)};
  }
  Excess time;
  time.compare("time", 1e3 * clock.time_s, 1e3 * options.tolerances.time_s, "ms");
  if (!time.what.empty()) {
    return Error{fmt::format(
        "{}: by its clock, ±{:g} ppm, over the {:.1f} s of the waveform, of "
        "which the stimulus is {:.1f} s and the time for outlets to boot "
        "{:.1f} s, {}",
        instrument.title, clock_ppm, duration_s, stimulus_s, options.boot_s, time.what)};
  }
  return drivers::Done{};
}

std::string excess_of(const Played& played, const Tolerances& allowed) {
  Excess excess;
  excess.compare("frequency", 1e3 * played.frequency_hz, 1e3 * allowed.frequency_hz, "mHz");
  excess.compare("voltage", 1e2 * played.voltage_pu, 1e2 * allowed.voltage_pu, "%");
  return excess.what;
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

// The plan at one of the possible rates. `clock`: what the clock contributes.
Result<Plan> plan_at(const ChosenRate& rate, const source::Stimulus& stimulus,
                     const LoadedWaveform& ideal, const Instrument& instrument,
                     const PlanOptions& options, const Played& clock) {
  const auto stimulus_hz = static_cast<double>(stimulus.sample_rate_hz());
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
  Plan plan;
  plan.duration_s = static_cast<double>(ideal.voltage_pu.size()) / stimulus_hz;
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
  plan.played.frequency_hz = waveform.frequency_hz + clock.frequency_hz;
  plan.played.voltage_pu = waveform.voltage_pu;
  plan.played.amplitude_pu = 0.01 * instrument.accuracy.amplitude_pct * peak_of(ideal.voltage_pu);
  plan.played.time_s = clock.time_s;
  plan.played.how = described(instrument, options, plan, waveform);
  return plan;
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
  const auto stimulus_hz = static_cast<double>(stimulus.sample_rate_hz());
  const double duration_s = static_cast<double>(LoadedTicks(stimulus, options).total) / stimulus_hz;
  // What is too long must not be rendered: that may take gigabytes.
  const Result<Rates> possible = choose_rates(instrument, stimulus, duration_s);
  if (!possible.ok()) {
    return Error{possible.error()};
  }
  Played clock;
  clock.frequency_hz = 1e-6 * instrument.accuracy.clock_ppm * highest_frequency(stimulus);
  // The trigger's uncertainty shifts the whole run: it is that of the source's host_clock().
  clock.time_s = 1e-6 * instrument.accuracy.clock_ppm * duration_s;
  if (const auto within =
          clock_within_tolerances(instrument, clock, options, duration_s,
                                  static_cast<double>(stimulus.total_ticks()) / stimulus_hz);
      !within.ok()) {
    return Error{within.error()};
  }
  const LoadedWaveform ideal = loaded_waveform(stimulus, options);
  std::string refusal;
  for (const ChosenRate& rate : possible.value().rates) {
    Result<Plan> plan = plan_at(rate, stimulus, ideal, instrument, options, clock);
    const std::string excess =
        plan.ok() ? excess_of(plan.value().played, options.tolerances) : std::string();
    if (excess.empty()) {
      return plan;
    }
    refusal = fmt::format("{}: at {:.6g} Sa/s, {}, {}", instrument.title, rate.rate_hz,
                          possible.value().highest_is, excess);
  }
  return Error{refusal};
}

}  // namespace gsbench::scpi
