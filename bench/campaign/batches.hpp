// A campaign's trajectories in batches of kLanes, so many batches a block of its work.
#pragma once

#include <algorithm>
#include <cstdint>

#include <campaign/estimates.hpp>
#include <campaign/lanes.hpp>
#include <models/streams.hpp>

namespace gsbench::campaign {

constexpr std::size_t kBatchesInBlock = 64;
constexpr std::size_t kTrajectoriesInBlock = kBatchesInBlock * kLanes;

inline std::uint64_t blocks_of(std::uint64_t trajectories) {
  return (trajectories + kTrajectoriesInBlock - 1) / kTrajectoriesInBlock;
}

// Calls each(batch, first, count): trajectories first … first + count − 1 are the batch's.
template <class Each>
void each_batch(std::uint64_t block, std::uint64_t trajectories, const Each& each) {
  const std::uint64_t end = std::min((block + 1) * kTrajectoriesInBlock, trajectories);
  for (std::uint64_t first = block * kTrajectoriesInBlock; first < end; first += kLanes) {
    each(first / kLanes, first, std::min<std::uint64_t>(kLanes, end - first));
  }
}

// The same clean samples in each lane, in the kernel's order (kernel.hpp).
inline void spread(const float* clean, std::size_t samples, float* values) {
  for (std::size_t k = 0; k < samples; ++k) {
    std::fill_n(values + k * kLanes, kLanes, clean[k]);
  }
}

// What trajectories first … first + kLanes − 1 measure: the clean samples with each one's own
// noise. `Options`: seed, distribution and noise_hz.
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

}  // namespace gsbench::campaign
