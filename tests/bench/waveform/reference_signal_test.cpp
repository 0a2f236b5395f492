#include "example_references.hpp"

#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>

namespace gsbench::waveform {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<recording::TracePoint> random_points(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> step_s(0.001, 5.0);
  std::uniform_real_distribution<double> frequency_hz(45.0, 55.0);
  std::vector<recording::TracePoint> points;
  double t_s = -10.0;
  for (int i = 0; i < 20; ++i) {
    // Some points repeat the previous frequency: a plateau must remain one.
    const bool plateau = i > 0 && generator() % 4 == 0;
    points.push_back({t_s, plateau ? points.back().frequency_hz : frequency_hz(generator)});
    t_s += step_s(generator);
  }
  return points;
}

// Rounding error of 55 Hz after about ten operations.
constexpr double kRounding_hz = 1e-12;

TEST(PointReference, PassesThroughEachPointExactly) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto points = random_points(seed);
    const auto reference = reference_from_points(50.0, points);
    for (const auto& point : points) {
      EXPECT_EQ(reference->frequency_hz(point.t_s), point.frequency_hz);
    }
  }
}

TEST(PointReference, IsMonotoneBetweenPointsWithoutOvershoot) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const auto points = random_points(seed);
    const auto reference = reference_from_points(50.0, points);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double span_s = points[i + 1].t_s - points[i].t_s;
      const double direction = points[i + 1].frequency_hz - points[i].frequency_hz;
      double before_hz = points[i].frequency_hz;
      for (int step = 1; step <= 200; ++step) {
        const double hz = reference->frequency_hz(points[i].t_s + span_s * step / 200.0);
        const double rise_hz = hz - before_hz;
        ASSERT_GE(direction == 0.0 ? -std::fabs(rise_hz) : std::copysign(1.0, direction) * rise_hz,
                  -kRounding_hz)
            << "seed " << seed << ", after point " << i;
        before_hz = hz;
      }
    }
  }
}

TEST(PointReference, EqualsPchipOfMatlabAndSciPy) {
  // Slopes by hand: at t = 1 (widths 1 and 2, secants −1 and −0.25) (5+4)/(5/−1+4/−0.25) = −3/7;
  // at t = 0 ((2+2)·(−1) + 0.25)/3 = −1.25; at t = 3 ((4+1)·(−0.25) + 2)/3 = 0.25, of the wrong
  // sign, hence 0.
  const auto reference = reference_from_points(50.0, {{0.0, 50.0}, {1.0, 49.0}, {3.0, 48.5}});
  EXPECT_NEAR(reference->rocof_hz_s(0.0), -1.25, kRounding_hz);
  EXPECT_NEAR(reference->rocof_hz_s(1.0), -3.0 / 7.0, kRounding_hz);
  EXPECT_NEAR(reference->rocof_hz_s(3.0 - 1e-9), 0.0, 1e-8);  // |d²f/dt²| < 1 there, times 1e-9 s
  // In the middle: the mean of the ends plus width/8 times the difference of the slopes.
  EXPECT_NEAR(reference->frequency_hz(0.5), 49.5 + (-1.25 + 3.0 / 7.0) / 8.0, kRounding_hz);
}

TEST(PointReference, IsAStraightLineThroughTwoPoints) {
  const auto reference = reference_from_points(50.0, {{1.0, 50.0}, {2.0, 40.0}});
  for (const double t_s : {1.0, 1.25, 1.5, 1.999}) {
    EXPECT_NEAR(reference->frequency_hz(t_s), 50.0 - 10.0 * (t_s - 1.0), kRounding_hz);
    EXPECT_NEAR(reference->rocof_hz_s(t_s), -10.0, kRounding_hz);
  }
}

TEST(PointReference, IsConstantBeforeTheFirstAndAfterTheLastPoint) {
  const auto reference = reference_from_points(50.0, {{1.0, 50.5}, {2.0, 49.0}});
  EXPECT_EQ(reference->frequency_hz(0.0), 50.5);
  EXPECT_EQ(reference->rocof_hz_s(0.5), 0.0);
  EXPECT_EQ(reference->frequency_hz(1e6), 49.0);
  EXPECT_EQ(reference->rocof_hz_s(2.0), 0.0);
  EXPECT_NEAR(reference->excess_cycles(1.0), 0.5, kRounding_hz);
}

TEST(PointReference, IntegratesItsFrequencyExactlyFromZero) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto points = random_points(seed);
    const auto reference = reference_from_points(50.0, points);
    EXPECT_EQ(reference->excess_cycles(0.0), 0.0);
    double cycles = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double from_s = points[i].t_s;
      const double to_s = points[i + 1].t_s;
      const double middle_hz = reference->frequency_hz(0.5 * (from_s + to_s));
      // Simpson's rule has no error for cubics.
      cycles += (to_s - from_s) / 6.0 *
                (points[i].frequency_hz + 4.0 * middle_hz + points[i + 1].frequency_hz - 300.0);
      EXPECT_NEAR(reference->excess_cycles(to_s) - reference->excess_cycles(points[0].t_s), cycles,
                  1e-11);
    }
  }
}

