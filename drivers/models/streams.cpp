#include "philox.hpp"

#include <algorithm>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <models/noise.hpp>
#include <models/targets.hpp>

namespace gsbench::models {
namespace {

constexpr std::size_t kAtOnce = 32;  // streams in one loop that the compiler vectorises
constexpr std::size_t kWords = 4;    // of a block

Stream nth(const Stream& first, std::size_t i) {
  return {first.seed, first.purpose, first.index + static_cast<std::uint32_t>(i)};
}

using Words = std::uint32_t[kWords * kAtOnce];  // word by word

// Stream first.index + i·stream_step at block + i·block_step, i = 0 … kAtOnce−1.
void fill_any(const Stream& first, std::uint64_t block, std::uint32_t stream_step,
              std::uint32_t block_step, Words& words) {
  for (std::uint32_t i = 0; i < kAtOnce; ++i) {
    const auto values = philox_block(nth(first, i * stream_step), block + i * block_step);
    for (std::size_t word = 0; word < kWords; ++word) {
      words[word * kAtOnce + i] = values.v[word];
    }
  }
}

#if defined(__x86_64__)
struct Product {
  __m256i low;
  __m256i high;
};

[[gnu::target("avx2"), gnu::always_inline]] inline Product multiply(__m256i x, __m256i factor) {
  constexpr int kOddLanes = 0xAA;
  const __m256i even = _mm256_mul_epu32(x, factor);
  const __m256i odd = _mm256_mul_epu32(_mm256_srli_epi64(x, 32), factor);
  return {_mm256_blend_epi32(even, _mm256_slli_epi64(odd, 32), kOddLanes),
          _mm256_blend_epi32(_mm256_srli_epi64(even, 32), odd, kOddLanes)};
}

[[gnu::target("avx2"), gnu::always_inline]] inline __m256i all(std::uint32_t value) {
  return _mm256_set1_epi32(static_cast<std::int32_t>(value));
}

// The same with eight counters in a vector, because compilers do not vectorise Random123's code.
// Blocks come in groups of kAtOnce, so that none carries into the upper word.
[[gnu::target("avx2")]] void fill_avx2(const Stream& first, std::uint64_t block,
                                       std::uint32_t stream_step, std::uint32_t block_step,
                                       Words& words) {
  constexpr std::size_t kWidth = 8;
  constexpr std::size_t kVectors = kAtOnce / kWidth;
  const __m256i count = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  __m256i x[kWords][kVectors];
  for (std::uint32_t v = 0; v < kVectors; ++v) {
    const __m256i place = _mm256_add_epi32(count, all(v * kWidth));
    x[0][v] = _mm256_add_epi32(all(static_cast<std::uint32_t>(block)),
                               _mm256_mullo_epi32(place, all(block_step)));
    x[1][v] = all(static_cast<std::uint32_t>(block >> 32));
    x[2][v] = all(first.purpose);
    x[3][v] = _mm256_add_epi32(all(first.index), _mm256_mullo_epi32(place, all(stream_step)));
  }
  auto key0 = static_cast<std::uint32_t>(first.seed);
  auto key1 = static_cast<std::uint32_t>(first.seed >> 32);
  for (int round = 0; round < 10; ++round) {
    for (std::size_t v = 0; v < kVectors; ++v) {
      const Product p0 = multiply(x[0][v], all(PHILOX_M4x32_0));
      const Product p1 = multiply(x[2][v], all(PHILOX_M4x32_1));
      x[0][v] = _mm256_xor_si256(_mm256_xor_si256(p1.high, x[1][v]), all(key0));
      x[1][v] = p1.low;
      x[2][v] = _mm256_xor_si256(_mm256_xor_si256(p0.high, x[3][v]), all(key1));
      x[3][v] = p0.low;
    }
    key0 += PHILOX_W32_0;
    key1 += PHILOX_W32_1;
  }
  for (std::size_t word = 0; word < kWords; ++word) {
    for (std::size_t v = 0; v < kVectors; ++v) {
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(words + word * kAtOnce + v * kWidth),
                          x[word][v]);
    }
  }
}
#endif

void fill(const Stream& first, std::uint64_t block, std::uint32_t stream_step,
          std::uint32_t block_step, Words& words) {
#if defined(__x86_64__)
  if (has_avx2()) {
    return fill_avx2(first, block, stream_step, block_step, words);
  }
#endif
  fill_any(first, block, stream_step, block_step, words);
}

}  // namespace

void add_uniform_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                         float half_width, float* out) {
  const float unit = half_width * 0x1p-31F;
  for (std::size_t begin = 0; begin < streams; begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, streams - begin);
    for (std::size_t sample = 0; sample < samples; sample += kWords) {
      Words words;
      fill(nth(first, begin), sample / kWords, 1, 0, words);
      for (std::size_t word = 0; word < std::min(kWords, samples - sample); ++word) {
        float* const row = out + (sample + word) * streams + begin;
        for (std::size_t i = 0; i < count; ++i) {
          row[i] += static_cast<float>(static_cast<std::int32_t>(words[word * kAtOnce + i])) * unit;
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
    Words words;
    fill(stream, first / kBatch * kAtOnce, 0, 1, words);
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

}  // namespace gsbench::models
