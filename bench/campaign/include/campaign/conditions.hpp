// How surely the load-shedding conditions tell a loss above the threshold from one below (§6.2,
// Table 2).
#pragma once

#include <cstdint>

#include <campaign/estimates.hpp>

namespace gsbench::campaign {

// What the paper leaves open, as an outlet has it.
struct Counting {
  int window = 8;      // samples in the line whose slope is the ROCOF
  int first = 10;      // samples after the loss before the first line that counts
  int count = 40;      // lines that count
  int more_than = 20;  // hits from which on load shedding is needed
};

struct ConditionOptions {
  double loss_mw = 380.0;
  NoiseDistribution distribution = NoiseDistribution::kUniform;
  double noise_hz = 0.01;
  Counting counting;
  std::uint64_t trajectories = 1000000;
  std::uint64_t seed = 1;
};

struct ConditionResult {
  std::uint64_t trajectories = 0;  // done
  std::uint64_t needed = 0;        // of these, in which load shedding was found needed
  Histogram hits;

  double probability() const {
    return static_cast<double>(needed) / static_cast<double>(trajectories);
  }
};

// As outlets ship.
Counting shipped_counting(const grid::Grid& grid);

// Throws as estimate() does.
ConditionResult count_conditions(const grid::Grid& grid, const ConditionOptions& options,
                                 const Execution& execution);

}  // namespace gsbench::campaign
