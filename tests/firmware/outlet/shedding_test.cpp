// The power that must be shed: what it predicts is what the grid does.
#include <firmware_test/settings.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>
#include <outlet/shedding.hpp>

namespace gs::outlet {
namespace {

using gsbench::grid::FrequencyResponse;
using gsbench::grid::PowerChange;
using gsbench::grid::SfrModel;

constexpr float kLimit_hz = -0.5F;

const SfrModel& model() {
  static const SfrModel kModel(test::ieee24());
  return kModel;
}

GridState state_after(const std::vector<PowerChange>& changes, double t_s) {
  const FrequencyResponse response(model(), changes);
  double lost_mw = 0.0;
  for (const PowerChange& change : changes) {
    lost_mw += change.power_mw;
  }
  const double unloaded_hz_s =
      response.rocof_hz_s(t_s) + model().gain_hz_per_mw() * model().initial_slope_per_s() * lost_mw;
  return {static_cast<float>(response.frequency_hz(t_s) - model().nominal_hz()),
          static_cast<float>(unloaded_hz_s), static_cast<float>(lost_mw)};
}

double nadir_hz(std::vector<PowerChange> changes, double from_s) {
  const FrequencyResponse response(model(), std::move(changes));
  double lowest_hz = 0.0;
  for (double t_s = from_s; t_s < from_s + 12.0; t_s += 0.005) {
    lowest_hz = std::min(lowest_hz, response.frequency_hz(t_s) - model().nominal_hz());
  }
  return lowest_hz;
}

Shedding shedding_at(const std::vector<PowerChange>& changes, double t_s) {
  return shedding(grid_step(test::response_of(model()), kLookAhead_s), state_after(changes, t_s),
                  kLimit_hz);
}

TEST(Shedding, JustKeepsTheNadirWhateverHappenedBefore) {
  const std::vector<PowerChange> cases[] = {{{0.0, 500.0}},
                                            {{0.0, 300.0}, {0.5, 300.0}},
                                            {{0.0, 250.0}, {2.0, 350.0}},
                                            {{-60.0, 92.0}, {0.0, 300.0}},
                                            {{0.0, 600.0}, {0.3, 200.0}, {0.6, -300.0}}};
  for (const auto& changes : cases) {
    const double now_s = std::max(changes.back().at_s, 0.0) + 0.7;
    const Shedding found = shedding_at(changes, now_s);
    EXPECT_NEAR(static_cast<double>(found.nadir_hz), nadir_hz(changes, now_s), 1e-3);
    const auto with_shed_mw = [&](double power_mw) {
      std::vector<PowerChange> all = changes;
      all.push_back({now_s, -power_mw});
      return nadir_hz(all, now_s);
    };
    double lost_mw = 0.0;
    for (const PowerChange& change : changes) {
      lost_mw += change.power_mw;
    }
    const double goal_hz = std::min(static_cast<double>(kLimit_hz),
                                    with_shed_mw(lost_mw) - static_cast<double>(kOutOfReach_hz));
    if (found.required_mw > 0.0F) {
      EXPECT_NEAR(with_shed_mw(static_cast<double>(found.required_mw)), goal_hz, 1.5e-3);
    } else {
      EXPECT_GE(nadir_hz(changes, now_s), goal_hz);
    }
  }
}

TEST(Shedding, IsNoneBelowTheThreshold) {
  EXPECT_EQ(shedding_at({{0.0, 345.0}}, 0.7).required_mw, 0.0F);
  EXPECT_GT(shedding_at({{0.0, 360.0}}, 0.7).required_mw, 1.0F);
  EXPECT_EQ(shedding_at({{0.0, 500.0}, {0.3, -500.0}}, 0.7).required_mw, 0.0F);
}

// After 1.5 s of 900 MW the frequency is so low that f_s cannot be kept: the last 10 mHz are not
// worth hundreds of megawatts.
TEST(Shedding, OutOfReachKeepsNearTheBest) {
  const std::vector<PowerChange> changes = {{0.0, 900.0}};
  const Shedding found = shedding_at(changes, 1.5);
  const double best_hz = nadir_hz({{0.0, 900.0}, {1.5, -900.0}}, 1.5);
  EXPECT_LT(best_hz, static_cast<double>(kLimit_hz));
  const double kept_hz =
      nadir_hz({{0.0, 900.0}, {1.5, -static_cast<double>(found.required_mw)}}, 1.5);
  EXPECT_NEAR(kept_hz, best_hz - static_cast<double>(kOutOfReach_hz), 1.5e-3);
  EXPECT_LT(found.required_mw, 750.0F);
}

}  // namespace
}  // namespace gs::outlet
