// The ADC before an outlet that is no hardware, simulated or emulated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include <drivers/result.hpp>

namespace gsbench::models {

// ±1.5 times the nominal peak.
constexpr double kFullScalePu = 1.5;
constexpr float kCountsPerPu = static_cast<float>(32767.0 / kFullScalePu);

// It ends at its rails; rounding is to the nearest count.
inline std::int16_t adc_counts(float voltage_pu, float counts_per_pu) {
  const float counts = std::min(std::max(voltage_pu * counts_per_pu, -32768.0F), 32767.0F);
  return static_cast<std::int16_t>(counts + (counts < 0.0F ? -0.5F : 0.5F));
}

// A source refuses what would be clipped: the error names it, the value and its tick.
drivers::Status within_full_scale(const std::string& source, std::int64_t first_tick,
                                  const float* voltage_pu, std::size_t count);

}  // namespace gsbench::models
