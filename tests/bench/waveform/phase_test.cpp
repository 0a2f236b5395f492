// Compares the phase of the samples with the exact formula, to better than 10⁻⁹ cycles. Samples are
// floats, but near a zero crossing their resolution is fine: for |x| < 0.02 rounding changes the
// phase by at most 2⁻³⁰/2π = 1.5·10⁻¹⁰ cycles.
#include "example_references.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace gsbench::waveform {
namespace {

constexpr double kTolerableCycles = 1e-9;

double fraction(double cycles) {
  return cycles - std::floor(cycles);
}

// Largest phase error, in cycles, of the samples near a zero crossing; there must be some.
template <typename ExactCycles>
double phase_error(const std::vector<float>& samples, std::int64_t first_tick,
                   const ExactCycles& exact_cycles) {
  double largest = 0.0;
  int crossings = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double exact_rad = 2.0 * M_PI * exact_cycles(first_tick + static_cast<std::int64_t>(i));
    const double expected = std::sin(exact_rad);
    if (std::fabs(expected) > 0.02) {
      continue;
    }
    ++crossings;
    const double error = (static_cast<double>(samples[i]) - expected) / std::cos(exact_rad);
    largest = std::max(largest, std::fabs(error) / (2.0 * M_PI));
  }
  EXPECT_GT(crossings, 0);
  return largest;
}

// For a reference whose nominal frequency is a whole number. Sixteen initial phases shift the zero
// crossings, so that they cover every part of each block.
double phase_error(const std::shared_ptr<const ReferenceSignal>& reference, std::int64_t rate_hz,
                   double from_s, double to_s) {
  const auto nominal_hz = static_cast<std::int64_t>(reference->nominal_hz());
  const auto rate = static_cast<double>(rate_hz);
  const auto first = static_cast<std::int64_t>(from_s * rate);
  const auto count = static_cast<std::size_t>((to_s - from_s) * rate);
  double largest = 0.0;
  for (int sixteenth = 0; sixteenth < 16; ++sixteenth) {
    SignalSpec spec;
    spec.initial_phase_deg = sixteenth * 360.0 / 16;
    const auto exact = [&](std::int64_t tick) {
      const double nominal = static_cast<double>(tick * nominal_hz % rate_hz) / rate;
      return nominal + sixteenth / 16.0 +
             fraction(reference->excess_cycles(static_cast<double>(tick) / rate));
    };
    const Synthesizer synthesizer(reference, spec, rate_hz);
    largest = std::max(largest, phase_error(render(synthesizer, first, count), first, exact));
  }
  return largest;
}

constexpr std::int64_t kThousandHours = 1000ll * 3600 * 8000;  // ticks

TEST(Phase, IsExactAfterAThousandHoursAtNominalFrequency) {
  const Synthesizer synthesizer(constant(50.0, 50.0), {}, 8000);
  EXPECT_EQ(render(synthesizer, kThousandHours, 16000), render(synthesizer, 0, 16000));
}

TEST(Phase, IsExactAfterAThousandHoursOffNominal) {
  // 50 + 1/8 Hz: n·401/64000 cycles, in integers.
  const Synthesizer synthesizer(constant(50.0, 50.125), {}, 8000);
  const auto exact = [](std::int64_t tick) {
    return static_cast<double>(tick * 401 % 64000) / 64000.0;
  };
  // An excess of 450 000 cycles, known within ± 6·10⁻¹¹.
  EXPECT_LT(
      phase_error(render(synthesizer, kThousandHours + 77, 16000), kThousandHours + 77, exact),
      kTolerableCycles);
}

TEST(Phase, IsExactForAFractionalNominalFrequency) {
  // 16.7 Hz as a double is 16.7 + 7.1·10⁻¹⁶ Hz, which is 3·10⁻⁹ cycles over 1000 hours: the exact
  // value must be computed from the double.
  const Synthesizer synthesizer(constant(16.7, 16.7), {}, 8000);
  const auto nominal_hz = static_cast<long double>(16.7);
  const auto exact = [nominal_hz](std::int64_t tick) {
    const long double cycles = nominal_hz * static_cast<long double>(tick) / 8000.0L;
    return static_cast<double>(cycles - std::floor(cycles));
  };
  EXPECT_LT(phase_error(render(synthesizer, kThousandHours, 16000), kThousandHours, exact),
            kTolerableCycles);
}

// Losses at a sample, at the edge of a block, and between samples; the fall and the recovery.
TEST(Phase, FollowsALossOf500MwAtAnyPositionInABlock) {
  for (const double at_s : {3.0, 3.0001, 3.00017, 3.0079999, 3.008, 3.3}) {
    EXPECT_LT(phase_error(loss_of_500_mw(at_s), 8000, 2.9, 10.0), kTolerableCycles) << at_s;
  }
}

