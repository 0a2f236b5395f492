// Philox 4×32-10 with the seed as key, and block number, purpose and index as counter.
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

// Gaussian noise is computed for a batch of blocks at a time, in loops that the compiler
// vectorises. Each lane has the same order of operations, so the result does not depend on the
// vector width.
constexpr std::size_t kBlocksInBatch = 16;
constexpr std::size_t kValuesInBatch = 4 * kBlocksInBatch;

// Standard normal values 64·batch … 64·batch+63 of the stream. Value i of the batch comes from word
// i/16 of block 16·batch + i%16, so that no shuffling between SIMD lanes is needed.
void gaussian_batch(const Stream& stream, std::uint64_t batch, float* values);

}  // namespace gsbench::models
