// Outlets that have their switching-off frequencies alone, in stages: after any loss they shed
// about as much as would have kept f_s if shed at once, and stop the fall well above the relays.
#include <control_centre/threshold.hpp>
#include <test_support/ieee24.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <fleet/scenario.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::fleet {
namespace {

using campaign::Execution;
using campaign::NoiseDistribution;
using control_centre::Rules;

// As many groups as the grid has blocks, of their power, or a thousand with 2.6 times the threshold
// loss.
Fleet fleet_on(const grid::Grid& grid, bool many, std::uint64_t seed) {
  FleetOptions options;
  double power_mw = 2.6 * control_centre::threshold_mw(grid, Rules::kPaper);
  if (!many) {
    options.groups = grid.blocks.size();
    power_mw = 0.0;
    for (const grid::Block& block : grid.blocks) {
      power_mw += block.power_mw;
    }
  }
  options.per_group = many ? 1 : 50;
  options.seed = seed;
  options.most_w =
      2e6 * power_mw / static_cast<double>(options.groups * options.per_group) - options.least_w;
  return make_fleet(options);
}

struct Limits {
  double least_shed;  // per power that keeps f_s if shed at once, or all there is
  double most_shed;
  double nadir_hz;
};

void expect_backup(const grid::Grid& grid, bool many, const std::vector<double>& losses_mw,
                   const Limits& limits) {
  const double threshold_mw = control_centre::threshold_mw(grid, Rules::kPaper);
  Execution execution;
  execution.threads = 2;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Fleet fleet = fleet_on(grid, many, seed);
    ScenarioOptions options;
    options.control = Control::kSwitchOff;
    options.seed = seed;
    options.duration_s = 6.0;
    options.distribution = seed == 3U ? NoiseDistribution::kGaussian : NoiseDistribution::kUniform;
    for (const double loss_mw : losses_mw) {
      SCOPED_TRACE(grid.name + ", seed " + std::to_string(seed) + ", loss " +
                   std::to_string(loss_mw));
      options.loss_mw = loss_mw;
      const ScenarioResult result = simulate(grid, fleet, options, execution).value();
      const double at_once_mw = loss_mw - threshold_mw;
      EXPECT_GE(result.shed.power_mw,
                std::min(limits.least_shed * at_once_mw, fleet.power_mw * 0.999));
      EXPECT_LE(result.shed.power_mw, limits.most_shed * at_once_mw);
      EXPECT_GE(result.nadir_hz, limits.nadir_hz);
    }
  }
}

const std::vector<double> kLosses_mw = {450.0, 500.0, 550.0, 600.0, 650.0, 700.0, 750.0, 800.0};

TEST(Backup, InAThousandBlocksStopsTheFallWithoutSheddingAll) {
  expect_backup(test::ieee24(), true, kLosses_mw, {0.85, 1.1, 49.30});
}

// The grid's ten blocks of 30 MW; more than 700 MW are beyond their power.
TEST(Backup, InTenBlocksStopsTheFallWithoutSheddingAll) {
  expect_backup(test::ieee24(), false, {450.0, 500.0, 550.0, 600.0, 650.0, 700.0},
                {0.8, 1.2, 49.32});
}

TEST(Backup, OnA60HzIslandStopsTheFallAboveTheRelays) {
  const grid::Grid grid = profile::load_grid("island-60hz");
  const double threshold_mw = control_centre::threshold_mw(grid, Rules::kPaper);
  std::vector<double> losses_mw;
  for (const double part : {1.28, 1.42, 1.7, 2.0, 2.27}) {
    losses_mw.push_back(part * threshold_mw);
  }
  expect_backup(grid, true, losses_mw, {0.85, 1.15, 59.30});
}

// Its five blocks, 200 MW.
TEST(Backup, InFiveBlocksOnA60HzIslandShedsAllOfThemInTime) {
  expect_backup(profile::load_grid("island-60hz"), false, {600.0, 650.0}, {0.8, 1.2, 59.39});
}

// Three times as fast as in ieee24: H is 2 s on all plants.
TEST(Backup, InAGridWithLittleInertiaIsFastEnough) {
  grid::Grid grid;
  grid.name = "little inertia";
  grid.base_mw = 1000.0;
  grid.load_mw = 1000.0;
  grid.damping_pu = 1.0;
  grid.plants = {{"all", 1000.0, 2.0, 0.05}};
  const double threshold_mw = control_centre::threshold_mw(grid, Rules::kPaper);
  expect_backup(grid, true, {1.28 * threshold_mw, 1.7 * threshold_mw, 2.0 * threshold_mw},
                {0.85, 1.15, 49.30});
}

TEST(Backup, DoesNotActAfterLossesThatKeepTheLimitOrNearlySo) {
  for (const double loss_mw : {300.0, 351.9, 365.0}) {
    ScenarioOptions options;
    options.control = Control::kSwitchOff;
    options.loss_mw = loss_mw;
    Execution execution;
    EXPECT_EQ(simulate(test::ieee24(), fleet_on(test::ieee24(), true, 1), options, execution)
                  ->shed.outlets,
              0U)
        << loss_mw;
  }
}

}  // namespace
}  // namespace gsbench::fleet
