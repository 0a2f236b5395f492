#include "loaded_waveform.hpp"

#include <source_scpi/planner.hpp>

#include <algorithm>
#include <cmath>

#include <models/noise.hpp>

namespace gsbench::scpi {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kAtZero_s = 0.01;  // 0 V at the very end
constexpr double kFade_s = 0.1;

struct Sine {
  double cosine = 0.0;
  double sine = 0.0;
  double amplitude() const { return std::hypot(cosine, sine); }
};

// Least squares over one period from `first` on; the angle is 0 at `first`.
Sine fitted(const float* first, std::int64_t count, double step_rad) {
  double cc = 0.0;
  double ss = 0.0;
  double cs = 0.0;
  double vc = 0.0;
  double vs = 0.0;
  for (std::int64_t n = 0; n < count; ++n) {
    const double c = std::cos(step_rad * static_cast<double>(n));
    const double s = std::sin(step_rad * static_cast<double>(n));
    const auto v = static_cast<double>(first[n]);
    cc += c * c;
    ss += s * s;
    cs += c * s;
    vc += v * c;
    vs += v * s;
  }
  const double determinant = cc * ss - cs * cs;
  return determinant <= 0.0
             ? Sine{}
             : Sine{(vc * ss - vs * cs) / determinant, (vs * cc - vc * cs) / determinant};
}

double soft(double part) {
  return 0.5 - 0.5 * std::cos(0.5 * kTau * std::clamp(part, 0.0, 1.0));
}

}  // namespace

LoadedWaveform loaded_waveform(const source::Stimulus& stimulus, double boot_s) {
  const auto rate_hz = static_cast<double>(stimulus.sample_rate_hz());
  const std::int64_t total = stimulus.total_ticks();
  const auto ticks = [rate_hz](double time_s) {
    return static_cast<std::int64_t>(std::ceil(time_s * rate_hz - 1e-6));
  };
  LoadedWaveform loaded;
  loaded.lead_ticks = ticks(kRise_s + boot_s + kMargin_s);
  const std::int64_t fall_ticks = ticks(kFall_s);
  std::vector<float>& out = loaded.voltage_pu;
  out.resize(static_cast<std::size_t>(loaded.lead_ticks + total + fall_ticks + ticks(kAtZero_s)));
  float* const played = out.data() + loaded.lead_ticks;
  stimulus.render(0, static_cast<std::size_t>(total), played);

  const double step_rad = kTau * stimulus.nominal_hz() / rate_hz;
  const std::int64_t period =
      std::min<std::int64_t>(total, std::llround(rate_hz / stimulus.nominal_hz()));
  const Sine begin = fitted(played, period, kTau * stimulus.frequency_hz(0) / rate_hz);
  const double phase_rad =
      begin.amplitude() > 0.0 ? std::atan2(-begin.sine, begin.cosine) : -0.25 * kTau;
  for (std::int64_t n = 0; n < loaded.lead_ticks; ++n) {
    const auto from_tick_0 = static_cast<double>(n - loaded.lead_ticks);
    const double faded = soft(1.0 + from_tick_0 / (kFade_s * rate_hz));
    const double amplitude = 1.0 + faded * (begin.amplitude() - 1.0);
    out[static_cast<std::size_t>(n)] =
        static_cast<float>(amplitude * soft(static_cast<double>(n) / (kRise_s * rate_hz)) *
                           std::cos(phase_rad + step_rad * from_tick_0));
  }
  const double last_step_rad = kTau * stimulus.frequency_hz(total - 1) / rate_hz;
  const Sine end = fitted(played + total - period, period, last_step_rad);
  for (std::int64_t n = 0; n < fall_ticks; ++n) {
    const double angle_rad = last_step_rad * static_cast<double>(period + n);
    played[total + n] =
        static_cast<float>((1.0 - soft(static_cast<double>(n) / static_cast<double>(fall_ticks))) *
                           (end.cosine * std::cos(angle_rad) + end.sine * std::sin(angle_rad)));
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
