// The estimators over many trajectories: the paper's Tables 3, 4 and 5 with fewer trajectories and
// the limits required of the full campaign.
#include <test_support/ieee24.hpp>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>

#include <campaign/estimates.hpp>
#include <outlet/loss_estimator.hpp>

namespace gsbench::campaign {
namespace {

using test::ieee24;

EstimateOptions small_campaign(Mode mode,
                               NoiseDistribution distribution = NoiseDistribution::kUniform) {
  EstimateOptions options;
  options.mode = mode;
  options.distribution = distribution;
  options.trajectories = 20000;
  return options;
}

EstimateResult compute(const EstimateOptions& options, std::size_t threads = 2) {
  Execution execution;
  execution.threads = threads;
  return estimate(ieee24(), options, execution);
}

std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

double within(const EstimateResult& result, double part) {
  return result.ekf_mw.share_between(500.0 * (1.0 - part), 500.0 * (1.0 + part));
}

// ±0.01 Hz: σ of LSE is K_LSE·σ/(T·√(n(n² − 1)/12)) = 1011.9·0.005774/(0.016·9.083).
TEST(EstimateCampaign, TheLseHasTheStandardDeviationOfItsFormula) {
  const EstimateResult result = compute(small_campaign(Mode::kFirmware));
  EXPECT_NEAR(result.lse_mw.standard_deviation(), 40.2, 0.6);
  EXPECT_NEAR(result.lse_mw.mean(), 479.4, 1.0);
}

TEST(EstimateCampaign, UniformNoiseGivesAtLeastTheAccuracyOfTable4) {
  for (const Mode mode : {Mode::kPaper, Mode::kFirmware}) {
    SCOPED_TRACE(mode == Mode::kPaper ? "paper" : "firmware");
    const EstimateResult result = compute(small_campaign(mode));
    EXPECT_GE(within(result, 0.04), 0.999);
    EXPECT_EQ(within(result, 0.10), 1.0);
    EXPECT_NEAR(result.ekf_mw.mean(), 500.0, 0.5);
  }
}

TEST(EstimateCampaign, GaussianNoiseGivesAtLeastTheAccuracyOfTable4) {
  for (const LossInstant instant : {LossInstant::kOnReport, LossInstant::kBetweenReports}) {
    EstimateOptions options = small_campaign(Mode::kFirmware, NoiseDistribution::kGaussian);
    options.instant = instant;
    EXPECT_GE(within(compute(options), 0.04), 0.99);
  }
}

// LSE and EKF together use all fifty samples. The EKF also starts with an estimate of the instant,
// so that it may pass the bound for an unknown instant.
TEST(EstimateCampaign, TheStandardDeviationIsNearTheBoundForAllSamples) {
  for (const NoiseDistribution distribution :
       {NoiseDistribution::kUniform, NoiseDistribution::kGaussian}) {
    SCOPED_TRACE(distribution == NoiseDistribution::kUniform ? "uniform" : "Gaussian");
    const EstimateResult result = compute(small_campaign(Mode::kFirmware, distribution));
    EXPECT_LE(result.ekf_mw.standard_deviation(), 1.1 * result.bound_mw);
    EXPECT_GE(result.ekf_mw.standard_deviation(), 0.95 * result.bound_mw);
  }
}

TEST(EstimateCampaign, WrongParametersGiveAtLeastTheAccuracyOfTable5) {
  EstimateOptions options = small_campaign(Mode::kFirmware);
  options.parameter_error = 0.05;
  EXPECT_GE(within(compute(options), 0.04), 0.77);
}

// Reference values from an independent program: 3.585 MW for samples 1 … 50, 5.006 for 1 … 40.
TEST(EstimateCampaign, TheBoundEqualsAnIndependentCalculation) {
  const double sigma_hz = 0.01 / std::sqrt(3.0);
  EXPECT_NEAR(cramer_rao_mw(ieee24(), 500.0, 1, 50, sigma_hz), 3.585, 0.001);
  EXPECT_NEAR(cramer_rao_mw(ieee24(), 500.0, 1, 40, sigma_hz), 5.006, 0.001);
}

TEST(EstimateCampaign, IsTheSameOnAnyNumberOfThreads) {
  const EstimateResult one = compute(small_campaign(Mode::kFirmware), 1);
  for (const std::size_t threads : {2U, 3U}) {
    const EstimateResult other = compute(small_campaign(Mode::kFirmware), threads);
    EXPECT_EQ(other.ekf_mw.mean(), one.ekf_mw.mean());
    EXPECT_EQ(other.ekf_mw.standard_deviation(), one.ekf_mw.standard_deviation());
    for (std::size_t bin = 0; bin < one.ekf_mw.bins(); ++bin) {
      ASSERT_EQ(other.ekf_mw.in_bin(bin), one.ekf_mw.in_bin(bin));
      ASSERT_EQ(other.lse_mw.in_bin(bin), one.lse_mw.in_bin(bin));
    }
  }
}

// The range of one of three processes.
class OneOfThree final : public Reduction {
 public:
  explicit OneOfThree(std::uint64_t number) : number_(number) {}
  Range share(std::uint64_t blocks) const override {
    return {blocks * number_ / 3, blocks * (number_ + 1) / 3};
  }
  void add_up(std::vector<Histogram>&, std::uint64_t&) const override {}

