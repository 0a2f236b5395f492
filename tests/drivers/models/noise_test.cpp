// Reproducibility: value n depends on stream and n only.
#include "philox.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <models/noise.hpp>

namespace gsbench::models {
namespace {

std::vector<float> gaussians(const Stream& stream, std::uint64_t first, std::size_t count) {
  std::vector<float> values(count, 0.0f);
  add_gaussian(stream, first, count, 1.0f, values.data());
  return values;
}

std::uint64_t fnv1a(const std::vector<float>& values) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const float value : values) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 4; ++byte) {
      hash = (hash ^ (bits >> (8 * byte) & 0xffu)) * 0x100000001b3u;
    }
  }
  return hash;
}

constexpr Stream kStream{20250428, kTest, 7};

TEST(GaussianNoise, DoesNotDependOnTheDivisionIntoBlocks) {
  const std::vector<float> whole = gaussians(kStream, 0, 1000);
  for (std::size_t first = 0; first < 200; ++first) {
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{63},
                                    std::size_t{64}, std::size_t{65}, std::size_t{300}}) {
      const std::vector<float> part = gaussians(kStream, first, count);
      ASSERT_EQ(0, std::memcmp(part.data(), whole.data() + first, count * sizeof(float)))
          << "first " << first << ", count " << count;
    }
  }
}

