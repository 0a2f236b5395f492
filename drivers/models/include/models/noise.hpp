// Counter-based random numbers (Philox 4×32-10, Random123): value n of a stream is a pure function
// of (seed, stream, n), on any machine, thread and cut of the work. No libm is involved, so that
// the last bit does not hang on the C library either.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gsbench::models {

// Streams keep independent uses of one seed apart.
struct Stream {
  std::uint64_t seed = 0;
  std::uint32_t purpose = 0;  // what it is for: see `Purpose`
  std::uint32_t index = 0;    // which one: the outlet's or trajectory's number
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

// out[i] += a value uniform within ±half_width, first+i of the stream. A stream is asked for
// uniform or for Gaussian values, not for both.
void add_uniform(const Stream& stream, std::uint64_t first, std::size_t count, float half_width,
                 float* out);

// Many streams at once, for trajectories that are computed side by side, with the same values:
// out[sample·streams + i] += value `sample` of stream first.index + i.
void add_uniform_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                         float half_width, float* out);
void add_gaussian_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                          float sigma, float* out);

// Value n of the stream, uniform in [0, 1).
double uniform(const Stream& stream, std::uint64_t n);

}  // namespace gsbench::models
