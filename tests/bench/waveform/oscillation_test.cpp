// Oscillations that are laid over the frequency of a grid.
#include "example_references.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

namespace gsbench::waveform {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kToTheEnd = std::numeric_limits<double>::infinity();

TEST(Oscillation, RisesFromZeroWithoutAStepAtPhaseZero) {
  const Oscillation oscillation{2.0, 5.0, 0.4, 0.06};
  EXPECT_EQ(oscillation.deviation_hz(1.999), 0.0);
  EXPECT_EQ(oscillation.rocof_hz_s(1.999), 0.0);
  EXPECT_EQ(oscillation.deviation_hz(2.0), 0.0);
  EXPECT_NEAR(oscillation.rocof_hz_s(2.0), 0.06 * 2.0 * M_PI * 0.4, 1e-15);
  EXPECT_NEAR(oscillation.deviation_hz(2.625), 0.06, 1e-15) << "a quarter of 2.5 s later";
  EXPECT_NEAR(oscillation.deviation_hz(3.875), -0.06, 1e-15);
}

TEST(Oscillation, StartsWithAStepAtAnotherPhaseAndEndsAtItsEnd) {
  const Oscillation oscillation{2.0, 5.3, 0.4, 0.06, 90.0};
  EXPECT_EQ(oscillation.deviation_hz(std::nextafter(2.0, 0.0)), 0.0);
  EXPECT_NEAR(oscillation.deviation_hz(2.0), 0.06, 1e-15);
  EXPECT_GT(std::abs(oscillation.deviation_hz(std::nextafter(7.3, 0.0))), 0.01);
  EXPECT_EQ(oscillation.deviation_hz(7.3), 0.0);
  EXPECT_EQ(oscillation.rocof_hz_s(7.3), 0.0);
}

TEST(Oscillation, HasTheIntegralOfItsDeviationAsExcessPhase) {
  for (const double phase_deg : {0.0, 33.0, -120.0}) {
    const Oscillation oscillation{0.5, 2.0, 1.3, 0.06, phase_deg};
    EXPECT_EQ(oscillation.excess_cycles(0.5), 0.0);
    double cycles = 0.0;
    // By the midpoint rule: its error is 0.0005²/24·|d²f/dt²| < 5·10⁻⁸ of a cycle a second.
    const double step_s = 0.0005;
    for (int i = 0; i < 6000; ++i) {
      cycles += step_s * oscillation.deviation_hz((i + 0.5) * step_s);
      ASSERT_NEAR(oscillation.excess_cycles((i + 1) * step_s), cycles, 1e-7) << i;
    }
    EXPECT_EQ(oscillation.excess_cycles(3.0), oscillation.excess_cycles(1000.0));
  }
}

TEST(WithOscillations, AddsAllOscillationsToTheReference) {
  const Oscillation slow{1.0, kToTheEnd, 0.2, 0.05}, fast{2.0, 3.0, 1.0, 0.01, 45.0};
  const auto base = reference_from_losses(ieee24(), {{3.0, 500.0}});
  const auto both =
      with_oscillations(reference_from_losses(ieee24(), {{3.0, 500.0}}), {fast, slow});
  EXPECT_EQ(both->nominal_hz(), 50.0);
  for (double t_s = 0.0; t_s < 8.0; t_s += 0.13) {
    EXPECT_NEAR(both->frequency_hz(t_s) - base->frequency_hz(t_s),
                slow.deviation_hz(t_s) + fast.deviation_hz(t_s), 2e-14);
    EXPECT_NEAR(both->rocof_hz_s(t_s) - base->rocof_hz_s(t_s),
                slow.rocof_hz_s(t_s) + fast.rocof_hz_s(t_s), 1e-15);
    EXPECT_NEAR(both->excess_cycles(t_s) - base->excess_cycles(t_s),
                slow.excess_cycles(t_s) + fast.excess_cycles(t_s), 1e-15);
    EXPECT_EQ(both->voltage_pu(t_s), 1.0);
  }
}

TEST(WithOscillations, HasCornersAtTheirStartsAndEnds) {
  const auto reference = with_oscillations(reference_from_losses(ieee24(), {{3.0, 500.0}}),
                                           {{2.0, 3.0, 1.0, 0.01}, {1.0, kToTheEnd, 0.2, 0.05}});
  EXPECT_THAT(reference->corners_s(), ElementsAre(1.0, 2.0, 3.0, 5.0));
}

TEST(WithOscillations, RefusesInvalidValues) {
  const std::pair<Oscillation, const char*> refused[] = {
      {{-0.1, 1.0, 0.4, 0.06}, "time in s is -0.1"},
      {{0.0, 0.0, 0.4, 0.06}, "duration in s is 0"},
      {{0.0, std::nan(""), 0.4, 0.06}, "duration in s is nan"},
      {{0.0, 1.0, 0.049, 0.06}, "frequency in Hz is 0.049; it must be from 0.05 to 5"},
      {{0.0, 1.0, 5.1, 0.06}, "frequency in Hz is 5.1"},
      {{0.0, 1.0, 0.4, 1.1}, "amplitude in Hz is 1.1; it must be from 0 to 1"},
      {{0.0, 1.0, 0.4, 0.06, 361.0}, "phase in degrees is 361"},
  };
  for (const auto& [oscillation, message] : refused) {
    EXPECT_THAT(
        [one = oscillation] {
          return with_oscillations(reference_from_points(50.0, {{0.0, 50.0}}), {one});
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
  }
}

}  // namespace
}  // namespace gsbench::waveform
