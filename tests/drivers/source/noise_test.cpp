// The noise of a stimulus in the samples that a source plays.
#include <test_support/mains.hpp>

#include <vector>

#include <gmock/gmock.h>

#include <source/source.hpp>

namespace gsbench::test {
namespace {

using drivers::Done;
using drivers::Status;

class NoisySource final : public source::Source {
 public:
  NoisySource(bool per_outlet, double full_scale_pu)
      : per_outlet_(per_outlet), full_scale_pu_(full_scale_pu) {}
  source::Limits limits() const override {
    source::Limits limits;
    limits.name = "noisy source";
    limits.full_scale_pu = full_scale_pu_;
    limits.sample_rates_hz = {8000};
    limits.nominal_hz = {50};
    limits.noise_per_outlet = per_outlet_;
    return limits;
  }
  std::vector<float> read(std::int64_t first_tick, std::int64_t count) {
    const auto some = samples(first_tick, count);
    return some.ok() ? std::vector<float>(some.value(), some.value() + count)
                     : std::vector<float>();
  }

 protected:
  drivers::Result<source::Played> deviation(const source::Stimulus&) const override {
    return source::Played{};
  }
  Status power_up() override { return Done{}; }
  Status begin() override { return Done{}; }
  drivers::Result<std::int64_t> play_until(std::int64_t until_tick) override { return until_tick; }
  Status switch_off() noexcept override { return Done{}; }

 private:
  bool per_outlet_;
  double full_scale_pu_;
};

class SourceNoise : public testing::Test {
 protected:
  SourceNoise() {
    mains_.duration_s = 1.0;
    mains_.added = {0.01F, 7};
  }
  std::vector<float> played(bool per_outlet) {
    NoisySource source(per_outlet, 1.2);
    EXPECT_TRUE(source.prepare(mains_).ok());
    return source.read(0, mains_.total_ticks());
  }
  double noise_rms_pu(const std::vector<float>& samples) const {
    std::vector<float> clean(samples.size());
    mains_.render(0, clean.size(), clean.data());
    double sum = 0.0;
    for (std::size_t n = 0; n < samples.size(); ++n) {
      const auto noise = static_cast<double>(samples[n] - clean[n]);
      sum += noise * noise;
    }
    return std::sqrt(sum / static_cast<double>(samples.size()));
  }

  Mains mains_;
};

TEST_F(SourceNoise, IsInTheSamplesUnlessItIsAddedForEachOutlet) {
  // 8000 values: the standard deviation of their RMS is 0.8 %.
  EXPECT_NEAR(noise_rms_pu(played(false)), 0.01, 0.0003);
  EXPECT_EQ(noise_rms_pu(played(true)), 0.0);
}

TEST_F(SourceNoise, DoesNotDependOnTheBlocks) {
  NoisySource source(false, 1.2);
  ASSERT_TRUE(source.prepare(mains_).ok());
  std::vector<float> joined = source.read(0, 777);
  const std::vector<float> rest = source.read(777, 8000 - 777);
  joined.insert(joined.end(), rest.begin(), rest.end());
  EXPECT_EQ(joined, played(false));
}

TEST_F(SourceNoise, CountsAgainstFullScale) {
  EXPECT_TRUE(NoisySource(false, 1.1).check(mains_).ok());
  EXPECT_THAT(NoisySource(false, 1.0).check(mains_).error(),
              testing::HasSubstr(" s, noise included, is beyond its full scale of 1 pu"));
  EXPECT_TRUE(NoisySource(true, 1.0).check(mains_).ok());
}

}  // namespace
}  // namespace gsbench::test
