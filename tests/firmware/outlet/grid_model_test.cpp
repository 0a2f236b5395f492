// The grid in state-space form: the same response as in closed form, for every damping.
#include <firmware_test/settings.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>
#include <outlet/grid_model.hpp>

namespace gs::outlet {
namespace {

using gsbench::grid::SfrModel;

SfrModel model_with_inertia(double inertia_s, double damping_pu) {
  gsbench::grid::Grid grid = test::ieee24();
  grid.damping_pu = damping_pu;
  grid.plants[0].inertia_s = inertia_s;
  return SfrModel(grid);
}

TEST(GridStep, FollowsTheClosedFormForEveryDampingAndStep) {
  for (const SfrModel& model : {model_with_inertia(9.2, 2.5), model_with_inertia(2.0, 1.0)}) {
    for (const double step_s : {0.016, 0.036, 0.1, 0.5}) {
      const GridStep step = grid_step(test::response_of(model), static_cast<float>(step_s));
      GridState state = {0.0F, 0.0F, 500.0F};
      double phase_cycles = 0.0;
      for (int n = 1; n * step_s <= 8.0; ++n) {
        phase_cycles +=
            static_cast<double>(step.to[kPhase][kDeviation] * state.deviation_hz +
                                step.to[kPhase][kUnloadedRocof] * state.unloaded_rocof_hz_s +
                                step.to[kPhase][kLoss] * state.loss_mw);
        state = advanced(step, state);
        const double expected_hz = 500.0 * model.unit_deviation_hz(n * step_s);
        ASSERT_NEAR(static_cast<double>(state.deviation_hz), expected_hz, 2e-5) << step_s;
        ASSERT_NEAR(phase_cycles, 500.0 * model.unit_phase_cycles(n * step_s), 1e-4) << step_s;
      }
      EXPECT_LT(state.deviation_hz, -0.3F);
    }
  }
}

TEST(GridStep, EquilibriumStays) {
  const SfrModel model = model_with_inertia(9.2, 2.5);
  const Response response = test::response_of(model);
  const GridStep step = grid_step(response, 0.1F);
  const GridState start = {-100.0F * response.gain_hz_per_mw,
                           100.0F * response.gain_hz_per_mw * response.initial_slope_per_s, 100.0F};
  GridState state = start;
  for (int n = 0; n < 100; ++n) {
    state = advanced(step, state);
  }
  EXPECT_NEAR(state.deviation_hz, start.deviation_hz, 1e-5F);
  EXPECT_NEAR(state.unloaded_rocof_hz_s, start.unloaded_rocof_hz_s, 1e-5F);
}

}  // namespace
}  // namespace gs::outlet
