// Random grids for comparison: any combination of plants, and grids close to critical damping,
// where the closed forms change from one case to another.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include <grid/sfr_model.hpp>

namespace gsbench::oracle {

class RandomGrids {
 public:
  explicit RandomGrids(std::uint64_t seed) : bits_(seed) {}

  grid::Grid any();
  // All power without delay: the response is of first order and has no nadir.
  grid::Grid without_reheat();
  // zeta within `distance` of 1, on either side.
  grid::Grid nearly_critical(double distance);
  // Two to four changes within the first ten seconds, ascending; each may be a loss or shed load.
  std::vector<grid::PowerChange> changes(const grid::Grid& grid);

 private:
  double between(double low, double high);

  std::mt19937_64 bits_;
};

}  // namespace gsbench::oracle
