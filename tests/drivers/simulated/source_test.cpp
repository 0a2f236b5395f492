#include "mains.hpp"

#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsbench::simulated::test {
namespace {

using gs::wire::UplinkKind;
using ::testing::HasSubstr;

std::string refusal(Bench& bench, std::int64_t first_tick, const std::vector<float>& voltage) {
  const auto status = bench.source().play(first_tick, voltage.data(), voltage.size());
  return status.ok() ? "" : status.error();
}

TEST(SimulatedSource, RefusesToPlayBeforeItIsStartedAndAfterItWasMadeSafe) {
  Bench bench(bench_of(1));
  EXPECT_THAT(refusal(bench, 0, {0.0F}), HasSubstr("before it was started"));
  ASSERT_TRUE(bench.source().start(mains_settings(0.0F, 1)).ok());
  EXPECT_EQ(refusal(bench, 0, {0.0F}), "");
  bench.source().make_safe();
  bench.source().make_safe();
  EXPECT_THAT(refusal(bench, 1, {0.0F}), HasSubstr("before it was started"));
}

TEST(SimulatedSource, RefusesTicksThatDoNotFollowOnOneAnother) {
  Bench bench(bench_of(1));
  ASSERT_TRUE(bench.source().start(mains_settings(0.0F, 1)).ok());
  EXPECT_THAT(refusal(bench, 1, {0.0F}), HasSubstr("asked for tick 1, stands at 0"));
  EXPECT_EQ(refusal(bench, 0, {0.0F, 0.0F}), "");
  EXPECT_THAT(refusal(bench, 0, {0.0F}), HasSubstr("asked for tick 0, stands at 2"));
  EXPECT_THAT(refusal(bench, 3, {0.0F}), HasSubstr("asked for tick 3, stands at 2"));
  EXPECT_EQ(refusal(bench, 2, {0.0F}), "");
}

TEST(SimulatedSource, RefusesWhatIsBeyondItsFullScaleAndPlaysNothingOfIt) {
  Bench bench(bench_of(1));
  ASSERT_TRUE(bench.source().start(mains_settings(0.0F, 1)).ok());
  EXPECT_EQ(bench.source().info().full_scale_pu, kFullScalePu);
  EXPECT_EQ(refusal(bench, 0, {1.5F, -1.5F}), "");
  for (const float beyond : {1.5001F, -1.5001F, std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THAT(refusal(bench, 2, {0.0F, beyond}), HasSubstr("tick 3")) << beyond;
  }
  EXPECT_EQ(refusal(bench, 2, {0.0F}), "") << "a refused block must not move the tick on";
}

TEST(SimulatedSource, RefusesASampleRateThatTheFirmwareDoesNotServe) {
  Bench bench(bench_of(1));
  source::SourceSettings settings = mains_settings(0.0F, 1);
  settings.sample_rate_hz = 64000;
  const auto status = bench.source().start(settings);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error(), HasSubstr("64000 Hz"));
}

// Long enough for an event, LSE, EKF, the decision and the relay.
class CutUp : public ::testing::Test {
 protected:
  static constexpr std::size_t kOutlets = 3;

  static std::vector<Heard> heard(const std::vector<std::size_t>& blocks, std::size_t threads,
                                  std::uint64_t seed = 5) {
    Bench bench(bench_of(kOutlets, threads));
    return play(bench, kOutlets, mains_settings(0.01F, seed), falling_mains(3.0), blocks);
  }

