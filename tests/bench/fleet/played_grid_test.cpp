// The grid of a profile with load shed while it is played: voltage and frequency, compared with
// those of a profile that has the same load as losses from the start.
#include "played_grid.hpp"

#include <test_support/ieee24.hpp>

#include <gtest/gtest.h>

#include <fleet/closed_loop.hpp>

namespace gsbench::fleet {
namespace {

using profile::Plan;

constexpr std::int64_t kRate_hz = 8000;
constexpr std::size_t kPiece = 64;

struct Shed {
  std::int64_t tick;
  double power_mw;
};

// Two in one block of the synthesizer, one at the start of a piece, and load that returns.
const std::vector<Shed> kSheds = {{9001, 30.0}, {9030, 50.5}, {9152, 70.0}, {15999, -40.0}};

Plan disturbed_plan() {
  Plan plan = plan_of_loss(test::ieee24(), 500.0, 1.003, 0.0, 1);
  plan.stimulus.losses.push_back({1.5, 100.0, 0.25});
  plan.stimulus.signal.amplitude_steps = {{1.003, 0.08, 60.0}};
  plan.stimulus.signal.phase_jumps = {{1.126, 8.0}};
  plan.stimulus.signal.harmonics = {{5, 3.0, 30.0}};
  return plan;
}

double seconds(std::int64_t tick) {
  return static_cast<double>(tick) / static_cast<double>(kRate_hz);
}

TEST(PlayedGrid, LoadThatIsShedChangesTheVoltageFromItsSampleOn) {
  const Plan plan = disturbed_plan();
  Plan known = plan;
  for (const Shed& shed : kSheds) {
    known.stimulus.losses.push_back({seconds(shed.tick), -shed.power_mw});
  }
  PlayedGrid grid(plan);
  const waveform::Synthesizer expected = known.synthesizer();
  const waveform::Synthesizer without = plan.synthesizer();
  std::vector<float> played(kPiece);
  std::vector<float> wanted(kPiece);
  std::vector<float> unshed(kPiece);
  double largest = 0.0;
  double largest_change = 0.0;
  auto next = kSheds.begin();
  for (std::int64_t tick = 0; tick < 3 * kRate_hz; tick += kPiece) {
    // What is shed in these samples becomes known before them, and no earlier.
    for (; next != kSheds.end() && next->tick < tick + static_cast<std::int64_t>(kPiece); ++next) {
      grid.switch_off(seconds(next->tick), next->power_mw);
    }
    grid.render(tick, kPiece, played.data());
    expected.render(tick, kPiece, wanted.data());
    without.render(tick, kPiece, unshed.data());
    for (std::size_t i = 0; i < kPiece; ++i) {
      largest = std::max(largest, std::fabs(static_cast<double>(played[i] - wanted[i])));
      largest_change =
          std::max(largest_change, std::fabs(static_cast<double>(played[i] - unshed[i])));
    }
  }
  EXPECT_LT(largest, 3e-7);  // the rounding of a float
  EXPECT_GT(largest_change, 0.5);
}

TEST(PlayedGrid, StateIsThatOfAllLossesAndShedLoad) {
  const Plan plan = disturbed_plan();
  std::vector<grid::PowerChange> all = plan.stimulus.losses;
  PlayedGrid grid(plan);
  for (const Shed& shed : kSheds) {
    grid.switch_off(seconds(shed.tick), shed.power_mw);
    all.push_back({seconds(shed.tick), -shed.power_mw});
  }
  const grid::FrequencyResponse response(grid::SfrModel(plan.grid), all);
  for (double t_s = 0.0; t_s < 6.0; t_s += 0.0137) {
    const GridState state = grid.state(t_s);
    EXPECT_NEAR(50.0 + state.deviation_hz, response.frequency_hz(t_s), 1e-11);
    EXPECT_NEAR(state.slope_hz_s, response.rocof_hz_s(t_s), 1e-11);
  }
  EXPECT_NEAR(grid.state(1.625).power_mw, 500.0 + 50.0 - 150.5, 1e-9);
  EXPECT_NEAR(grid.state(5.0).power_mw, 500.0 + 100.0 - 110.5, 1e-9);
}

}  // namespace
}  // namespace gsbench::fleet