// A plain sum of a million doubles would have an error of about 10⁻⁷ here.
TEST(PointReference, DoesNotDriftOverAMillionPoints) {
  std::vector<recording::TracePoint> points;
  for (int i = 0; i <= 1'000'000; ++i) {
    points.push_back({static_cast<double>(i), i % 2 == 0 ? 50.1 : 50.7});
  }
  const auto reference = reference_from_points(50.0, points);
  // Each point is an extremum with slope zero, so each piece integrates to the mean of its ends.
  // The first and last piece may have another end slope: only inner ones are compared. In doubles,
  // 0.4 equals (50.1 + 50.7)/2 − 50 within 4·10⁻¹⁵, which is 4·10⁻⁹ for a million pieces.
  const double cycles = reference->excess_cycles(999'999.0) - reference->excess_cycles(1.0);
  EXPECT_NEAR(cycles, 0.4 * 999'998.0, 5e-9);
}

TEST(PointReference, HasACornerAtEachPoint) {
  const auto reference = reference_from_points(50.0, {{1.0, 50.5}, {2.0, 49.0}, {2.5, 49.5}});
  EXPECT_THAT(reference->corners_s(), ElementsAre(1.0, 2.0, 2.5));
}

TEST(PointReference, InterpolatesTheVoltageLinearly) {
  const auto reference =
      reference_from_points(50.0, {{0.0, 50.0, 1.0}, {2.0, 49.0, 0.0}, {4.0, 48.0, 0.2}});
  EXPECT_EQ(reference->voltage_pu(-1.0), 1.0);
  EXPECT_EQ(reference->voltage_pu(0.5), 0.75);
  EXPECT_EQ(reference->voltage_pu(2.0), 0.0);
  EXPECT_EQ(reference->voltage_pu(3.0), 0.1);
  EXPECT_EQ(reference->voltage_pu(9.0), 0.2);
}

TEST(PointReference, RefusesInvalidPointsWithTheirValue) {
  const std::pair<std::vector<recording::TracePoint>, const char*> refused[] = {
      {{}, "at least one"},
      {{{0, 50, 1}, {1, 50, 1}, {1, 49, 1}}, "point 3: time is 1 s"},
      {{{0, 50, 1}, {-1, 50, 1}}, "point 2: time is -1 s"},
      {{{std::nan(""), 50, 1}}, "point 1: time is nan s"},
      {{{0, 0, 1}}, "point 1: frequency is 0 Hz"},
      {{{0, HUGE_VAL, 1}}, "point 1: frequency is inf Hz"},
      {{{0, 50, -0.1}}, "point 1: voltage is -0.1 p.u."}};
  for (const auto& [points, message] : refused) {
    EXPECT_THAT([points = points] { return reference_from_points(50.0, points); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
  }
  EXPECT_THAT(
      [] {
        return reference_from_points(0.0, {{0, 50, 1}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("nominal frequency is 0 Hz")));
}

TEST(LossReference, EqualsTheFrequencyResponseOfTheGrid) {
  const grid::FrequencyResponse response(ieee24(), {{3.0, 500.0}, {4.0, -120.0}});
  const auto reference = reference_from_losses(ieee24(), {{3.0, 500.0}, {4.0, -120.0}});
  EXPECT_EQ(reference->nominal_hz(), 50.0);
  for (const double t_s : {0.0, 2.999, 3.0, 3.7, 4.0, 5.0, 60.0}) {
    EXPECT_EQ(reference->frequency_hz(t_s), response.frequency_hz(t_s));
    EXPECT_EQ(reference->rocof_hz_s(t_s), response.rocof_hz_s(t_s));
    EXPECT_EQ(reference->excess_cycles(t_s), response.excess_cycles(t_s));
    EXPECT_EQ(reference->voltage_pu(t_s), 1.0);
  }
}

TEST(LossReference, HasACornerAtEachLossInOrderOfTime) {
  const auto reference = reference_from_losses(ieee24(), {{4.0, -120.0}, {3.0, 500.0}});
  EXPECT_THAT(reference->corners_s(), ElementsAre(3.0, 4.0));
}

TEST(LossReference, StartsAtTheFrequencyBefore) {
  const auto reference = reference_from_losses(ieee24(), {{3.0, 500.0}}, -0.15);
  EXPECT_NEAR(reference->frequency_hz(0.0), 49.85, 1e-14);
  EXPECT_EQ(reference->excess_cycles(0.0), 0.0);
  EXPECT_NEAR(reference->excess_cycles(2.0), -0.3, 1e-15);
}

TEST(LossReference, HasCornersAtBothEndsOfARamp) {
  const auto reference = reference_from_losses(ieee24(), {{3.0, 500.0, 2.0}, {4.0, -120.0}});
  EXPECT_THAT(reference->corners_s(), ElementsAre(3.0, 4.0, 5.0));
}

TEST(LossReference, CountsExcessPhaseFromZeroAfterALossBeforeTheStart) {
  const auto reference = reference_from_losses(ieee24(), {{-2.0, 500.0}});
  EXPECT_EQ(reference->excess_cycles(0.0), 0.0);
  // About 0.6 Hz below nominal; the error of the trapezoidal rule is 0.01²/12·|df/dt| < 2·10⁻⁶.
  EXPECT_NEAR(reference->excess_cycles(0.01),
              0.005 * (reference->frequency_hz(0.0) + reference->frequency_hz(0.01) - 100.0), 2e-6);
  EXPECT_LT(reference->frequency_hz(0.0), 49.5);
}

}  // namespace
}  // namespace gsbench::waveform
