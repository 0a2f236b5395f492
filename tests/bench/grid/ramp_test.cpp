// Power that is lost linearly over a time, compared with a numerical integration of the model.

#include <grid_test/example_grids.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>

namespace gsbench::grid {
namespace {

// Deviation in Hz, lag of the governors in Hz, integral of the deviation in cycles.
struct Course {
  double deviation_hz = 0.0;
  double lag_hz = 0.0;
  double cycles = 0.0;

  Course plus(const Course& slope, double step_s) const {
    return {deviation_hz + step_s * slope.deviation_hz, lag_hz + step_s * slope.lag_hz,
            cycles + step_s * slope.cycles};
  }
};

// The model of Fig. 1 as two differential equations, integrated by the Runge–Kutta method of fourth
// order. Changes must start and end at multiples of kStep_s.
class Integrated {
 public:
  static constexpr double kStep_s = 0.001;

  Integrated(const Grid& grid, std::vector<PowerChange> changes)
      : grid_(grid), model_(grid), changes_(std::move(changes)) {}

  void advance() {
    const double t_s = time_s();
    const double from_mw = lost_mw(t_s, true);
    const double to_mw = lost_mw(t_s + kStep_s, false);
    const double middle_mw = 0.5 * (from_mw + to_mw);
    const Course a = slope(now, from_mw);
    const Course b = slope(now.plus(a, 0.5 * kStep_s), middle_mw);
    const Course c = slope(now.plus(b, 0.5 * kStep_s), middle_mw);
    const Course d = slope(now.plus(c, kStep_s), to_mw);
    now = now.plus(a, kStep_s / 6.0)
              .plus(b, kStep_s / 3.0)
              .plus(c, kStep_s / 3.0)
              .plus(d, kStep_s / 6.0);
    ++steps_;
  }
  double time_s() const { return kStep_s * steps_; }
  // Right-hand limit.
  double rocof_hz_s() const { return slope(now, lost_mw(time_s(), true)).deviation_hz; }

  Course now;

 private:
  // At a step, the limit from the right or from the left.
  double lost_mw(double t_s, bool right) const {
    constexpr double kSameTime_s = 1e-9;
    double sum_mw = 0.0;
    for (const PowerChange& change : changes_) {
      const double since_s = t_s - change.at_s;
      const double part = change.ramp_s > 0.0
                              ? std::clamp(since_s / change.ramp_s, 0.0, 1.0)
                              : (since_s > (right ? -kSameTime_s : kSameTime_s) ? 1.0 : 0.0);
      sum_mw += part * change.power_mw;
    }
    return sum_mw;
  }
  Course slope(const Course& at, double lost_mw) const {
    const double gain = grid_.gain_km / model_.droop_pu();
    const double prompt = grid_.damping_pu + gain * grid_.reheat_fraction;
    return {(-prompt * at.deviation_hz - gain * at.lag_hz -
             grid_.nominal_hz * lost_mw / grid_.base_mw) /
                (2.0 * model_.inertia_s()),
            ((1.0 - grid_.reheat_fraction) * at.deviation_hz - at.lag_hz) / grid_.reheat_s,
            at.deviation_hz};
  }

  Grid grid_;
  SfrModel model_;
  std::vector<PowerChange> changes_;
  int steps_ = 0;
};

// The error of the integration is below (0.001 s · 5/s)⁴/120 of the values, which are about 1.
constexpr double kIntegration = 1e-10;

TEST(Ramp, EqualsTheIntegratedModelForAnyDamping) {
  const std::vector<PowerChange> changes = {
      {1.0, 500.0, 3.0}, {2.0, -300.0, 0.5}, {2.5, -100.0}, {6.0, 80.0, 0.001}};
  for (const Grid& grid : {ieee24(), overdamped_grid(), grid_of_zeta(1.0), first_order_grid()}) {
    const FrequencyResponse response(SfrModel(grid), changes);
    Integrated integrated(grid, changes);
    double lowest_hz = 0.0;
    while (integrated.time_s() < 15.0) {
      integrated.advance();
      const double t_s = integrated.time_s();
      ASSERT_NEAR(response.frequency_hz(t_s) - 50.0, integrated.now.deviation_hz, kIntegration)
          << t_s;
      ASSERT_NEAR(response.excess_cycles(t_s), integrated.now.cycles, kIntegration) << t_s;
      ASSERT_NEAR(response.rocof_hz_s(t_s), integrated.rocof_hz_s(), kIntegration) << t_s;
      lowest_hz = std::min(lowest_hz, integrated.now.deviation_hz);
    }
    EXPECT_LT(lowest_hz, -0.1) << "the course has something to compare";
  }
}

TEST(Ramp, HasASlopeWithoutStepsAndEndsAtTheSameFinalValueAsAStep) {
  const SfrModel model(ieee24());
  EXPECT_EQ(model.unit_rocof_hz_s(0.0, 2.0), 0.0);
  EXPECT_LT(model.unit_rocof_hz_s(0.01, 2.0), 0.0);
  EXPECT_NEAR(model.unit_rocof_hz_s(2.0 - 1e-9, 2.0), model.unit_rocof_hz_s(2.0 + 1e-9, 2.0),
              1e-12);
  EXPECT_NEAR(model.unit_deviation_hz(1000.0, 2.0), model.unit_deviation_hz(1000.0), 1e-15);
}

// The mean lag of a ramp is half of its length.
TEST(Ramp, KeepsItsPhaseAfterALongTime) {
  const SfrModel model(ieee24());
  const double late_s = 1e5;
  for (const double ramp_s : {0.001, 3.0}) {
    const double lag_cycles =
        model.unit_phase_cycles(late_s, ramp_s) - model.unit_phase_cycles(late_s);
    // One rounding of the 78 cycles that have passed.
    EXPECT_NEAR(lag_cycles, 0.5 * ramp_s * model.gain_hz_per_mw(), 3e-14) << ramp_s;
  }
}

// A ramp is the mean of steps over its length: it differs from the step in its middle by T²/24 of
// the second derivative, which is below 4·10⁻⁴ Hz/s² per MW here.
TEST(Ramp, ApproachesAStepAsItGetsShorter) {
  const SfrModel model(ieee24());
  for (const double ramp_s : {0.1, 0.01, 0.001}) {
    const double later_hz = model.unit_deviation_hz(1.0 - 0.5 * ramp_s);
    EXPECT_NEAR(model.unit_deviation_hz(1.0, ramp_s), later_hz, 2e-5 * ramp_s * ramp_s);
    EXPECT_NE(model.unit_deviation_hz(1.0, ramp_s), model.unit_deviation_hz(1.0));
  }
}

TEST(PowerChange, HasChangedInProportionToTheTimeOfItsRamp) {
  const PowerChange step{3.0, 500.0}, ramp{3.0, -500.0, 2.0};
  EXPECT_EQ(step.changed_mw(0.0), 500.0);
  EXPECT_EQ(ramp.changed_mw(0.0), 0.0);
  EXPECT_EQ(ramp.changed_mw(0.5), -125.0);
  EXPECT_EQ(ramp.changed_mw(2.0), -500.0);
  EXPECT_EQ(ramp.changed_mw(9.0), -500.0);
}

}  // namespace
}  // namespace gsbench::grid
