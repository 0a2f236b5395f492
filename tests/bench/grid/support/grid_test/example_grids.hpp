// Grids with results that are known from publications or independent calculations.
#pragma once

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include <grid/grid.hpp>

namespace gsbench::grid {

// Half a unit of the last digit of an expected value.
inline constexpr double kFiveDecimals = 0.5e-5;
inline constexpr double kFourDecimals = 0.5e-4;
inline constexpr double kThreeDecimals = 0.5e-3;
inline constexpr double kTwoDecimals = 0.5e-2;

// The modified IEEE 24-bus system of Xiang et al., each bus one plant, calibrated to its threshold
// and Table 1: bus 1 in the class of 8.1 s and 1/20, the others in that of 9.3 s and 1/22.
inline Grid ieee24() {
  Grid grid;
  grid.base_mw = 2745.0;
  grid.load_mw = 2745.0;
  grid.damping_pu = 2.5;
  grid.plants = {{"bus 1", 192.0, 8.1, 1.0 / 20.0}};
  for (const double rating_mw : {192.0, 300.0, 591.0, 215.0, 155.0, 400.0, 400.0, 300.0}) {
    grid.plants.push_back({"other bus", rating_mw, 9.3, 1.0 / 22.0});
  }
  return grid;
}

// One plant of 1000 MW with little inertia, 1/R = 20, D = 1: zeta = 1.14.
inline Grid overdamped_grid() {
  Grid grid;
  grid.base_mw = 1000.0;
  grid.load_mw = 1000.0;
  grid.damping_pu = 1.0;
  grid.plants = {{"plant", 1000.0, 2.0, 0.05}};
  return grid;
}

// The same with the inertia that gives `zeta`: with u = 1/(2H), X = D + K_m·F_H/R and
// Z = D + K_m/R, (1/T_R + u·X)² = 4·zeta²·u·Z/T_R. The lower of two solutions; none below
// zeta = 0.58.
inline Grid grid_of_zeta(double zeta) {
  Grid grid = overdamped_grid();
  const double x = 1.0 + 0.95 * 0.3 * 20.0;
  const double z = 1.0 + 0.95 * 20.0;
  const double rate = 1.0 / grid.reheat_s;
  const double half_b = (2.0 * zeta * zeta * z - x) * rate;
  const double u = (half_b + std::sqrt(half_b * half_b - x * x * rate * rate)) / (x * x);
  grid.plants[0].inertia_s = 0.5 / u;
  return grid;
}

// Without a minimum: without reheat delay (F_H = 1) the zero cancels a pole, which leaves a
// first-order response.
inline Grid first_order_grid() {
  Grid grid = overdamped_grid();
  grid.reheat_fraction = 1.0;
  return grid;
}

template <class Call>
void expect_refused(const Call& call, const std::string& field, int index,
                    const std::string& message) {
  try {
    call();
    ADD_FAILURE() << field << " was accepted";
  } catch (const GridError& error) {
    EXPECT_EQ(error.field, field);
    EXPECT_EQ(error.index, index) << field;
    EXPECT_THAT(error.what(), testing::HasSubstr(message));
  }
}

}  // namespace gsbench::grid