TEST(GaussianNoise, IsTheSameOnEveryThread) {
  const std::vector<float> alone = gaussians(kStream, 0, 4 * 5000);
  std::vector<float> together(alone.size(), 0.0f);
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (std::size_t part = 0; part < 4; ++part) {
    threads.emplace_back([&together, part] {
      add_gaussian(kStream, part * 5000, 5000, 1.0f, together.data() + part * 5000);
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(alone, together);
}

// Run records are compared byte for byte between machines and versions: if the values change,
// stored records are no longer reproducible.
TEST(GaussianNoise, KeepsItsValuesAcrossVersions) {
  EXPECT_EQ(fnv1a(gaussians({1, kSourceNoise, 0}, 0, 1000000)), 7008929407730788073u);
}

TEST(GaussianNoise, ContinuesBeyond32BitsOfTheCounter) {
  const std::uint64_t far = (std::uint64_t{1} << 36) - 100;  // after 2³² batches of 16 blocks
  const std::vector<float> whole = gaussians(kStream, far, 200);
  EXPECT_EQ(gaussians(kStream, far + 100, 100),
            std::vector<float>(whole.begin() + 100, whole.end()));
  EXPECT_NE(gaussians(kStream, far + 100, 100), gaussians(kStream, 0, 100));
}

TEST(GaussianNoise, DependsOnSeedPurposeAndIndex) {
  const std::vector<float> base = gaussians({1, kTest, 0}, 0, 100);
  EXPECT_NE(base, gaussians({2, kTest, 0}, 0, 100));
  EXPECT_NE(base, gaussians({1 + (std::uint64_t{1} << 32), kTest, 0}, 0, 100));
  EXPECT_NE(base, gaussians({1, kSourceNoise, 0}, 0, 100));
  EXPECT_NE(base, gaussians({1, kTest, 1}, 0, 100));
}

TEST(GaussianNoise, IsScaledBySigmaAndAddedToTheSignal) {
  const std::vector<float> noise = gaussians(kStream, 5, 100);
  std::vector<float> signal(100, 0.75f);
  add_gaussian(kStream, 5, 100, 0.25f, signal.data());
  for (std::size_t i = 0; i < signal.size(); ++i) {
    EXPECT_EQ(signal[i], 0.75f + 0.25f * noise[i]);
  }
}

TEST(GaussianNoise, DoesNotChangeTheSignalForACountOfZero) {
  float untouched = 3.0f;
  add_gaussian(kStream, 17, 0, 1.0f, &untouched);
  EXPECT_EQ(untouched, 3.0f);
}

// The published test vector of Random123 (kat_vectors, philox4x32 10: counter and key all ones)
// begins with 408f276d 41c83b0e.
TEST(Uniform, GivesThePublishedTestVectorOfPhilox) {
  const std::uint32_t ones = std::numeric_limits<std::uint32_t>::max();
  const Stream stream{std::numeric_limits<std::uint64_t>::max(), ones, ones};
  // Uniform values use the upper half of the counter: n = 2⁶³ − 1 is block 2⁶⁴ − 1.
  const double value = uniform(stream, std::numeric_limits<std::uint64_t>::max() >> 1);
  EXPECT_EQ(value, static_cast<double>(0x408f276d41c83b0eu >> 11) / 0x1p53);
}

TEST(Uniform, IsEvenlyDistributedFrom0To1) {
  constexpr int kCells = 100;
  constexpr int kValues = 1000000;
  std::array<int, kCells> cells{};
  for (std::uint64_t n = 0; n < kValues; ++n) {
    const double value = uniform(kStream, n);
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    ++cells[static_cast<std::size_t>(value * kCells)];
  }
  double chi_square = 0.0;
  for (const int cell : cells) {
    const double expected = static_cast<double>(kValues) / kCells;
    chi_square += (cell - expected) * (cell - expected) / expected;
  }
  // 99 degrees of freedom: mean 99, σ √198 = 14.1; ± 5 σ.
  EXPECT_LT(chi_square, 99 + 5 * 14.1);
  EXPECT_GT(chi_square, 99 - 5 * 14.1);
}

}  // namespace
// Compares many streams at once with Random123, one counter at a time.
TEST(UniformNoise, IsTheSameForManyStreamsAtOnce) {
  constexpr std::size_t kStreams = 50;
  constexpr std::size_t kSamples = 11;
  const Stream first = {0x123456789abcdefULL, kTest, 4000000000U};
  std::vector<float> values(kStreams * kSamples, 0.0F);
  add_uniform_to_each(first, kStreams, kSamples, 2.0F, values.data());
  for (std::size_t stream = 0; stream < kStreams; ++stream) {
    for (std::size_t sample = 0; sample < kSamples; ++sample) {
      const Stream one = {first.seed, first.purpose,
                          first.index + static_cast<std::uint32_t>(stream)};
      const auto word = static_cast<std::int32_t>(philox_block(one, sample / 4).v[sample % 4]);
      ASSERT_EQ(values[sample * kStreams + stream], static_cast<float>(word) * 0x1p-30F);
    }
  }
}

TEST(UniformNoise, DoesNotDependOnTheDivisionIntoBlocks) {
  const Stream stream = {7, kTest, 3};
  std::vector<float> whole(1000, 0.0F);
  add_uniform(stream, 0, whole.size(), 1.0F, whole.data());
  std::vector<float> parts(1000, 0.0F);
  for (std::size_t first = 0; first < parts.size(); first += 37) {
    add_uniform(stream, first, std::min<std::size_t>(37, parts.size() - first), 1.0F,
                parts.data() + first);
  }
  EXPECT_EQ(parts, whole);
  EXPECT_LE(*std::max_element(whole.begin(), whole.end()), 1.0F);
  EXPECT_GE(*std::min_element(whole.begin(), whole.end()), -1.0F);
  double sum = 0.0;
  for (const float value : whole) {
    sum += static_cast<double>(value);
  }
  EXPECT_NEAR(sum / 1000.0, 0.0, 0.06);  // three standard deviations
}

TEST(GaussianNoise, IsTheSameForManyStreamsAtOnce) {
  const Stream first = {9, kTest, 100};
  std::vector<float> values(3 * 70, 0.0F);
  add_gaussian_to_each(first, 3, 70, 0.5F, values.data());
  for (std::uint32_t stream = 0; stream < 3; ++stream) {
    std::vector<float> one(70, 0.0F);
    add_gaussian({9, kTest, 100 + stream}, 0, one.size(), 0.5F, one.data());
    for (std::size_t sample = 0; sample < one.size(); ++sample) {
      ASSERT_EQ(values[sample * 3 + stream], one[sample]);
    }
  }
}

}  // namespace gsbench::models
