// Counter-based random numbers (Philox 4×32-10, Random123): value n of a stream is a pure function
// of (seed, stream, n), independent of machine, thread and division of the work. No libm is used,
// so the last bit does not depend on the C library.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gsbench::models {

// A stream is one sequence of random values. Independent uses of one seed take different streams.
struct Stream {
  std::uint64_t seed = 0;
  std::uint32_t purpose = 0;  // a `Purpose`
  std::uint32_t index = 0;    // number of the outlet or trajectory
};

enum Purpose : std::uint32_t {
  kSourceNoise = 1,
  kRelayModel = 2,
  kTrajectory = 3,
  kTrajectoryParameters = 4,
  kAppliance = 5,
  kDisturbance = 6,
  kNoiseOfDisturbance = 7,
  kTest = 100
};

// Adds sigma · value first+i of the stream to out[i]. The values are N(0, 1).
void add_gaussian(const Stream& stream, std::uint64_t first, std::size_t count, float sigma,
                  float* out);

// Adds value first+i of the stream to out[i]. The values are uniform within ±half_width.
void add_uniform(const Stream& stream, std::uint64_t first, std::size_t count, float half_width,
                 float* out);

// These add the same values for many streams at once, for trajectories computed in parallel. Value
// `sample` of the stream with index first.index + i is added to out[sample·streams + i].
void add_uniform_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                         float half_width, float* out);
void add_gaussian_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                          float sigma, float* out);

// Value n of the stream, uniform in [0, 1).
double uniform(const Stream& stream, std::uint64_t n);

}  // namespace gsbench::models
