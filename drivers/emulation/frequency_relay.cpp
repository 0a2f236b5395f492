#include <emulation/frequency_relay.hpp>

namespace gsbench::emulation {
namespace {

constexpr double kArmedBelow_pu = -0.1;

}  // namespace

FrequencyRelay::FrequencyRelay(const FrequencyRelayOptions& options, std::int64_t sample_rate_hz,
                               int nominal_hz, float counts_per_pu)
    : options_(options),
      sample_s_(1.0 / static_cast<double>(sample_rate_hz)),
      longest_period_s_(2.0 / static_cast<double>(nominal_hz)),
      armed_below_(kArmedBelow_pu * static_cast<double>(counts_per_pu)) {}

bool FrequencyRelay::take(std::int16_t counts) {
  const auto now = static_cast<double>(counts);
  const auto now_s = static_cast<double>(sample_) * sample_s_;
  if (armed_ && now >= 0.0) {
    armed_ = false;
    cross(now_s - sample_s_ * now / (now - last_));
  }
  armed_ = armed_ || now < armed_below_;
  if (crossings_ > 0 && now_s - crossed_s_[(crossings_ - 1) % (kPeriods + 1)] > longest_period_s_) {
    crossings_ = 0;
    below_ = false;
  }
  if (below_ && now_s - below_since_s_ >= options_.delay_s) {
    closed_ = false;
  }
  last_ = now;
  ++sample_;
  return closed_;
}

void FrequencyRelay::cross(double at_s) {
  crossed_s_[crossings_ % (kPeriods + 1)] = at_s;
  ++crossings_;
  if (crossings_ <= kPeriods) {
    return;
  }
  const double oldest_s = crossed_s_[crossings_ % (kPeriods + 1)];
  const bool is_below = kPeriods / (at_s - oldest_s) < options_.pickup_hz;
  if (is_below && !below_) {
    below_since_s_ = at_s;
  }
  below_ = is_below;
}

}  // namespace gsbench::emulation
