#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include <capture/truth_trace.hpp>

namespace gsbench::capture {
namespace {

constexpr std::int64_t kRateHz = 8000;
constexpr double kPromisedHz = 5e-5;

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

double interpolated_hz(const record::TruthTrace& trace, std::int64_t tick) {
  const auto right = std::lower_bound(trace.tick.begin(), trace.tick.end(), tick);
  const auto i = static_cast<std::size_t>(right - trace.tick.begin());
  if (*right == tick) return trace.frequency_hz[i];
  const double part = static_cast<double>(tick - trace.tick[i - 1]) /
                      static_cast<double>(trace.tick[i] - trace.tick[i - 1]);
  return trace.frequency_hz[i - 1] + part * (trace.frequency_hz[i] - trace.frequency_hz[i - 1]);
}

// Largest error of the trace's straight lines at every 16 ms.
double worst_hz(const record::TruthTrace& trace, const waveform::Truth& truth,
                std::int64_t duration_ticks) {
  double worst = 0.0;
  for (std::int64_t tick = 0; tick <= duration_ticks; tick += 128) {
    const double t_s = static_cast<double>(tick) / static_cast<double>(kRateHz);
    worst = std::max(worst, std::fabs(interpolated_hz(trace, tick) - truth.frequency_hz(t_s)));
  }
  return worst;
}

std::unique_ptr<waveform::Truth> loss_of_500_mw(double at_s) {
  grid::Grid grid;
  grid.base_mw = 2745.0;
  grid.load_mw = 2745.0;
  grid.damping_pu = 2.5;
  grid.plants = {{"all", 2745.0, 9.2161, 1.0 / 21.8601}};
  return waveform::truth_from_losses(grid::SfrModel(grid), {{at_s, 500.0}});
}

TEST(TruthTrace, StaysWithinATwentiethOfAMillihertzAtEverySixteenMilliseconds) {
  const auto truth = loss_of_500_mw(3.0);
  const record::TruthTrace trace = truth_trace(*truth, 60 * kRateHz, kRateHz);
  // 1e-12: what the test's own interpolation rounds.
  EXPECT_LE(worst_hz(trace, *truth, 60 * kRateHz), kPromisedHz + 1e-12);
  // 3750 entries before thinning. A curvature of 0.1 Hz/s² lets a chord of 63 ms pass.
  EXPECT_LT(trace.tick.size(), 1000U);
}

TEST(TruthTrace, SpendsItsToleranceWhereTheTruthBends) {
  const auto truth = loss_of_500_mw(3.0);
  // Far below, the thinning would do nothing.
  EXPECT_GT(worst_hz(truth_trace(*truth, 60 * kRateHz, kRateHz), *truth, 60 * kRateHz), 1e-5);
}

TEST(TruthTrace, KeepsTheCornersWhereverTheyLie) {
  // Off the 16 ms, and at a tick's fraction.
  const auto truth = waveform::truth_from_points(50.0, {{1.0003, 50.0}, {2.00505, 49.0}});
  const record::TruthTrace trace = truth_trace(*truth, 4 * kRateHz, kRateHz);
  for (const std::int64_t corner : {8002, 16040}) {
    EXPECT_EQ(std::count(trace.tick.begin(), trace.tick.end(), corner), 1) << corner;
  }
}

TEST(TruthTrace, KeepsTheInstantOfALossWithTheSlopeAfterIt) {
  const auto truth = loss_of_500_mw(3.0001);
  const record::TruthTrace trace = truth_trace(*truth, 6 * kRateHz, kRateHz);
  const auto at = std::find(trace.tick.begin(), trace.tick.end(), 24001);
  ASSERT_NE(at, trace.tick.end());
  const auto i = static_cast<std::size_t>(at - trace.tick.begin());
  // −ΔP·f_n/(2·H·S_B) = −500·50/(2·9.2161·2745); 25 µs of its bend come to 1e-5 Hz/s.
  EXPECT_NEAR(trace.rocof_hz_s[i], -0.49411, 1e-4);
}

TEST(TruthTrace, BeginsAndEndsWithTheRunAndAscends) {
  const auto truth = loss_of_500_mw(3.0);
  for (const std::int64_t duration : {1L, 127L, 128L, 129L, 6L * kRateHz + 1}) {
    const record::TruthTrace trace = truth_trace(*truth, duration, kRateHz);
    EXPECT_EQ(trace.tick.front(), 0);
    EXPECT_EQ(trace.tick.back(), duration);
    EXPECT_TRUE(std::is_sorted(trace.tick.begin(), trace.tick.end()));
    EXPECT_EQ(std::adjacent_find(trace.tick.begin(), trace.tick.end()), trace.tick.end());
    EXPECT_EQ(trace.frequency_hz.size(), trace.tick.size());
    EXPECT_EQ(trace.rocof_hz_s.size(), trace.tick.size());
  }
}

TEST(TruthTrace, HasNoCornersOfBeforeOrAfterTheRun) {
  const auto truth = waveform::truth_from_points(50.0, {{1.0, 50.0}, {9.0, 49.0}});
  const record::TruthTrace trace = truth_trace(*truth, 4 * kRateHz, kRateHz);
  EXPECT_EQ(trace.tick.back(), 4 * kRateHz);
}

// The truth is asked once for each of the 225 001 instants and once for each that is kept; the
// looking back takes no truth, and a quadratic one would run into the time limit of the program.
TEST(TruthTrace, TakesWorkInProportionOverAnHourWhateverTheCourse) {
  constexpr std::int64_t kHour = 3600 * kRateHz;
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
    const record::TruthTrace trace = truth_trace(truth, kHour, kRateHz);
    EXPECT_LE(truth.asked, kInstants + trace.tick.size());
    EXPECT_LE(worst_hz(trace, truth, kHour), kPromisedHz + 1e-12);
  }
}

TEST(TruthTrace, OfAnHourWithoutAnEventIsShort) {
  const FormulaTruth truth([](double) { return 50.0; });
  // 2000 entries of 16 ms at a time at most: 113 lines.
  EXPECT_LE(truth_trace(truth, 3600 * kRateHz, kRateHz).tick.size(), 230U);
}

}  // namespace
}  // namespace gsbench::capture
