#include "example_references.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include <capture/capture.hpp>

namespace gsbench::capture {
namespace {

using waveform::loss_of_500_mw;

constexpr std::int64_t kTraceRate_hz = 8000;
// The documented tolerances plus rounding in the test's interpolation.
constexpr double kPromised_hz = 5e-5 + 1e-12;
constexpr double kPromised_hz_s = 5e-3 + 1e-9;

// A reference from a formula that counts the calls.
class FormulaReference final : public waveform::ReferenceSignal {
 public:
  explicit FormulaReference(std::function<double(double)> frequency_hz)
      : frequency_hz_(std::move(frequency_hz)) {}
  double nominal_hz() const override { return 50.0; }
  double frequency_hz(double t_s) const override {
    ++calls;
    return frequency_hz_(t_s);
  }
  double rocof_hz_s(double t_s) const override {
    ++calls;
    return (frequency_hz_(t_s + 1e-4) - frequency_hz_(t_s - 1e-4)) / 2e-4;
  }
  double excess_cycles(double) const override { return 0.0; }
  double voltage_pu(double) const override { return 1.0; }
  std::vector<double> corners_s() const override { return {}; }

  mutable std::size_t calls = 0;

 private:
  std::function<double(double)> frequency_hz_;
};

double interpolated(const record::ReferenceTrace& trace, const std::vector<double>& values,
                    std::int64_t tick) {
  const auto right = std::lower_bound(trace.tick.begin(), trace.tick.end(), tick);
  const auto i = static_cast<std::size_t>(right - trace.tick.begin());
  if (*right == tick) {
    return values[i];
  }
  const double part = static_cast<double>(tick - trace.tick[i - 1]) /
                      static_cast<double>(trace.tick[i] - trace.tick[i - 1]);
  return values[i - 1] + part * (values[i] - values[i - 1]);
}

// Largest errors of linear interpolation in the trace, checked every 16 ms.
struct Worst {
  double hz = 0.0;
  double hz_s = 0.0;
};

Worst worst(const record::ReferenceTrace& trace, const waveform::ReferenceSignal& reference,
            std::int64_t duration_ticks) {
  Worst worst;
  for (std::int64_t tick = 0; tick <= duration_ticks; tick += 128) {
    const double t_s = static_cast<double>(tick) / static_cast<double>(kTraceRate_hz);
    const double hz = interpolated(trace, trace.frequency_hz, tick);
    const double hz_s = interpolated(trace, trace.rocof_hz_s, tick);
    worst.hz = std::max(worst.hz, std::fabs(hz - reference.frequency_hz(t_s)));
    worst.hz_s = std::max(worst.hz_s, std::fabs(hz_s - reference.rocof_hz_s(t_s)));
  }
  return worst;
}

TEST(ReferenceTrace, StaysWithinItsTolerances) {
  const auto reference = loss_of_500_mw(3.0);
  const record::ReferenceTrace trace =
      reference_trace(*reference, 60 * kTraceRate_hz, kTraceRate_hz);
  const Worst errors = worst(trace, *reference, 60 * kTraceRate_hz);
  EXPECT_LE(errors.hz, kPromised_hz);
  EXPECT_LE(errors.hz_s, kPromised_hz_s);
  // There are 3752 entries before thinning. A curvature of 0.1 Hz/s² permits a chord of 63 ms.
  EXPECT_LT(trace.tick.size(), 1000U);
}

TEST(ReferenceTrace, UsesItsToleranceWhereTheReferenceIsCurved) {
  const auto reference = loss_of_500_mw(3.0);
  // Much smaller errors would mean that nothing was thinned.
  const record::ReferenceTrace trace =
      reference_trace(*reference, 60 * kTraceRate_hz, kTraceRate_hz);
  EXPECT_GT(worst(trace, *reference, 60 * kTraceRate_hz).hz, 1e-5);
}

TEST(ReferenceTrace, KeepsCornersBetweenTicks) {
  // Not on the 16 ms grid, and between two ticks.
  const auto reference = waveform::reference_from_points(50.0, {{1.0003, 50.0}, {2.00505, 49.0}});
  const record::ReferenceTrace trace =
      reference_trace(*reference, 4 * kTraceRate_hz, kTraceRate_hz);
  for (const std::int64_t corner : {8003, 16041}) {
    EXPECT_EQ(std::count(trace.tick.begin(), trace.tick.end(), corner), 1) << corner;
  }
}

// At 3.00005 s, which is tick 24000.4.
TEST(ReferenceTrace, ChangesTheRocofWithinTheTickOfALoss) {
  const auto reference = loss_of_500_mw(3.00005);
  const record::ReferenceTrace trace =
      reference_trace(*reference, 6 * kTraceRate_hz, kTraceRate_hz);
  EXPECT_EQ(interpolated(trace, trace.rocof_hz_s, 24000), 0.0);
  // −ΔP·f_n/(2·H·S_B) = −500·50/(2·9.2161·2745); its change within 75 µs is 1e-5 Hz/s.
  EXPECT_NEAR(interpolated(trace, trace.rocof_hz_s, 24001), -0.49411, 1e-4);
}

TEST(ReferenceTrace, StartsAndEndsWithTheRunAndAscends) {
  const auto reference = loss_of_500_mw(3.0);
  for (const std::int64_t duration : {1L, 127L, 128L, 129L, 6L * kTraceRate_hz + 1}) {
    const record::ReferenceTrace trace = reference_trace(*reference, duration, kTraceRate_hz);
    EXPECT_EQ(trace.tick.front(), 0);
    EXPECT_EQ(trace.tick.back(), duration);
    EXPECT_TRUE(std::is_sorted(trace.tick.begin(), trace.tick.end()));
    EXPECT_EQ(std::adjacent_find(trace.tick.begin(), trace.tick.end()), trace.tick.end());
    EXPECT_EQ(trace.frequency_hz.size(), trace.tick.size());
    EXPECT_EQ(trace.rocof_hz_s.size(), trace.tick.size());
  }
}

TEST(ReferenceTrace, OmitsCornersOutsideTheRun) {
  const auto ends_later = waveform::reference_from_points(50.0, {{1.0, 50.0}, {9.0, 49.0}});
  EXPECT_EQ(reference_trace(*ends_later, 4 * kTraceRate_hz, kTraceRate_hz).tick.back(),
            4 * kTraceRate_hz);
  const auto lost_before = loss_of_500_mw(-1.0);
  EXPECT_EQ(reference_trace(*lost_before, 4 * kTraceRate_hz, kTraceRate_hz).tick.front(), 0);
}

// The reference is evaluated once for each of the 225 001 instants (frequency and ROCOF). Quadratic
// work would exceed the time limit of the test program.
TEST(ReferenceTrace, TakesLinearTimeForAnHourOfAnyReference) {
  constexpr std::int64_t kHour = 3600 * kTraceRate_hz;
  constexpr std::size_t kInstants = 225001;
  const std::vector<std::function<double(double)>> courses = {
      [](double) { return 50.0; },
      [](double t_s) { return 50.0 - 1e-4 * t_s; },
      // Curved so little that long lines are tried and rejected.
      [](double t_s) { return 50.0 + 0.01 * std::sin(0.02 * t_s); },
      // Curved everywhere: nothing can be omitted.
      [](double t_s) { return 50.0 + 0.01 * std::sin(150.0 * t_s); },
  };
  for (const auto& course : courses) {
    const FormulaReference reference(course);
    const record::ReferenceTrace trace = reference_trace(reference, kHour, kTraceRate_hz);
    EXPECT_LE(reference.calls, 2 * kInstants);
    const Worst errors = worst(trace, reference, kHour);
    EXPECT_LE(errors.hz, kPromised_hz);
    EXPECT_LE(errors.hz_s, kPromised_hz_s);
  }
}

TEST(ReferenceTrace, IsShortForAnHourWithoutAnEvent) {
  const FormulaReference reference([](double) { return 50.0; });
  // At most 2000 entries of 16 ms for each line: 113 lines.
  EXPECT_LE(reference_trace(reference, 3600 * kTraceRate_hz, kTraceRate_hz).tick.size(), 230U);
}

}  // namespace
}  // namespace gsbench::capture
