#include "mains.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <outlet/response.hpp>

namespace gs::host {
namespace {

constexpr double kTwoPi = 6.283185307179586;

double value_at(const Curve& curve, std::size_t at, double t_s) {
  if (at + 1 >= curve.t_s.size()) {
    return curve.value[at];
  }
  const double part = (t_s - curve.t_s[at]) / (curve.t_s[at + 1] - curve.t_s[at]);
  return curve.value[at] + std::max(part, 0.0) * (curve.value[at + 1] - curve.value[at]);
}

}  // namespace

Curve loss_curve(std::int32_t nominal_hz, double loss_mw, double at_s) {
  // The modified IEEE 24-bus system. Its response has settled when the model's series ends.
  const outlet::Response response = {9.13e-4F, 0.2993F, 0.0682F, 1.262F};
  constexpr int kSteps = 1500;
  constexpr double kStep_s = 0.01;
  Curve curve;
  curve.t_s.push_back(0.0);
  curve.value.push_back(nominal_hz);
  for (int step = 0; step <= kSteps; ++step) {
    const double tau_s = kStep_s * step;
    const float u = outlet::unit_response(response, static_cast<float>(tau_s)).value;
    if (at_s + tau_s > curve.t_s.back()) {
      curve.t_s.push_back(at_s + tau_s);
      curve.value.push_back(nominal_hz -
                            loss_mw * static_cast<double>(response.gain_hz_per_mw * u));
    }
  }
  return curve;
}

Mains::Mains(shared_memory_io::SharedMemory& terminals, Curve curve)
    : terminals_(terminals), curve_(std::move(curve)) {
  if (curve_.t_s.empty()) {
    curve_.t_s = {0.0};
    curve_.value = {static_cast<double>(terminals.nominal_hz)};
  }
}

void Mains::write_due() {
  const auto now = std::chrono::steady_clock::now();
  if (!std::exchange(started_, true)) {
    start_ = now;
  }
  const double passed_s = std::chrono::duration<double>(now - start_).count();
  const auto due = static_cast<std::uint64_t>(passed_s * terminals_.sample_rate_hz);
  std::uint32_t written = terminals_.written;
  for (; played_ < due; ++played_) {
    terminals_.ring[written++ % shared_memory_io::kRingSamples] = sample();
  }
  __atomic_store_n(&terminals_.written, written, __ATOMIC_RELEASE);
}

std::int16_t Mains::sample() {
  const double rate_hz = terminals_.sample_rate_hz;
  const double t_s = static_cast<double>(played_) / rate_hz;
  while (at_ + 1 < curve_.t_s.size() && curve_.t_s[at_ + 1] <= t_s) {
    ++at_;
  }
  double voltage_pu = 0.0;
  if (!curve_.is_voltage) {
    voltage_pu = std::cos(kTwoPi * phase_);
    phase_ += value_at(curve_, at_, t_s) / rate_hz;
    phase_ -= std::floor(phase_);
  } else if (at_ + 1 < curve_.t_s.size() || t_s <= curve_.t_s.back()) {
    voltage_pu = value_at(curve_, at_, t_s);
  }
  const double counts = voltage_pu * static_cast<double>(terminals_.counts_per_pu);
  return static_cast<std::int16_t>(std::lround(std::clamp(counts, -32768.0, 32767.0)));
}

}  // namespace gs::host
