#include "philox.hpp"

#include <cmath>
#include <cstring>

namespace gsbench::models {
namespace {

inline std::uint32_t bits_of(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline float float_of(std::uint32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// ln u for normal u > 0, relative error 1.5·10⁻⁷: the exponent is separated, then Cephes' logf
// polynomial on √½ … √2.
inline float natural_log(float u) {
  constexpr std::uint32_t kSqrtHalfBits = 0x3f3504f3;
  const std::uint32_t bits = bits_of(u);
  const std::int32_t exponent = static_cast<std::int32_t>(bits - kSqrtHalfBits) >> 23;
  const float mantissa = float_of(bits - (static_cast<std::uint32_t>(exponent) << 23));
  const float x = mantissa - 1.0f;
  float p = 7.0376836292e-2f;
  p = p * x - 1.1514610310e-1f;
  p = p * x + 1.1676998740e-1f;
  p = p * x - 1.2420140846e-1f;
  p = p * x + 1.4249322787e-1f;
  p = p * x - 1.6668057665e-1f;
  p = p * x + 2.0000714765e-1f;
  p = p * x - 2.4999993993e-1f;
  p = p * x + 3.3333331174e-1f;
  const float square = x * x;
  constexpr float kLn2 = 0.693147181f;
  return (p * x * square - 0.5f * square + x) + static_cast<float>(exponent) * kLn2;
}

// Two words to two normal values by Box–Muller. The radius uses 39 bits, so that the tails reach
// 7.4 sigma and have over eight thousand levels beyond 6 sigma; the angle uses 24 bits.
inline void box_muller(std::uint32_t word0, std::uint32_t word1, float& first, float& second) {
  const auto upper = static_cast<float>(static_cast<std::int32_t>(word0 >> 1));
  const auto lower = static_cast<float>(static_cast<std::int32_t>(word1 & 0xffu));
  const float u = (upper + (lower + 0.5f) * 0x1p-8f) * 0x1p-31f;  // 2⁻⁴⁰ … 1
  const float radius = std::sqrt(-2.0f * natural_log(u));

  // The angle is in one of four quadrants, each centred on an axis: sine and cosine are computed
  // within ±45° (Cephes' polynomials, 10⁻⁷), then rotated by multiples of 90°.
  const auto within = static_cast<std::int32_t>((word1 >> 8) & 0x3fffffu);
  constexpr float kStep_rad = 1.57079633f * 0x1p-22f;
  const float x = (static_cast<float>(within - (1 << 21)) + 0.5f) * kStep_rad;
  const float z = x * x;
  const float sine =
      ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * x + x;
  const float cosine =
      ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f) * z * z -
      0.5f * z + 1.0f;
  // Branches would prevent vectorisation, so the rotation is done on the bits: swap, flip signs.
  const std::uint32_t quarter_turn = 0u - ((word1 >> 30) & 1u);
  const std::uint32_t half_turn_sign = word1 & 0x80000000u;
  const std::uint32_t swapped = (bits_of(cosine) ^ bits_of(sine)) & quarter_turn;
  const float abscissa =
      float_of((bits_of(cosine) ^ swapped) ^ half_turn_sign ^ (quarter_turn & 0x80000000u));
  const float ordinate = float_of((bits_of(sine) ^ swapped) ^ half_turn_sign);
  first = radius * abscissa;
  second = radius * ordinate;
}

}  // namespace

void gaussian_batch(const Stream& stream, std::uint64_t batch, float* values) {
  std::uint32_t words[4][kBlocksInBatch];
  for (std::size_t i = 0; i < kBlocksInBatch; ++i) {
    const auto block = philox_block(stream, batch * kBlocksInBatch + i);
    for (std::size_t word = 0; word < 4; ++word) {
      words[word][i] = block.v[word];
    }
  }
  for (std::size_t i = 0; i < kBlocksInBatch; ++i) {
    box_muller(words[0][i], words[1][i], values[i], values[kBlocksInBatch + i]);
  }
  for (std::size_t i = 0; i < kBlocksInBatch; ++i) {
    box_muller(words[2][i], words[3][i], values[2 * kBlocksInBatch + i],
               values[3 * kBlocksInBatch + i]);
  }
}

}  // namespace gsbench::models
