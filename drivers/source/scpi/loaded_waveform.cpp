#include "loaded_waveform.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <models/noise.hpp>
#include <source/fundamental.hpp>

namespace gsbench::scpi {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kAtZero_s = 0.01;  // 0 V at the very end
constexpr double kFade_s = 0.1;

}  // namespace

LoadedTicks::LoadedTicks(const source::Stimulus& stimulus, const PlanOptions& options) {
  const auto ticks = [&](double time_s) {
    return static_cast<std::int64_t>(
        std::ceil(time_s * static_cast<double>(stimulus.sample_rate_hz()) - 1e-6));
  };
  lead = ticks(options.rise_s + options.boot_s + options.margin_s);
  fall = ticks(options.fall_s);
  total = lead + stimulus.total_ticks() + fall + ticks(kAtZero_s);
}

LoadedWaveform loaded_waveform(const source::Stimulus& stimulus, const PlanOptions& options) {
  const auto rate_hz = static_cast<double>(stimulus.sample_rate_hz());
  const std::int64_t total = stimulus.total_ticks();
  const LoadedTicks ticks(stimulus, options);
  LoadedWaveform loaded;
  loaded.lead_ticks = ticks.lead;
  const std::int64_t fall_ticks = ticks.fall;
  std::vector<float>& out = loaded.voltage_pu;
  out.resize(static_cast<std::size_t>(ticks.total));
  float* const played = out.data() + loaded.lead_ticks;
  stimulus.render(0, static_cast<std::size_t>(total), played);

  const double step_rad = kTau * stimulus.nominal_hz() / rate_hz;
  const std::complex<double> begin = source::fundamental_pu(stimulus, 0);
  for (std::int64_t n = 0; n < loaded.lead_ticks; ++n) {
    const auto from_tick_0 = static_cast<double>(n - loaded.lead_ticks);
    const double faded = source::soft(1.0 + from_tick_0 / (kFade_s * rate_hz));
    const double amplitude = 1.0 + faded * (std::abs(begin) - 1.0);
    out[static_cast<std::size_t>(n)] = static_cast<float>(
        amplitude * source::soft(static_cast<double>(n) / (options.rise_s * rate_hz)) *
        std::cos(std::arg(begin) + step_rad * from_tick_0));
  }
  const double last_step_rad = kTau * stimulus.frequency_hz(total - 1) / rate_hz;
  const std::complex<double> end = source::fundamental_pu(stimulus, total);
  for (std::int64_t n = 0; n < fall_ticks; ++n) {
    const double part = static_cast<double>(n) / static_cast<double>(fall_ticks);
    played[total + n] = static_cast<float>(std::real(
        end * std::polar(1.0 - source::soft(part), last_step_rad * static_cast<double>(n))));
  }
  return loaded;
}

std::vector<float> noise_of(const source::Stimulus& stimulus, const LoadedWaveform& waveform) {
  const source::Noise noise = stimulus.noise();
  std::vector<float> out(waveform.voltage_pu.size());
  models::add_gaussian({noise.seed, models::kSourceNoise, 0}, 0,
                       static_cast<std::size_t>(stimulus.total_ticks()), noise.rms_pu,
                       out.data() + waveform.lead_ticks);
  return out;
}

}  // namespace gsbench::scpi
