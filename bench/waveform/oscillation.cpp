#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <waveform/oscillation.hpp>
#include <waveform/reference_signal.hpp>

namespace gsbench::waveform {
namespace {

constexpr double kTurn_rad = 2.0 * 3.14159265358979323846;

double omega_of(const Oscillation& oscillation) {
  return kTurn_rad * oscillation.frequency_hz;
}

double angle_rad(const Oscillation& oscillation, double since_s) {
  return omega_of(oscillation) * since_s + oscillation.phase_deg / 360.0 * kTurn_rad;
}

bool is_on(const Oscillation& oscillation, double t_s) {
  // The end as in corners_s().
  return t_s >= oscillation.at_s && t_s < oscillation.at_s + oscillation.duration_s;
}

void check_within(const char* what, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    throw std::invalid_argument(
        fmt::format("oscillation: {} is {}; it must be from {} to {}", what, value, low, high));
  }
}

void check(const Oscillation& oscillation) {
  check_within("time in s", oscillation.at_s, 0.0, std::numeric_limits<double>::max());
  if (!(oscillation.duration_s > 0.0)) {
    throw std::invalid_argument(fmt::format("oscillation: duration in s is {}; it must be above 0",
                                            oscillation.duration_s));
  }
  check_within("frequency in Hz", oscillation.frequency_hz, kSlowestOscillation_hz,
               kFastestOscillation_hz);
  check_within("amplitude in Hz", oscillation.amplitude_hz, 0.0, kLargestOscillation_hz);
  check_within("phase in degrees", oscillation.phase_deg, -360.0, 360.0);
}

class OscillatingReference final : public ReferenceSignal {
 public:
  OscillatingReference(std::unique_ptr<ReferenceSignal> reference,
                       std::vector<Oscillation> oscillations)
      : reference_(std::move(reference)), oscillations_(std::move(oscillations)) {
    for (const Oscillation& oscillation : oscillations_) {
      check(oscillation);
    }
  }

  double nominal_hz() const override { return reference_->nominal_hz(); }
  double frequency_hz(double t_s) const override {
    return reference_->frequency_hz(t_s) + sum(&Oscillation::deviation_hz, t_s);
  }
  double rocof_hz_s(double t_s) const override {
    return reference_->rocof_hz_s(t_s) + sum(&Oscillation::rocof_hz_s, t_s);
  }
  double excess_cycles(double t_s) const override {
    return reference_->excess_cycles(t_s) + sum(&Oscillation::excess_cycles, t_s);
  }
  double voltage_pu(double t_s) const override { return reference_->voltage_pu(t_s); }

  std::vector<double> corners_s() const override {
    std::vector<double> corners = reference_->corners_s();
    for (const Oscillation& oscillation : oscillations_) {
      corners.push_back(oscillation.at_s);
      if (std::isfinite(oscillation.duration_s)) {
        corners.push_back(oscillation.at_s + oscillation.duration_s);
      }
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  }

 private:
  double sum(double (Oscillation::*value)(double t_s) const, double t_s) const {
    double sum = 0.0;
    for (const Oscillation& oscillation : oscillations_) {
      sum += (oscillation.*value)(t_s);
    }
    return sum;
  }

  std::unique_ptr<ReferenceSignal> reference_;
  std::vector<Oscillation> oscillations_;
};

}  // namespace

double Oscillation::deviation_hz(double t_s) const {
  return is_on(*this, t_s) ? amplitude_hz * std::sin(angle_rad(*this, t_s - at_s)) : 0.0;
}

double Oscillation::rocof_hz_s(double t_s) const {
  return is_on(*this, t_s) ? amplitude_hz * omega_of(*this) * std::cos(angle_rad(*this, t_s - at_s))
                           : 0.0;
}

double Oscillation::excess_cycles(double t_s) const {
  const double since_s = std::clamp(t_s - at_s, 0.0, duration_s);
  return amplitude_hz / omega_of(*this) *
         (std::cos(angle_rad(*this, 0.0)) - std::cos(angle_rad(*this, since_s)));
}

std::unique_ptr<ReferenceSignal> with_oscillations(std::unique_ptr<ReferenceSignal> reference,
                                                   std::vector<Oscillation> oscillations) {
  if (oscillations.empty()) {
    return reference;
  }
  return std::make_unique<OscillatingReference>(std::move(reference), std::move(oscillations));
}

}  // namespace gsbench::waveform
