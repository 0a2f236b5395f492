#include <cmath>

#include <models/adc.hpp>

namespace gsbench::models {
namespace {

std::string full_scale_text() {
  std::string digits = std::to_string(kFullScalePu);
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits;
}

}  // namespace

drivers::Status within_full_scale(const std::string& source, std::int64_t first_tick,
                                  const float* voltage_pu, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!(std::fabs(voltage_pu[i]) <= static_cast<float>(kFullScalePu))) {
      return drivers::Error{source + ": " + std::to_string(voltage_pu[i]) + " pu at tick " +
                            std::to_string(first_tick + static_cast<std::int64_t>(i)) +
                            " is beyond its full scale of " + full_scale_text() + " pu"};
    }
  }
  return drivers::Done{};
}

}  // namespace gsbench::models
