#include "gaussian_batch.hpp"
#include "philox.hpp"

#include <algorithm>

#include <random/streams.hpp>

namespace gsbench::random {
namespace {

constexpr std::size_t kAtOnce = 32;  // streams in a loop that a compiler turns into SIMD
constexpr std::size_t kWords = 4;    // of a block

Stream nth(const Stream& first, std::size_t i) {
  return {first.seed, first.purpose, first.index + static_cast<std::uint32_t>(i)};
}

}  // namespace

void add_uniform_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                         float half_width, float* out) {
  const float unit = half_width * 0x1p-31F;
  for (std::size_t begin = 0; begin < streams; begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, streams - begin);
    for (std::size_t sample = 0; sample < samples; sample += kWords) {
      std::uint32_t words[kWords][kAtOnce];
      for (std::size_t i = 0; i < kAtOnce; ++i) {
        const auto block = philox_block(nth(first, begin + i), sample / kWords);
        for (std::size_t word = 0; word < kWords; ++word) words[word][i] = block.v[word];
      }
      for (std::size_t word = 0; word < std::min(kWords, samples - sample); ++word) {
        float* const row = out + (sample + word) * streams + begin;
        for (std::size_t i = 0; i < count; ++i) {
          row[i] += static_cast<float>(static_cast<std::int32_t>(words[word][i])) * unit;
        }
      }
    }
  }
}

void add_uniform(const Stream& stream, std::uint64_t first, std::size_t count, float half_width,
                 float* out) {
  const float unit = half_width * 0x1p-31F;
  constexpr std::size_t kBatch =
      kWords * kAtOnce;  // value i: word i / kAtOnce of block i % kAtOnce
  while (count > 0) {
    std::uint32_t words[kBatch];
    const std::uint64_t batch = first / kBatch;
    for (std::size_t i = 0; i < kAtOnce; ++i) {
      const auto block = philox_block(stream, batch * kAtOnce + i);
      for (std::size_t word = 0; word < kWords; ++word) words[word * kAtOnce + i] = block.v[word];
    }
    const std::size_t skipped = first % kBatch;
    const std::size_t used = std::min(count, kBatch - skipped);
    for (std::size_t i = 0; i < used; ++i) {
      out[i] += static_cast<float>(static_cast<std::int32_t>(words[skipped + i])) * unit;
    }
    out += used;
    first += used;
    count -= used;
  }
}

void add_gaussian_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                          float sigma, float* out) {
  for (std::size_t i = 0; i < streams; ++i) {
    for (std::size_t sample = 0; sample < samples; sample += kValuesInBatch) {
      float values[kValuesInBatch];
      gaussian_batch(nth(first, i), sample / kValuesInBatch, values);
      const std::size_t count = std::min(kValuesInBatch, samples - sample);
      for (std::size_t k = 0; k < count; ++k) {
        out[(sample + k) * streams + i] += sigma * values[k];
      }
    }
  }
}

}  // namespace gsbench::random
