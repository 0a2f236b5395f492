#include "nominal_voltage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace gsbench::head {
namespace {

constexpr double kTau = 6.283185307179586;

}  // namespace

std::int64_t repeats_after(std::int64_t sample_rate_hz, int nominal_hz) {
  return sample_rate_hz / std::gcd(sample_rate_hz, std::int64_t{nominal_hz});
}

double phase_rad(const source::Stimulus& stimulus, std::int64_t first_tick, std::int64_t tick) {
  const std::int64_t rate_hz = stimulus.sample_rate_hz();
  const std::int64_t last_tick = stimulus.total_ticks() - 1;
  const std::int64_t count =
      std::min(repeats_after(rate_hz, stimulus.nominal_hz()), last_tick + 1 - first_tick);
  // Angles of the fundamental, less its angle at `tick`.
  const auto step_rad = [&](std::int64_t at) {
    return kTau * stimulus.frequency_hz(std::min(at, last_tick)) / static_cast<double>(rate_hz);
  };
  double angle_rad = 0.0;
  for (std::int64_t at = first_tick; at < tick; ++at) {
    angle_rad -= step_rad(at);
  }
  std::vector<float> voltage_pu(static_cast<std::size_t>(count));
  stimulus.render(first_tick, voltage_pu.size(), voltage_pu.data());
  double cos_cos = 0.0;
  double cos_sin = 0.0;
  double sin_sin = 0.0;
  double cos_voltage = 0.0;
  double sin_voltage = 0.0;
  for (std::int64_t n = 0; n < count; ++n) {
    const double cosine = std::cos(angle_rad);
    const double sine = std::sin(angle_rad);
    const auto pu = static_cast<double>(voltage_pu[static_cast<std::size_t>(n)]);
    cos_cos += cosine * cosine;
    cos_sin += cosine * sine;
    sin_sin += sine * sine;
    cos_voltage += cosine * pu;
    sin_voltage += sine * pu;
    angle_rad += step_rad(first_tick + n);
  }
  // v = a·cos + b·sin with the smallest squared error; both sides times the determinant.
  const double a = cos_voltage * sin_sin - sin_voltage * cos_sin;
  const double b = sin_voltage * cos_cos - cos_voltage * cos_sin;
  return std::atan2(-b, a);
}

NominalVoltage::NominalVoltage(const source::Stimulus& stimulus, std::int64_t anchor,
                               double phase_rad, double from_pu, std::int64_t ramp_samples)
    : rate_hz_(stimulus.sample_rate_hz()),
      nominal_hz_(stimulus.nominal_hz()),
      anchor_(anchor),
      phase_rad_(phase_rad),
      from_pu_(from_pu),
      ramp_samples_(ramp_samples) {}

double NominalVoltage::at_pu(std::int64_t sample) const {
  const std::int64_t since = sample - anchor_;
  const double turns =
      static_cast<double>(nominal_hz_ * since % rate_hz_) / static_cast<double>(rate_hz_);
  const double part =
      std::min(static_cast<double>(since) / static_cast<double>(ramp_samples_), 1.0);
  const double amplitude_pu =
      from_pu_ + (1.0 - from_pu_) * (0.5 - 0.5 * std::cos(0.5 * kTau * part));
  return amplitude_pu * std::cos(phase_rad_ + kTau * turns);
}

}  // namespace gsbench::head
