// Cascades, ramps, returns, faults and oscillations in a closed loop: outlets keep the frequency
// and shed no more than clairvoyants, which know the state of the grid at once and each loss 0.3 to
// 0.96 s after it happens.
#include <algorithm>
#include <cctype>
#include <string>

#include <gtest/gtest.h>

#include <fleet/closed_loop.hpp>
#include <profile/load.hpp>

namespace gsbench::fleet {
namespace {

constexpr double kNadirMargin_hz = 0.020;
constexpr double kShedFactor = 1.15;
constexpr double kShedMargin_mw = 10.0;

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

class Cascade : public testing::TestWithParam<const char*> {};

TEST_P(Cascade, IsAnsweredAsWellAsByClairvoyants) {
  const profile::Plan plan = profile::load_profile(GSBENCH_SOURCE_DIR "/profiles/cascades/" +
                                                   std::string(GetParam()) + ".toml");
  double lowest_hz = plan.grid.nominal_hz;
  double most_mw = 0.0;
  for (const Strategy strategy : all_strategies()) {
    if (knows_loss_after_s(strategy)) {
      const ClosedLoopResult known = result_of(plan, strategy);
      lowest_hz = std::min(lowest_hz, known.nadir_hz);
      most_mw = std::max(most_mw, known.shed_mw);
    }
  }
  const ClosedLoopResult outlets = result_of(plan, Strategy::kGsbench);
  EXPECT_GE(outlets.nadir_hz, lowest_hz - kNadirMargin_hz);
  EXPECT_LE(outlets.shed_mw, most_mw > 0.0 ? kShedFactor * most_mw + kShedMargin_mw : 0.0);
  if (lowest_hz < plan.grid.threshold_hz + 0.1 && most_mw > kShedMargin_mw) {
    EXPECT_GT(outlets.shed_mw, 0.5 * most_mw);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Cascade,
                         testing::Values("two-losses-half-a-second-apart",
                                         "second-loss-after-two-seconds", "three-losses",
                                         "ramp-of-three-seconds", "low-frequency-before",
                                         "dip-at-the-loss", "phase-steps-after-the-loss",
                                         "loss-that-returns", "oscillation-then-loss",
                                         "oscillations-alone"),
                         [](const testing::TestParamInfo<const char*>& each) {
                           std::string name = each.param;
                           for (char& c : name) {
                             c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace gsbench::fleet
