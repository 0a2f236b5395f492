#include "nominal_voltage.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
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
  const std::int64_t count =
      std::min(repeats_after(rate_hz, stimulus.nominal_hz()), stimulus.total_ticks() - first_tick);
  std::vector<float> voltage_pu(static_cast<std::size_t>(count));
  stimulus.render(first_tick, voltage_pu.size(), voltage_pu.data());
  std::complex<double> sum;
  for (std::int64_t n = 0; n < count; ++n) {
    const double angle_rad = kTau * static_cast<double>(stimulus.nominal_hz() * n % rate_hz) /
                             static_cast<double>(rate_hz);
    sum +=
        static_cast<double>(voltage_pu[static_cast<std::size_t>(n)]) * std::polar(1.0, -angle_rad);
  }
  // A coefficient over a window shows the phase in its middle.
  const double middle = 0.5 * static_cast<double>(count - 1);
  const double nominal_rad = kTau * stimulus.nominal_hz() / static_cast<double>(rate_hz);
  const double step_rad =
      kTau * stimulus.frequency_hz(first_tick + count / 2) / static_cast<double>(rate_hz);
  return std::arg(sum) + nominal_rad * middle +
         step_rad * (static_cast<double>(tick - first_tick) - middle);
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
