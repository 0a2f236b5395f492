// What is permitted of a grid's fields, both ends included. No power system comes near the ends; a
// value past them was given in another unit.
#pragma once

#include <grid/grid.hpp>

namespace gsbench::grid {

struct Limits {
  double low;
  double high;
};

constexpr Limits kFrequencyHz{1e-3, 1e3};
constexpr Limits kPowerMw{1e-6, 1e7};
constexpr Limits kTimeS{1e-3, 1e3};
constexpr Limits kDampingPu{0.0, 1e3};
constexpr Limits kGain{1e-3, 1e3};
constexpr Limits kFraction{0.0, 1.0};
constexpr Limits kDroopPu{1e-4, 10.0};
constexpr Limits kConditionRowHz{kLowestConditionRowHz, 1e3};
constexpr Limits kConditionRocofHzS{-1e3, 0.0};

}  // namespace gsbench::grid
