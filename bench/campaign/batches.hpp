// Runs a campaign's trajectories in batches of kLanes. Several batches form one block of work
// (campaign/work.hpp).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <campaign/estimates.hpp>
#include <campaign/lanes.hpp>
#include <models/noise.hpp>

namespace gsbench::campaign {

constexpr std::size_t kTrajectoriesInBlock = 64 * kLanes;

// Copies the noise-free samples to each lane, in the order of kernel.hpp.
inline void spread(const float* clean, std::size_t samples, float* values) {
  for (std::size_t k = 0; k < samples; ++k) {
    std::fill_n(values + k * kLanes, kLanes, clean[k]);
  }
}

// The measurements of trajectories first … first + kLanes − 1: the noise-free samples plus the
// noise of each trajectory. `Options` has seed, distribution, noise_hz and trajectories.
template <class Options>
void measure(const Options& options, const float* clean, std::size_t samples, std::uint64_t first,
             float* values) {
  spread(clean, samples, values);
  const auto noise = options.distribution == NoiseDistribution::kUniform
                         ? models::add_uniform_to_each
                         : models::add_gaussian_to_each;
  noise({options.seed, models::kTrajectory, static_cast<std::uint32_t>(first)}, kLanes, samples,
        static_cast<float>(options.noise_hz), values);
}

// Runs all trajectories. `clean` returns the noise-free samples of a batch. `each` gets the
// measurements of a batch, the number of its first trajectory, the number of its trajectories, and
// the histograms to add to.
template <class Options, class Clean, class Each>
void run_batches(const Options& options, std::size_t samples, const Clean& clean, const Each& each,
                 const Execution& execution, Histograms& histograms) {
  const auto work = [&](std::uint64_t block, Histograms& own) {
    std::vector<float> deviations_hz(samples * kLanes);
    const std::uint64_t end = std::min((block + 1) * kTrajectoriesInBlock, options.trajectories);
    for (std::uint64_t first = block * kTrajectoriesInBlock; first < end; first += kLanes) {
      measure(options, clean(first / kLanes), samples, first, deviations_hz.data());
      each(deviations_hz.data(), first, std::min<std::uint64_t>(kLanes, end - first), own);
    }
  };
  const std::uint64_t blocks =
      (options.trajectories + kTrajectoriesInBlock - 1) / kTrajectoriesInBlock;
  run_blocks(blocks, execution, work, histograms);
}

}  // namespace gsbench::campaign
