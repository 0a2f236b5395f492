// Compares the estimates of the Cortex-M4F image with those of a campaign, trajectory by
// trajectory.
#include "calls.hpp"
#include <cortex_m4/beside.hpp>
#include <cortex_m4/emulated_outlet.hpp>
#include <test_support/ieee24.hpp>

#include <cstring>
#include <iostream>

#include <gtest/gtest.h>

#include <campaign/estimates.hpp>
#include <outlet/estimator.hpp>

namespace gs::test {
namespace {

using gsbench::campaign::EstimateOptions;
using gsbench::campaign::LossInstant;
using gsbench::campaign::NoiseDistribution;
using gsbench::test::ieee24;
using outlet::EstimatorState;

constexpr std::uint32_t kTrajectories = 1000;
constexpr std::uint32_t kSamples = gsbench::campaign::kSamples;

EstimateOptions options(NoiseDistribution distribution) {
  EstimateOptions options;
  options.distribution = distribution;
  options.instant = LossInstant::kBetweenReports;
  options.trajectories = kTrajectories;
  return options;
}

std::vector<float> by_campaign(const EstimateOptions& options) {
  std::vector<float> estimates(kTrajectories);
  estimate(ieee24(), options, {}, [&](std::uint64_t first, const float* mw, std::size_t count) {
    std::memcpy(&estimates[first], mw, count * sizeof *mw);
  });
  return estimates;
}

std::vector<EstimatorState> by_image(const std::string& image, const EstimateOptions& options) {
  EmulatedOutlet outlet;
  outlet.start(image);
  outlet.line().wait_for(wire::UplinkKind::kHello);  // it runs, the FPU is on
  ProgramBeside program(outlet.machine(), GSBENCH_CALLS, "make_calls");

  std::vector<float> deviations_hz;
  for (std::uint32_t number = 0; number < kTrajectories; ++number) {
    const auto one = trajectory(ieee24(), options, number);
    deviations_hz.insert(deviations_hz.end(), one.begin(), one.end());
  }
  const outlet::Settings settings = gsbench::campaign::estimate_settings(ieee24());
  const outlet::Line line = {};
  std::vector<EstimatorState> states(kTrajectories);
  Calls calls;
  calls.begin = address_of_symbol(
      image, "gs::outlet::begin(gs::outlet::EstimatorState&, gs::outlet::Baseline const&)");
  calls.observe = address_of_symbol(
      image,
      "gs::outlet::observe(gs::outlet::Settings const&, float, gs::outlet::EstimatorState&, bool, "
      "float, gs::outlet::LineOf<float> const&)");
  calls.settings = program.put(bytes_of(&settings));
  calls.line = program.put(bytes_of(&line));
  calls.deviations_hz = program.put(bytes_of(deviations_hz.data(), deviations_hz.size()));
  calls.states = program.put(Bytes(states.size() * sizeof(EstimatorState), 0xA5));
  calls.trajectories = kTrajectories;
  calls.samples = kSamples;
  calls.nominal_hz = 50.0F;
  program.call(program.put(bytes_of(&calls)));
  program.get(calls.states, states);
  return states;
}

// Number of estimates that differ in any bit.
int different(const std::vector<EstimatorState>& there, const std::vector<float>& here) {
  int count = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    count += bytes_of(&there[i].ekf.loss_mw) == bytes_of(&here[i]) ? 0 : 1;
  }
  return count;
}

class CampaignImage : public testing::TestWithParam<const char*> {};

TEST_P(CampaignImage, EstimatesOfAThousandTrajectoriesEqualTheCampaignsToTheLastBit) {
  for (const NoiseDistribution distribution :
       {NoiseDistribution::kUniform, NoiseDistribution::kGaussian}) {
    const std::vector<EstimatorState> there = by_image(GetParam(), options(distribution));
    for (const EstimatorState& state : there) {
      ASSERT_EQ(state.reports, kSamples);
      ASSERT_GT(state.ekf.loss_mw, 400.0F);
    }
    EXPECT_EQ(different(there, by_campaign(options(distribution))), 0)
        << (distribution == NoiseDistribution::kUniform ? "uniform" : "Gaussian");
  }
}

INSTANTIATE_TEST_SUITE_P(Boards, CampaignImage,
                         testing::Values(GSBENCH_M4_IMAGE, GSBENCH_M4_IMAGE_OS),
                         [](const auto& image) {
                           return std::string(image.param) == GSBENCH_M4_IMAGE ? "O2" : "Os";
                         });

// An image with fused multiply-add must differ, otherwise the comparison above is not strict
// enough.
TEST(ContractedCampaignImage, HasDifferentEstimates) {
  const EstimateOptions uniform = options(NoiseDistribution::kUniform);
  const int count = different(by_image(GSBENCH_M4_IMAGE_CONTRACTED, uniform), by_campaign(uniform));
  std::cout << count << " of " << kTrajectories << " differ\n";
  EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace gs::test
