#include "random_grids.hpp"

namespace gsbench::oracle {
namespace {

void scale_inertia(grid::Grid& grid, double factor) {
  for (grid::Plant& plant : grid.plants) {
    plant.inertia_s *= factor;
  }
}

double zeta_of(grid::Grid grid, double inertia_factor) {
  scale_inertia(grid, inertia_factor);
  return grid::SfrModel(grid).zeta();
}

}  // namespace

// The distributions of <random> differ between standard libraries.
double RandomGrids::between(double low, double high) {
  const double unit = static_cast<double>(bits_() >> 11) * 0x1p-53;
  return low + (high - low) * unit;
}

grid::Grid RandomGrids::any() {
  grid::Grid grid;
  grid.nominal_hz = between(0.0, 1.0) < 0.5 ? 50.0 : 60.0;
  grid.threshold_hz = grid.nominal_hz - between(0.2, 1.0);
  grid.damping_pu = between(0.0, 4.0);
  grid.gain_km = between(0.5, 1.0);
  grid.reheat_fraction = between(0.0, 1.0);
  grid.reheat_s = between(0.5, 14.0);
  grid.condition_row_hz = between(0.03, 0.2);
  const int plants = static_cast<int>(between(1.0, 6.0));
  double rating_mw = 0.0;
  for (int i = 0; i < plants; ++i) {
    grid.plants.push_back(
        {"plant", between(10.0, 1000.0), between(1.0, 12.0), 1.0 / between(5.0, 30.0)});
    rating_mw += grid.plants.back().rating_mw;
  }
  grid.base_mw = rating_mw * between(0.5, 1.5);
  grid.load_mw = rating_mw;
  return grid;
}

grid::Grid RandomGrids::without_reheat() {
  grid::Grid grid = any();
  grid.reheat_fraction = 1.0;
  return grid;
}

grid::Grid RandomGrids::nearly_critical(double distance) {
  // Reducing the inertia increases the damping ratio. Only grids that become overdamped with a
  // hundredth of their inertia are used, about one in two.
  constexpr double kLeast = 0.01;
  grid::Grid grid = any();
  while (zeta_of(grid, 1.0) >= 1.0 || zeta_of(grid, kLeast) <= 1.0) {
    grid = any();
  }
  double over = kLeast;
  double under = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (under + over);
    (zeta_of(grid, middle) < 1.0 ? under : over) = middle;
  }
  // Near critical damping, the relative change of zeta is at most that of the inertia.
  scale_inertia(grid, under * (1.0 + between(-distance, distance)));
  return grid;
}

std::vector<grid::PowerChange> RandomGrids::changes(const grid::Grid& grid) {
  std::vector<grid::PowerChange> changes;
  const int count = static_cast<int>(between(2.0, 5.0));
  double t_s = 0.0;
  for (int i = 0; i < count; ++i) {
    t_s += between(0.0, 2.5);
    changes.push_back({t_s, grid.load_mw * between(-0.1, 0.2)});
  }
  return changes;
}

}  // namespace gsbench::oracle
