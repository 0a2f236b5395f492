#include "mains.hpp"

#include <numeric>

namespace gsbench::simulated::test {
namespace {

using gs::wire::UplinkKind;

// Long enough for an event, LSE, EKF, the decision and the relay.
class SimulatedRun : public ::testing::Test {
 protected:
  static constexpr std::size_t kOutlets = 3;

  static std::vector<OutletLog> logs(const std::vector<std::int64_t>& blocks, std::size_t threads,
                                     std::uint64_t seed = 5) {
    Bench bench(bench_of(kOutlets, threads));
    return play(bench, kOutlets, falling_mains(3.0, 0.01F, seed), blocks);
  }

  static void expect_equal(const std::vector<OutletLog>& a, const std::vector<OutletLog>& b) {
    for (std::size_t i = 0; i < kOutlets; ++i) {
      EXPECT_EQ(a[i].as_bytes(), b[i].as_bytes()) << "outlet " << i;
    }
  }
};

TEST_F(SimulatedRun, HasEveryKindOfMessage) {
  for (const OutletLog& outlet : logs({4096}, 1)) {
    for (const UplinkKind kind :
         {UplinkKind::kSettingsAnswer, UplinkKind::kMeasurement, UplinkKind::kEvent,
          UplinkKind::kLse, UplinkKind::kEstimate, UplinkKind::kDecision, UplinkKind::kRelay}) {
      EXPECT_FALSE(outlet.of(kind).empty()) << static_cast<int>(kind);
    }
    EXPECT_FALSE(outlet.edges.empty());
  }
}

TEST_F(SimulatedRun, IsBitIdenticalForAnyBlockSize) {
  const std::vector<OutletLog> whole = logs({24000}, 1);
  // A report is 128 samples: blocks that divide it, equal it, straddle it, and exceed the outlets'
  // internal chunk of 2048 samples.
  expect_equal(whole, logs({1, 7, 64}, 1));
  expect_equal(whole, logs({128}, 1));
  expect_equal(whole, logs({129, 127, 1}, 1));
  expect_equal(whole, logs({2047, 2049, 5000}, 1));
}

TEST_F(SimulatedRun, IsBitIdenticalOnAnyNumberOfThreads) {
  const std::vector<OutletLog> one = logs({512}, 1);
  expect_equal(one, logs({512}, 2));
  expect_equal(one, logs({512}, 3));
  expect_equal(one, logs({300}, 8));
}

TEST_F(SimulatedRun, DiffersWithTheSeed) {
  EXPECT_NE(logs({4096}, 1, 5)[0].as_bytes(), logs({4096}, 1, 6)[0].as_bytes());
}

TEST(SimulatedSource, ResetsAllStateWhenStartedAgain) {
  BenchParameters parameters = bench_of(1);
  parameters.outlet.downlink_ms = 1.0;
  Bench bench(parameters);
  const auto first = play(bench, 1, falling_mains(2.0, 0.01F, 3), {1000});
  ASSERT_FALSE(first[0].edges.empty());
  // Ends with a contact about to move, messages not polled and a message not yet delivered.
  const gsbench::test::Mains other = falling_mains(2.0, 0.01F, 4);
  gsbench::test::start(bench.source(), other);
  ASSERT_TRUE(bench.link().send(id_of(0), command(false)).ok());
  gsbench::test::advance(bench.source(), 20);
  ASSERT_TRUE(bench.link().send(id_of(0), command(true)).ok());
  ASSERT_TRUE(bench.source().make_safe().ok());
  const auto second = play(bench, 1, falling_mains(2.0, 0.01F, 3), {1000});
  EXPECT_EQ(first[0].as_bytes(), second[0].as_bytes());
}

// ---- noise

std::vector<double> deviations_hz(const OutletLog& outlet) {
  std::vector<double> all;
  for (const gs::wire::Uplink& message : outlet.of(UplinkKind::kMeasurement)) {
    if (message.measurement.validity == gs::outlet::Validity::kValid && message.sample > kRate_hz) {
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

gsbench::test::Mains steady_mains(double duration_s, float noise_rms_pu, std::uint64_t seed) {
  gsbench::test::Mains mains;
  mains.duration_s = duration_s;
  mains.added = {noise_rms_pu, seed};
  return mains;
}

TEST(SimulatedNoise, IsIndependentBetweenOutlets) {
  Bench bench(bench_of(3));
  const auto logs = play(bench, 3, steady_mains(40.0, 0.01F, 11), {8000});
  const std::vector<double> first = deviations_hz(logs[0]);
  ASSERT_GT(first.size(), 2000U);
  // 2400 reports; the tracker correlates noise over about 10 reports. The correlation of
  // independent noise has a standard deviation of about 1/√240 = 0.065; the limit is five of them.
  EXPECT_LT(std::fabs(correlation(first, deviations_hz(logs[1]))), 0.32);
  EXPECT_LT(std::fabs(correlation(first, deviations_hz(logs[2]))), 0.32);
  EXPECT_LT(std::fabs(correlation(deviations_hz(logs[1]), deviations_hz(logs[2]))), 0.32);
}

TEST(SimulatedNoise, DoesNotDependOnOtherOutlets) {
  const gsbench::test::Mains mains = steady_mains(2.0, 0.01F, 2);
  Bench alone(bench_of(1));
  Bench among(bench_of(3, 2));
  EXPECT_EQ(play(alone, 1, mains, {1000})[0].as_bytes(),
            play(among, 3, mains, {1000})[0].as_bytes());
}

TEST(SimulatedNoise, IsAbsentForAnRmsOfZero) {
  Bench bench(bench_of(2));
  const auto logs = play(bench, 2, steady_mains(2.0, 0.0F, 2), {1000});
  EXPECT_EQ(logs[0].as_bytes(), logs[1].as_bytes());
}

}  // namespace
}  // namespace gsbench::simulated::test
