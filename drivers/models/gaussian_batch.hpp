// The arithmetic of Gaussian noise: a batch of Philox blocks at a time, in loops that a compiler
// turns into SIMD. Each lane is computed by itself, in the same order of operations, so that the
// width of the machine's vectors does not touch a bit of the result.
#pragma once

#include <cstddef>
#include <cstdint>

#include <models/noise.hpp>

namespace gsbench::models {

constexpr std::size_t kBlocksInBatch = 16;
constexpr std::size_t kValuesInBatch = 4 * kBlocksInBatch;

// Values 64·batch … 64·batch+63 of the stream's standard normals. Value i of the batch comes from
// word i/16 of block 16·batch + i%16, an order that needs no shuffling between SIMD lanes.
void gaussian_batch(const Stream& stream, std::uint64_t batch, float* values);

}  // namespace gsbench::models
