// Counter-based random numbers (Philox 4×32-10, Random123): value n of a stream is a pure function
// of (seed, stream, n), independent of machine, thread and division of the work. No libm is used,
// so the last bit does not depend on the C library.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gsbench::models {

// Streams keep independent uses of one seed apart.
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
  kTest = 100
};

// out[i] += sigma · N(0, 1), value first+i of the stream.
void add_gaussian(const Stream& stream, std::uint64_t first, std::size_t count, float sigma,
                  float* out);

// out[i] += a uniform value within ±half_width, value first+i of the stream.
void add_uniform(const Stream& stream, std::uint64_t first, std::size_t count, float half_width,
                 float* out);

// The same values for many streams at once, for trajectories that are computed in parallel:
// out[sample·streams + i] += value `sample` of stream first.index + i.
void add_uniform_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                         float half_width, float* out);
void add_gaussian_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                          float sigma, float* out);

// Value n of the stream, uniform in [0, 1).
double uniform(const Stream& stream, std::uint64_t n);

}  // namespace gsbench::models
