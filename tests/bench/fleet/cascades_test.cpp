// Cascades, ramps, returns, faults and oscillations in a closed loop: outlets keep the frequency
// and shed no more than clairvoyants, which know the state of the grid at once and each loss 0.3 to
// 0.96 s after it happens. `gsbench fleet --closed-loop --profile cascades` does the same with 1000
// outlets.
#include <test_support/shipped_profiles.hpp>

#include <string>

#include <gmock/gmock.h>

#include <fleet/limits.hpp>
#include <profile/load.hpp>

namespace gsbench::fleet {
namespace {

// 300 outlets with 1.5 MW to 4.5 MW each: as much load as a million of the study, in fewer steps.
const Fleet& three_hundred_outlets() {
  static const Fleet fleet = [] {
    FleetOptions few;
    few.groups = 300;
    few.per_group = 1;
    few.least_w = 1.5e6;
    few.most_w = 4.5e6;
    return make_fleet(few);
  }();
  return fleet;
}

ClosedLoopResult result_of(const profile::Plan& plan, Strategy strategy) {
  ClosedLoopOptions options;
  options.after_loss_s = 8.0;
  campaign::Execution execution;
  execution.threads = 2;
  return simulate_closed_loop(plan, three_hundred_outlets(), strategy, options, execution).value();
}

class Cascade : public testing::TestWithParam<std::string> {};

TEST_P(Cascade, IsAnsweredAsWellAsByClairvoyants) {
  const profile::Plan plan = profile::load_profile(GetParam());
  std::vector<StrategyResult> clairvoyants;
  for (const Strategy strategy : all_strategies()) {
    if (knows_loss_after_s(strategy)) {
      clairvoyants.push_back({strategy, result_of(plan, strategy)});
    }
  }
  const ClosedLoopLimits limits = limits_of(plan, clairvoyants_of(clairvoyants).value());
  EXPECT_THAT(missed_limits(result_of(plan, Strategy::kGsbench), limits), testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Of, Cascade, testing::ValuesIn(test::shipped_profiles("cascades/")),
                         test::test_name);

}  // namespace
}  // namespace gsbench::fleet
