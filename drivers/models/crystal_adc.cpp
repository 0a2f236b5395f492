#include <algorithm>
#include <cmath>

#include <models/adc.hpp>
#include <models/crystal_adc.hpp>

namespace gsbench::models {

CrystalAdc::CrystalAdc(double ppm, float counts_per_pu, float noise_rms_pu, Stream noise,
                       double samples_per_tick)
    : rate_(samples_per_tick * (1.0 + 1e-6 * ppm)),
      counts_per_pu_(counts_per_pu),
      noise_rms_pu_(noise_rms_pu),
      noise_(noise) {}

void CrystalAdc::take(const float* voltage_pu, std::size_t count,
                      std::vector<std::int16_t>& samples) {
  if (first_held_ == 0 && held_.empty() && count > 0) {
    // The cubic needs a sample before the first one.
    held_.push_back(voltage_pu[0]);
    first_held_ = -1;
  }
  held_.insert(held_.end(), voltage_pu, voltage_pu + count);
  const std::int64_t end_tick = first_held_ + static_cast<std::int64_t>(held_.size());
  const std::int64_t first_made = made_;
  volts_.clear();
  while (true) {
    const double at = tick_of(static_cast<double>(made_));
    const auto tick = static_cast<std::int64_t>(std::floor(at));
    if (tick + 2 >= end_tick) {
      break;
    }
    const auto t = static_cast<float>(at - static_cast<double>(tick));
    const float* v = held_.data() + (tick - 1 - first_held_);
    // Lagrange through ticks −1, 0, 1, 2.
    const float a = -t * (t - 1.0F) * (t - 2.0F) / 6.0F;
    const float b = (t + 1.0F) * (t - 1.0F) * (t - 2.0F) / 2.0F;
    const float c = -(t + 1.0F) * t * (t - 2.0F) / 2.0F;
    const float d = (t + 1.0F) * t * (t - 1.0F) / 6.0F;
    volts_.push_back(a * v[0] + b * v[1] + c * v[2] + d * v[3]);
    ++made_;
  }
  if (noise_rms_pu_ > 0.0F) {
    add_gaussian(noise_, static_cast<std::uint64_t>(first_made), volts_.size(), noise_rms_pu_,
                 volts_.data());
  }
  for (const float volt : volts_) {
    samples.push_back(adc_counts(volt, counts_per_pu_));
  }
  const auto needed =
      static_cast<std::int64_t>(std::floor(tick_of(static_cast<double>(made_)))) - 1;
  if (needed > first_held_) {
    const auto done =
        std::min<std::int64_t>(needed - first_held_, static_cast<std::int64_t>(held_.size()));
    held_.erase(held_.begin(), held_.begin() + done);
    first_held_ += done;
  }
}

}  // namespace gsbench::models
