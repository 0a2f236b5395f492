// The probability that the load-shedding conditions ask for shedding after a loss above or below
// the threshold loss (§6.2, Table 2).
#pragma once

#include <cstdint>

#include <campaign/estimates.hpp>

namespace gsbench::campaign {

// How met conditions are counted. The paper does not state it. The defaults are those of the
// shipped firmware.
struct Counting {
  int window = 8;      // measurements over which a slope (ROCOF) is fitted
  int first = 10;      // index of the first measurement whose slope counts, from 0
  int count = 40;      // number of slopes that count
  int more_than = 20;  // load shedding is needed if more slopes than this meet a condition
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
  std::uint64_t trajectories = 0;  // computed
  std::uint64_t needed = 0;        // trajectories in which load shedding was needed
  Histogram hits;

  double probability() const {
    return static_cast<double>(needed) / static_cast<double>(trajectories);
  }
};

// The counting of the shipped firmware with the settings for this grid.
Counting shipped_counting(const grid::Grid& grid);

// Throws as estimate() does.
ConditionResult count_conditions(const grid::Grid& grid, const ConditionOptions& options,
                                 const Execution& execution);

}  // namespace gsbench::campaign