// The first time after 3 s whose rounded position in samples satisfies `is_wanted`.
template <typename IsWanted>
double time_after_3_s(const IsWanted& is_wanted) {
  double t_s = 3.0;
  while (!is_wanted(t_s, t_s * 8000.0 / 8000.0)) {
    t_s = std::nextafter(t_s, 4.0);
  }
  return t_s;
}

TEST(Phase, FollowsALossWithARoundedPosition) {
  const double down_s =
      time_after_3_s([](double t_s, double rounded_s) { return rounded_s < t_s; });
  const double up_s = time_after_3_s([](double t_s, double rounded_s) { return rounded_s > t_s; });
  EXPECT_LT(phase_error(loss_of_500_mw(down_s), 8000, 2.9, 4.0), kTolerableCycles);
  EXPECT_LT(phase_error(loss_of_500_mw(up_s), 8000, 2.9, 4.0), kTolerableCycles);
}

TEST(Phase, FollowsLossesAtTheSamePositionWithAndWithoutRounding) {
  const double later_s =
      time_after_3_s([](double t_s, double rounded_s) { return rounded_s < t_s; });
  const double earlier_s = std::nextafter(later_s, 0.0);
  ASSERT_EQ(earlier_s * 8000.0, later_s * 8000.0);
  const std::shared_ptr<const ReferenceSignal> reference = reference_from_losses(
      ieee24(), {{earlier_s, 100.0}, {later_s, 400.0}, {3.5, 100.0}, {3.5, 50.0}});
  EXPECT_LT(phase_error(reference, 8000, 2.9, 4.0), kTolerableCycles);
}

TEST(Phase, FollowsACascadeOnAWeakOverdampedGrid) {
  grid::Grid grid;
  grid.base_mw = grid.load_mw = 1000.0;
  grid.damping_pu = 1.0;
  grid.plants = {{"plant", 1000.0, 0.5, 0.05}};  // poles beyond 6/s
  const std::shared_ptr<const ReferenceSignal> reference = reference_from_losses(
      grid::SfrModel(grid), {{1.0, 100.0}, {1.01, 50.0}, {1.0101, -20.0}, {1.5, -60.0}});
  EXPECT_LT(phase_error(reference, 8000, 0.9, 4.0), kTolerableCycles);
}

TEST(Phase, FollowsRampsOf10HzPerSecondAtEverySampleRate) {
  const std::shared_ptr<const ReferenceSignal> reference =
      reference_from_points(50.0, {{0.5003, 50.0}, {1.0003, 55.0}, {2.0003, 45.0}, {2.1, 45.0}});
  for (const std::int64_t rate_hz : {4000, 8000, 10000, 48000, 192000}) {
    EXPECT_LT(phase_error(reference, rate_hz, 0.4, 2.3), kTolerableCycles) << rate_hz;
  }
}

TEST(Phase, FollowsALossOverATimeWithAnOscillationLaidOverIt) {
  for (const double phase_deg : {0.0, 77.0}) {
    const std::shared_ptr<const ReferenceSignal> reference =
        with_oscillations(reference_from_losses(ieee24(), {{1.0, 500.0, 1.0005}}, -0.15),
                          {{0.5003, 1.5001, 0.4, 0.06, phase_deg}, {1.0, 1.0, 5.0, 0.06}});
    EXPECT_LT(phase_error(reference, 8000, 0.4, 2.6), kTolerableCycles) << phase_deg;
  }
}

TEST(Phase, FollowsPointsCloserThanABlockOrASample) {
  std::vector<recording::TracePoint> points;
  points.reserve(402);
  for (int i = 0; i < 400; ++i) {
    points.push_back({0.1 + 0.00131 * i, 50.0 + 0.3 * std::sin(i * 0.7)});
  }
  points.push_back({points.back().t_s + 1e-5, 50.2});
  points.push_back({points.back().t_s + 1e-5, 49.9});
  EXPECT_LT(phase_error(reference_from_points(50.0, points), 8000, 0.0, 1.0), kTolerableCycles);
}

TEST(Phase, StartsAtTheInitialPhase) {
  SignalSpec spec;
  spec.initial_phase_deg = -90.0;
  const Synthesizer synthesizer(constant(60.0, 60.0), spec, 8000);
  EXPECT_EQ(render(synthesizer, 0, 1)[0], -1.0f);
  EXPECT_EQ(render(Synthesizer(constant(60.0, 60.0), {}, 8000), 0, 1)[0], 0.0f);
}

}  // namespace
}  // namespace gsbench::waveform
