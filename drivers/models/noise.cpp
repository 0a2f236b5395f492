#include "philox.hpp"

#include <algorithm>

#include <models/noise.hpp>

namespace gsbench::models {

void add_gaussian(const Stream& stream, std::uint64_t first, std::size_t count, float sigma,
                  float* out) {
  while (count > 0) {
    float values[kValuesInBatch];
    gaussian_batch(stream, first / kValuesInBatch, values);
    const std::size_t skipped = first % kValuesInBatch;
    const std::size_t used = std::min(count, kValuesInBatch - skipped);
    for (std::size_t i = 0; i < used; ++i) {
      out[i] += sigma * values[skipped + i];
    }
    out += used;
    first += used;
    count -= used;
  }
}

double uniform(const Stream& stream, std::uint64_t n) {
  // Gaussian values use the blocks below 2⁶², uniform values the upper half of the counter, so that
  // both are independent in the same stream.
  constexpr std::uint64_t kUniformBlocks = std::uint64_t{1} << 63;
  const auto block = philox_block(stream, kUniformBlocks | n);
  const std::uint64_t bits = (std::uint64_t{block.v[0]} << 32 | block.v[1]) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace gsbench::models
