// Philox 4×32-10 as this library counts with it: the seed is the key; block number, purpose and
// index are the counter.
#pragma once

#include <cstddef>
#include <cstdint>

#include <Random123/philox.h>

#include <models/noise.hpp>

namespace gsbench::models {

inline r123::Philox4x32::ctr_type philox_block(const Stream& stream, std::uint64_t block) {
  const r123::Philox4x32::ctr_type counter = {{static_cast<std::uint32_t>(block),
                                               static_cast<std::uint32_t>(block >> 32),
                                               stream.purpose, stream.index}};
  const r123::Philox4x32::key_type key = {
      {static_cast<std::uint32_t>(stream.seed), static_cast<std::uint32_t>(stream.seed >> 32)}};
  return r123::Philox4x32{}(counter, key);
}

// The arithmetic of Gaussian noise: a batch of blocks at a time, in loops that a compiler turns
// into SIMD. Each lane is computed by itself, in the same order of operations, so that the width of
// the machine's vectors does not touch a bit of the result.
constexpr std::size_t kBlocksInBatch = 16;
constexpr std::size_t kValuesInBatch = 4 * kBlocksInBatch;

// Values 64·batch … 64·batch+63 of the stream's standard normals. Value i of the batch comes from
// word i/16 of block 16·batch + i%16, an order that needs no shuffling between SIMD lanes.
void gaussian_batch(const Stream& stream, std::uint64_t batch, float* values);

}  // namespace gsbench::models