  static void expect_equal(const std::vector<Heard>& a, const std::vector<Heard>& b) {
    for (std::size_t i = 0; i < kOutlets; ++i) {
      EXPECT_EQ(a[i].as_bytes(), b[i].as_bytes()) << "outlet " << i;
    }
  }
};

TEST_F(CutUp, TheRunThatIsCutUpHasEveryKindOfMessageThatABlockCouldTear) {
  for (const Heard& outlet : heard({4096}, 1)) {
    for (const UplinkKind kind :
         {UplinkKind::kSettingsAnswer, UplinkKind::kMeasurement, UplinkKind::kEvent,
          UplinkKind::kLse, UplinkKind::kEstimate, UplinkKind::kDecision, UplinkKind::kRelay}) {
      EXPECT_FALSE(outlet.of(kind).empty()) << static_cast<int>(kind);
    }
    EXPECT_FALSE(outlet.edges.empty());
  }
}

TEST_F(CutUp, SaysTheSameBitForBitHoweverTheRunIsCutIntoBlocks) {
  const std::vector<Heard> whole = heard({24000}, 1);
  // A report is 128 samples: blocks that divide it, are it, straddle it, and are longer than the
  // chunk of 2048 that outlets work in.
  expect_equal(whole, heard({1, 7, 64}, 1));
  expect_equal(whole, heard({128}, 1));
  expect_equal(whole, heard({129, 127, 1}, 1));
  expect_equal(whole, heard({2047, 2049, 5000}, 1));
}

TEST_F(CutUp, SaysTheSameBitForBitOnAnyNumberOfThreads) {
  const std::vector<Heard> one = heard({512}, 1);
  expect_equal(one, heard({512}, 2));
  expect_equal(one, heard({512}, 3));
  expect_equal(one, heard({300}, 8));
}

TEST_F(CutUp, AnotherSeedIsHeard) {
  EXPECT_NE(heard({4096}, 1, 5)[0].as_bytes(), heard({4096}, 1, 6)[0].as_bytes());
}

TEST(SimulatedSource, StartedAgainIsAsNew) {
  const std::vector<float> voltage = falling_mains(2.0);
  BenchParameters parameters = bench_of(1);
  parameters.outlet.downlink_ms = 1.0;
  Bench bench(parameters);
  const auto first = play(bench, 1, mains_settings(0.01F, 3), voltage, {1000});
  ASSERT_FALSE(first[0].edges.empty());
  // Ended with a contact about to move, messages not taken and one not yet delivered.
  ASSERT_TRUE(bench.source().start(mains_settings(0.01F, 4)).ok());
  ASSERT_TRUE(bench.link().send(0, command(false)).ok());
  ASSERT_TRUE(bench.source().play(0, voltage.data(), 20).ok());
  ASSERT_TRUE(bench.link().send(0, command(true)).ok());
  const auto second = play(bench, 1, mains_settings(0.01F, 3), voltage, {1000});
  EXPECT_EQ(first[0].as_bytes(), second[0].as_bytes());
}

// ---- noise

std::vector<double> deviations_hz(const Heard& outlet) {
  std::vector<double> all;
  for (const gs::wire::Uplink& message : outlet.of(UplinkKind::kMeasurement)) {
    if (message.measurement.validity == gs::outlet::Validity::kValid && message.sample > kRateHz) {
      all.push_back(static_cast<double>(message.measurement.frequency_hz) - 50.0);
    }
  }
  return all;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double ab = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  const double aa = std::inner_product(a.begin(), a.end(), a.begin(), 0.0);
  const double bb = std::inner_product(b.begin(), b.end(), b.begin(), 0.0);
  return ab / std::sqrt(aa * bb);
}

std::vector<float> steady_mains(double duration_s) {
  std::vector<float> voltage;
  const std::vector<float> second = falling_mains(1.0);
  for (double t_s = 0.0; t_s < duration_s; t_s += 1.0) {
    voltage.insert(voltage.end(), second.begin(), second.end());
  }
  return voltage;
}

TEST(SimulatedNoise, IsIndependentFromOutletToOutlet) {
  Bench bench(bench_of(3));
  const auto heard = play(bench, 3, mains_settings(0.01F, 11), steady_mains(40.0), {8000});
  const std::vector<double> first = deviations_hz(heard[0]);
  ASSERT_GT(first.size(), 2000U);
  // 2400 reports whose noise the tracker remembers for about 10: the correlation of independent
  // ones has a standard deviation of about 1/√240 = 0.065, of which this is five.
  EXPECT_LT(std::fabs(correlation(first, deviations_hz(heard[1]))), 0.32);
  EXPECT_LT(std::fabs(correlation(first, deviations_hz(heard[2]))), 0.32);
  EXPECT_LT(std::fabs(correlation(deviations_hz(heard[1]), deviations_hz(heard[2]))), 0.32);
}

TEST(SimulatedNoise, OfAnOutletDoesNotDependOnItsNeighbours) {
  const std::vector<float> voltage = steady_mains(2.0);
  Bench alone(bench_of(1));
  Bench among(bench_of(3, 2));
  EXPECT_EQ(play(alone, 1, mains_settings(0.01F, 2), voltage, {1000})[0].as_bytes(),
            play(among, 3, mains_settings(0.01F, 2), voltage, {1000})[0].as_bytes());
}

TEST(SimulatedNoise, IsNotThereWhereNoneIsAskedFor) {
  const std::vector<float> voltage = steady_mains(2.0);
  Bench bench(bench_of(2));
  const auto heard = play(bench, 2, mains_settings(0.0F, 2), voltage, {1000});
  EXPECT_EQ(heard[0].as_bytes(), heard[1].as_bytes());
}

}  // namespace
}  // namespace gsbench::simulated::test
