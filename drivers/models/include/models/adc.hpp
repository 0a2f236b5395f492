// The ADC of a simulated or emulated outlet.
#pragma once

#include <algorithm>
#include <cstdint>

namespace gsbench::models {

// The ADC's range is ±1.5 times the nominal peak voltage.
constexpr double kFullScale_pu = 1.5;
constexpr float kCounts_per_pu = static_cast<float>(32767.0 / kFullScale_pu);

// Saturates at full scale and rounds to the nearest count.
inline std::int16_t adc_counts(float voltage_pu, float counts_per_pu) {
  const float counts = std::min(std::max(voltage_pu * counts_per_pu, -32768.0F), 32767.0F);
  return static_cast<std::int16_t>(counts + (counts < 0.0F ? -0.5F : 0.5F));
}

}  // namespace gsbench::models
