#include "example_truths.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include <capture/capture.hpp>

namespace gsbench::capture {
namespace {

using waveform::loss_of_500_mw;

constexpr std::int64_t kTraceRateHz = 8000;
// As promised, and what the test's own interpolation rounds.
constexpr double kPromisedHz = 5e-5 + 1e-12;
constexpr double kPromisedHzS = 5e-3 + 1e-9;

// A truth from a formula, which counts how often it is asked.
class FormulaTruth final : public waveform::Truth {
 public:
  explicit FormulaTruth(std::function<double(double)> frequency_hz)
      : frequency_hz_(std::move(frequency_hz)) {}
  double nominal_hz() const override { return 50.0; }
  double frequency_hz(double t_s) const override {
    ++asked;
    return frequency_hz_(t_s);
  }
  double rocof_hz_s(double t_s) const override {
    ++asked;
    return (frequency_hz_(t_s + 1e-4) - frequency_hz_(t_s - 1e-4)) / 2e-4;
  }
  double excess_cycles(double) const override { return 0.0; }
  double voltage_pu(double) const override { return 1.0; }
  std::vector<double> corners_s() const override { return {}; }

  mutable std::size_t asked = 0;

 private:
  std::function<double(double)> frequency_hz_;
};

double interpolated(const record::TruthTrace& trace, const std::vector<double>& values,
                    std::int64_t tick) {
  const auto right = std::lower_bound(trace.tick.begin(), trace.tick.end(), tick);
  const auto i = static_cast<std::size_t>(right - trace.tick.begin());
  if (*right == tick) return values[i];
  const double part = static_cast<double>(tick - trace.tick[i - 1]) /
                      static_cast<double>(trace.tick[i] - trace.tick[i - 1]);
  return values[i - 1] + part * (values[i] - values[i - 1]);
}

// Largest errors of the trace's straight lines at every 16 ms.
struct Worst {
  double hz = 0.0;
  double hz_s = 0.0;
};

Worst worst(const record::TruthTrace& trace, const waveform::Truth& truth,
            std::int64_t duration_ticks) {
  Worst worst;
  for (std::int64_t tick = 0; tick <= duration_ticks; tick += 128) {
    const double t_s = static_cast<double>(tick) / static_cast<double>(kTraceRateHz);
    const double hz = interpolated(trace, trace.frequency_hz, tick);
    const double hz_s = interpolated(trace, trace.rocof_hz_s, tick);
    worst.hz = std::max(worst.hz, std::fabs(hz - truth.frequency_hz(t_s)));
    worst.hz_s = std::max(worst.hz_s, std::fabs(hz_s - truth.rocof_hz_s(t_s)));
  }
  return worst;
}

TEST(TruthTrace, StaysWithinWhatItPromisesAtEverySixteenMilliseconds) {
  const auto truth = loss_of_500_mw(3.0);
  const record::TruthTrace trace = truth_trace(*truth, 60 * kTraceRateHz, kTraceRateHz);
  const Worst errors = worst(trace, *truth, 60 * kTraceRateHz);
  EXPECT_LE(errors.hz, kPromisedHz);
  EXPECT_LE(errors.hz_s, kPromisedHzS);
  // Of 3752 before thinning. A curvature of 0.1 Hz/s² lets a chord of 63 ms pass.
  EXPECT_LT(trace.tick.size(), 1000U);
}

TEST(TruthTrace, SpendsItsToleranceWhereTheTruthBends) {
  const auto truth = loss_of_500_mw(3.0);
  // Far below, the thinning would do nothing.
  const record::TruthTrace trace = truth_trace(*truth, 60 * kTraceRateHz, kTraceRateHz);
  EXPECT_GT(worst(trace, *truth, 60 * kTraceRateHz).hz, 1e-5);
}

TEST(TruthTrace, KeepsTheCornersWhereverTheyLie) {
  // Off the 16 ms, and at a tick's fraction.
  const auto truth = waveform::truth_from_points(50.0, {{1.0003, 50.0}, {2.00505, 49.0}});
  const record::TruthTrace trace = truth_trace(*truth, 4 * kTraceRateHz, kTraceRateHz);
  for (const std::int64_t corner : {8003, 16041}) {
    EXPECT_EQ(std::count(trace.tick.begin(), trace.tick.end(), corner), 1) << corner;
  }
}

// At 3.00005 s, which is tick 24000.4.
TEST(TruthTrace, TurnsTheRocofWithinTheTickOfALoss) {
  const auto truth = loss_of_500_mw(3.00005);
  const record::TruthTrace trace = truth_trace(*truth, 6 * kTraceRateHz, kTraceRateHz);
  EXPECT_EQ(interpolated(trace, trace.rocof_hz_s, 24000), 0.0);
  // −ΔP·f_n/(2·H·S_B) = −500·50/(2·9.2161·2745); 75 µs of its bend come to 1e-5 Hz/s.
  EXPECT_NEAR(interpolated(trace, trace.rocof_hz_s, 24001), -0.49411, 1e-4);
}

TEST(TruthTrace, BeginsAndEndsWithTheRunAndAscends) {
  const auto truth = loss_of_500_mw(3.0);
  for (const std::int64_t duration : {1L, 127L, 128L, 129L, 6L * kTraceRateHz + 1}) {
    const record::TruthTrace trace = truth_trace(*truth, duration, kTraceRateHz);
    EXPECT_EQ(trace.tick.front(), 0);
    EXPECT_EQ(trace.tick.back(), duration);
    EXPECT_TRUE(std::is_sorted(trace.tick.begin(), trace.tick.end()));
    EXPECT_EQ(std::adjacent_find(trace.tick.begin(), trace.tick.end()), trace.tick.end());
    EXPECT_EQ(trace.frequency_hz.size(), trace.tick.size());
    EXPECT_EQ(trace.rocof_hz_s.size(), trace.tick.size());
  }
}

TEST(TruthTrace, HasNoCornersOfBeforeOrAfterTheRun) {
  const auto ends_later = waveform::truth_from_points(50.0, {{1.0, 50.0}, {9.0, 49.0}});
  EXPECT_EQ(truth_trace(*ends_later, 4 * kTraceRateHz, kTraceRateHz).tick.back(), 4 * kTraceRateHz);
  const auto lost_before = loss_of_500_mw(-1.0);
  EXPECT_EQ(truth_trace(*lost_before, 4 * kTraceRateHz, kTraceRateHz).tick.front(), 0);
}

// The truth is asked for frequency and ROCOF once for each of the 225 001 instants; the looking
// back takes no truth, and a quadratic one would run into the time limit of the program.
TEST(TruthTrace, TakesWorkInProportionOverAnHourWhateverTheCourse) {
  constexpr std::int64_t kHour = 3600 * kTraceRateHz;
  constexpr std::size_t kInstants = 225001;
  const std::vector<std::function<double(double)>> courses = {
      [](double) { return 50.0; },
      [](double t_s) { return 50.0 - 1e-4 * t_s; },
      // Bends by just so much that long runs are tried and given up.
      [](double t_s) { return 50.0 + 0.01 * std::sin(0.02 * t_s); },
      // Bends everywhere: nothing can be left out.
      [](double t_s) { return 50.0 + 0.01 * std::sin(150.0 * t_s); },
  };
  for (const auto& course : courses) {
    const FormulaTruth truth(course);
    const record::TruthTrace trace = truth_trace(truth, kHour, kTraceRateHz);
    EXPECT_LE(truth.asked, 2 * kInstants);
    const Worst errors = worst(trace, truth, kHour);
    EXPECT_LE(errors.hz, kPromisedHz);
    EXPECT_LE(errors.hz_s, kPromisedHzS);
  }
}

TEST(TruthTrace, OfAnHourWithoutAnEventIsShort) {
  const FormulaTruth truth([](double) { return 50.0; });
  // 2000 entries of 16 ms at a time at most: 113 lines.
  EXPECT_LE(truth_trace(truth, 3600 * kTraceRateHz, kTraceRateHz).tick.size(), 230U);
}

}  // namespace
}  // namespace gsbench::capture
