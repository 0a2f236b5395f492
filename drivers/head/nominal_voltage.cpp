#include "nominal_voltage.hpp"

#include <cmath>

#include <source/fundamental.hpp>

namespace gsbench::head {
namespace {

constexpr double kTau = 6.283185307179586;

}  // namespace

NominalVoltage::NominalVoltage(const source::Stimulus& stimulus, std::int64_t tick,
                               std::int64_t anchor, double from_pu, std::int64_t ramp_samples)
    : rate_hz_(stimulus.sample_rate_hz()),
      nominal_hz_(stimulus.nominal_hz()),
      anchor_(anchor),
      phase_rad_(std::arg(source::fundamental_pu(stimulus, tick))),
      from_pu_(from_pu),
      ramp_samples_(ramp_samples) {}

double NominalVoltage::at_pu(std::int64_t sample) const {
  const std::int64_t since = sample - anchor_;
  const double turns =
      static_cast<double>(nominal_hz_ * since % rate_hz_) / static_cast<double>(rate_hz_);
  const double part = static_cast<double>(since) / static_cast<double>(ramp_samples_);
  const double amplitude_pu = from_pu_ + (1.0 - from_pu_) * source::soft(part);
  return amplitude_pu * std::cos(phase_rad_ + kTau * turns);
}

}  // namespace gsbench::head
