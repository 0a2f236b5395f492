// The random values of one case.
#pragma once

#include <cmath>
#include <cstdint>

#include <immunity/disturbance.hpp>
#include <models/noise.hpp>

namespace gsbench::immunity {

// Values are rounded, so that a profile with them is easy to read: to so many steps per unit.
constexpr double kPerSecond = 1e5;  // a sample lasts 12.5 of these steps
constexpr double kPerPercent = 100.0;
constexpr double kPerDegree = 1.0;
constexpr double kPerHertz = 100.0;

inline double rounded(double value, double per_unit) {
  return std::round(value * per_unit) / per_unit;
}

class Draws {
 public:
  Draws(std::uint64_t seed, std::uint32_t number) : stream_{seed, models::kDisturbance, number} {}

  double uniform(double low, double high, double per_unit) {
    return rounded(low + (high - low) * next(), per_unit);
  }
  // Uniform in the logarithm.
  double logarithmic(double low, double high, double per_unit) {
    return rounded(low * std::pow(high / low, next()), per_unit);
  }
  double phase_deg() { return uniform(-180.0, 180.0, kPerDegree); }
  int whole(int least, int most) { return least + static_cast<int>((most - least + 1) * next()); }
  bool one_in(int n) { return whole(1, n) == 1; }

 private:
  double next() { return models::uniform(stream_, drawn_++); }

  models::Stream stream_;
  std::uint64_t drawn_ = 0;
};

// These add to a disturbance that begins at begin_s, and set its end.
void add_rectangular_flicker(Draws& draws, Disturbance& disturbance);
void add_sinusoidal_flicker(Draws& draws, double nominal_hz, Disturbance& disturbance);
void add_harmonics(Draws& draws, double nominal_hz, Disturbance& disturbance);
void add_mains_signalling(Draws& draws, Disturbance& disturbance);

}  // namespace gsbench::immunity