 private:
  std::uint64_t number_;
};

TEST(EstimateCampaign, ProcessesAddUpToTheSameBitsAndASinkGetsAllTrajectories) {
  const EstimateOptions options = small_campaign(Mode::kFirmware);
  const EstimateResult whole = compute(options);
  Histogram sum(whole.ekf_mw.low(), 1000.0, whole.ekf_mw.bins());
  for (std::uint64_t number = 0; number < 3; ++number) {
    const OneOfThree process(number);
    Execution execution;
    execution.reduction = &process;
    const EstimateResult part = estimate(ieee24(), options, execution);
    EXPECT_LT(part.trajectories, options.trajectories);
    sum.merge(part.ekf_mw);
    std::atomic<std::uint64_t> given{0};
    estimate(ieee24(), options, execution,
             [&](std::uint64_t, const float*, std::size_t count) { given += count; });
    EXPECT_EQ(given, options.trajectories);
  }
  EXPECT_EQ(sum.count(), whole.ekf_mw.count());
  EXPECT_EQ(sum.mean(), whole.ekf_mw.mean());
  EXPECT_EQ(sum.standard_deviation(), whole.ekf_mw.standard_deviation());
  EXPECT_EQ(sum.largest(), whole.ekf_mw.largest());
}

TEST(EstimateCampaign, ATrajectoryDoesNotDependOnTheNumberOfTrajectories) {
  EstimateOptions options = small_campaign(Mode::kFirmware);
  const auto first = trajectory(ieee24(), options, 12345);
  options.trajectories = 100000;
  EXPECT_EQ(trajectory(ieee24(), options, 12345), first);
  EXPECT_NE(trajectory(ieee24(), options, 12346), first);
  options.seed = 2;
  EXPECT_NE(trajectory(ieee24(), options, 12345), first);
}

// The vectorised estimators against the firmware's, which an outlet runs with single floats.
TEST(EstimateCampaign, EveryEstimateEqualsAnOutletsToTheLastBit) {
  EstimateOptions options = small_campaign(Mode::kFirmware);
  options.instant = LossInstant::kBetweenReports;
  options.trajectories = 2000;
  std::vector<float> estimates(options.trajectories);
  Execution execution;
  execution.threads = 2;
  estimate(ieee24(), options, execution, [&](std::uint64_t first, const float* mw, std::size_t n) {
    std::memcpy(&estimates[first], mw, n * sizeof *mw);
  });
  const gs::outlet::Settings settings = estimate_settings(ieee24());
  for (std::uint64_t number = 0; number < options.trajectories; ++number) {
    gs::outlet::LossEstimator<float> outlet;
    const std::vector<float> deviations_hz = trajectory(ieee24(), options, number);
    for (std::size_t k = 0; k < deviations_hz.size(); ++k) {
      take(settings, settings.response, outlet, deviations_hz[k], static_cast<int>(k));
    }
    ASSERT_EQ(bits_of(outlet.ekf.loss_mw), bits_of(estimates[number])) << number;
  }
}

TEST(EstimateCampaign, WhenStoppedReturnsTheTrajectoriesSoFar) {
  EstimateOptions options = small_campaign(Mode::kFirmware);
  options.trajectories = 10000000;
  std::atomic<bool> stop{false};
  Execution execution;
  execution.stop = &stop;
  execution.progress = [&](double) { stop = true; };
  const EstimateResult result = estimate(ieee24(), options, execution);
  EXPECT_GT(result.trajectories, 0U);
  EXPECT_LT(result.trajectories, options.trajectories);
}

TEST(EstimateCampaign, RejectsOptionsOutOfRange) {
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    EstimateOptions options;
    options.loss_mw = bad;
    EXPECT_THROW(compute(options), std::invalid_argument);
  }
  EstimateOptions options;
  options.trajectories = 0;
  EXPECT_THROW(compute(options), std::invalid_argument);
  options = {};
  options.noise_hz = -0.1;
  EXPECT_THROW(compute(options), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::campaign
