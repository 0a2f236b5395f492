// Measures an outlet's clock from voltage dips and compares it with the configured crystal.
#include "outlet_voltage.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <profile/load.hpp>

namespace gsbench::capture {
namespace {

using test::Crystal;
using test::play;
using test::Played;

constexpr double kTickRate_hz = 8000.0;

profile::Plan plan_of(double duration_s, const std::string& grid = "ieee24",
                      const std::string& signal = "noise_pct = 1.0\n",
                      const std::string& loss = "[[grid.loss]]\nat_s = 1.0\npower_mw = 500.0\n") {
  return profile::parse_profile(
      "title = \"A test\"\nsource = \"None\"\n[grid]\nsystem = \"" + grid + "\"\n" + loss +
          "[signal]\nduration_s = " + std::to_string(duration_s) + "\n" + signal +
          "[[outlet]]\n[[expect]]\nmeasure = \"event.count\"\nmin = 0\n",
      "test.toml");
}

// Largest error of a converted time stamp over the run, ms.
double error_ms(const Played& played, const record::Clock& clock) {
  double largest_ms = 0.0;
  for (int part = 0; part <= 8; ++part) {
    const double tick = static_cast<double>(played.run_ticks) * part / 8.0;
    // A whole sample near it, and the exact tick of that sample.
    const double sample = std::floor(played.sample_at(tick));
    const double exact = tick + (sample - played.sample_at(tick)) / played.samples_per_tick;
    const auto converted = static_cast<double>(clock.tick_of(static_cast<std::int64_t>(sample)));
    largest_ms = std::max(largest_ms, 1e3 / kTickRate_hz * std::fabs(converted - exact));
  }
  return largest_ms;
}

struct Totals {
  int cases = 0;
  int times_within = 0;
  int drifts_within = 0;
  double largest_error_ms = 0.0;
  double largest_uncertainty_ms = 0.0;
  double largest_drift_uncertainty_ppm = 0.0;

  void add(const Played& played, double ppm, const record::Clock& found) {
    const double error = error_ms(played, found);
    ++cases;
    times_within += error <= found.uncertainty_ms ? 1 : 0;
    drifts_within += std::fabs(found.drift_ppm - ppm) <= found.drift_uncertainty_ppm ? 1 : 0;
    largest_error_ms = std::max(largest_error_ms, error);
    largest_uncertainty_ms = std::max(largest_uncertainty_ms, found.uncertainty_ms);
    largest_drift_uncertainty_ppm =
        std::max(largest_drift_uncertainty_ppm, found.drift_uncertainty_ppm);
  }
};

Crystal random_crystal(std::mt19937& random) {
  Crystal crystal;
  crystal.ppm = std::uniform_real_distribution<double>(-200.0, 200.0)(random);
  crystal.lead_in = std::uniform_int_distribution<std::int64_t>(0, 4000)(random);
  crystal.started = std::uniform_int_distribution<std::uint64_t>(0, 1ULL << 40U)(random);
  crystal.noise_index = static_cast<std::uint32_t>(random());
  return crystal;
}

Totals random_cases(int cases, double duration_s, const std::string& grid) {
  const profile::Plan plan = plan_of(duration_s, grid);
  std::mt19937 random(20);
  Totals totals;
  for (int i = 0; i < cases; ++i) {
    const Crystal crystal = random_crystal(random);
    const Played played = play(plan, crystal);
    const auto found = align(played.trace, played.markers, kTickRate_hz);
    if (!found) {
      ADD_FAILURE() << "case " << i << ": markers not found";
      continue;
    }
    totals.add(played, crystal.ppm, *found);
  }
  return totals;
}

// k = 2: 95.4 % of normally distributed errors are within the uncertainty.
bool mostly(int within, int cases) {
  return within >= static_cast<int>(std::ceil(0.95 * cases));
}

// Half a tick of 1/8 ms for the stamp, and three times the effect of 1 % noise on the dip edges.
constexpr double kMostUncertainty_ms = 0.5;

TEST(OutletClock, IsWithinItsUncertaintyForAnyStartAndDrift) {
  for (const char* grid : {"ieee24", "island-60hz"}) {
    const Totals totals = random_cases(150, 6.0, grid);
    EXPECT_TRUE(mostly(totals.times_within, totals.cases));
    EXPECT_TRUE(mostly(totals.drifts_within, totals.cases));
    EXPECT_LT(totals.largest_uncertainty_ms, kMostUncertainty_ms);
    // 0.2 ms over the 8.6 s from the first to the last dip.
    EXPECT_LT(totals.largest_drift_uncertainty_ppm, 50.0);
    // The uncertainty is not exaggerated: the largest of some hundred errors is close to it.
    EXPECT_GT(totals.largest_error_ms, 0.3 * totals.largest_uncertainty_ms);
  }
}

// Pieces of any length; the fit is the same to the last bit.
TEST(OutletClock, IsFoundFromTheReadingsNearTheEdgesOfDips) {
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    const Played played = play(plan_of(20.0), random_crystal(random));
    EdgeReadings edges(played.markers.level, played.trace.window_samples);
    const std::vector<std::int64_t>& samples = played.trace.sample;
    for (std::size_t from = 0, to = 0; from < samples.size(); from = to) {
      to = std::min(from + random() % 40, samples.size());
      const auto begin = static_cast<std::ptrdiff_t>(from);
      const auto end = static_cast<std::ptrdiff_t>(to);
      edges.add({samples.begin() + begin, samples.begin() + end},
                {played.trace.voltage_pu.begin() + begin, played.trace.voltage_pu.begin() + end});
    }
    EXPECT_LT(edges.trace().sample.size(), samples.size() / 4);
    const auto whole = align(played.trace, played.markers, kTickRate_hz);
    const auto found = align(edges.trace(), played.markers, kTickRate_hz);
    ASSERT_TRUE(whole && found);
    EXPECT_EQ(found->sample_at_zero, whole->sample_at_zero);
    EXPECT_EQ(found->samples_per_tick, whole->samples_per_tick);
    EXPECT_EQ(found->uncertainty_ms, whole->uncertainty_ms);
  }
}

TEST(OutletClock, IsMoreAccurateForALongerRun) {
  const Totals brief = random_cases(20, 1.5, "ieee24");
  const Totals lengthy = random_cases(20, 30.0, "ieee24");
  EXPECT_LT(4.0 * lengthy.largest_drift_uncertainty_ppm, brief.largest_drift_uncertainty_ppm);
  EXPECT_LT(lengthy.largest_uncertainty_ms, kMostUncertainty_ms);
}

class AlignmentTest : public testing::Test {
 protected:
  static constexpr double kDrift_ppm = -37.0;
  const profile::Plan plan_ = plan_of(4.0);
  Played played_ = play(plan_, {kDrift_ppm, 123, 1000000, 5});

  std::optional<record::Clock> found() const {
    return align(played_.trace, played_.markers, kTickRate_hz);
  }

  void expect_within(const record::Clock& alignment) const {
    EXPECT_LE(error_ms(played_, alignment), alignment.uncertainty_ms);
    EXPECT_LE(std::fabs(alignment.drift_ppm - kDrift_ppm), alignment.drift_uncertainty_ppm);
  }

  std::size_t reading_at(double tick) const {
    const auto sample = static_cast<std::int64_t>(played_.sample_at(tick));
    const auto at =
        std::lower_bound(played_.trace.sample.begin(), played_.trace.sample.end(), sample);
    return static_cast<std::size_t>(at - played_.trace.sample.begin());
  }

  void lose(std::size_t first, std::size_t count) {
    VoltageTrace& trace = played_.trace;
    const auto from = static_cast<std::ptrdiff_t>(first);
    const auto to = static_cast<std::ptrdiff_t>(first + count);
    trace.sample.erase(trace.sample.begin() + from, trace.sample.begin() + to);
    trace.voltage_pu.erase(trace.voltage_pu.begin() + from, trace.voltage_pu.begin() + to);
  }
};

TEST_F(AlignmentTest, DetectsADelayWithTheWrongSign) {
  // Stamps as if the window came after them instead of before: an error of 50 ms.
  const auto right = found();
  ASSERT_TRUE(right);
  VoltageTrace wrong = played_.trace;
  for (std::int64_t& sample : wrong.sample) {
    sample -= static_cast<std::int64_t>(wrong.window_samples);
  }
  const auto mutant = align(wrong, played_.markers, kTickRate_hz);
  ASSERT_TRUE(mutant);
  EXPECT_GT(error_ms(played_, *mutant), 40.0);
  expect_within(*right);
}

TEST_F(AlignmentTest, FailsWithoutTheMarkersBeforeTheRun) {
  const std::size_t second =
      reading_at(static_cast<double>(played_.markers.before.dips[1].from_tick));
  for (std::size_t i = second; i < second + 16; ++i) {
    played_.trace.voltage_pu[i] = 1.0F;
  }
  EXPECT_FALSE(found());
}

TEST_F(AlignmentTest, FailsOnADeadBusAndWithoutReadings) {
  std::fill(played_.trace.voltage_pu.begin(), played_.trace.voltage_pu.end(), 0.0F);
  EXPECT_FALSE(found());
  played_.trace = {};
  EXPECT_FALSE(found());
}

TEST_F(AlignmentTest, AssumesTheToleranceOfACrystalWithoutTheMarkersAfterTheRun) {
  const std::size_t end = reading_at(static_cast<double>(played_.run_ticks));
  lose(end, played_.trace.sample.size() - end);
  const auto alignment = found();
  ASSERT_TRUE(alignment);
  EXPECT_EQ(alignment->drift_ppm, 0.0);
  EXPECT_DOUBLE_EQ(alignment->drift_uncertainty_ppm, 100.0);
  expect_within(*alignment);
}

TEST_F(AlignmentTest, ToleratesTheLossOfAnyTwoReadings) {
  for (const MarkedStretch* stretch : {&played_.markers.before, &played_.markers.after}) {
    for (const Dip& dip : stretch->dips) {
      const Played whole = played_;
      const std::size_t first = reading_at(static_cast<double>(dip.from_tick));
      for (std::size_t lost = first; lost < first + 14; lost += 3) {
        lose(lost, 2);
        const auto alignment = found();
        ASSERT_TRUE(alignment) << "without readings " << lost << " and the next";
        expect_within(*alignment);
        played_ = whole;
      }
    }
  }
}

TEST_F(AlignmentTest, ToleratesAGainErrorOfTheOutlet) {
  for (float& volts : played_.trace.voltage_pu) {
    volts *= 1.02F;
  }
  const auto alignment = found();
  ASSERT_TRUE(alignment);
  expect_within(*alignment);
}

std::string step(double at_s, double duration_s, double level_pct) {
  return "[[signal.amplitude_step]]\nat_s = " + std::to_string(at_s) +
         "\nduration_s = " + std::to_string(duration_s) +
         "\nlevel_pct = " + std::to_string(level_pct) + "\n";
}

TEST(DisturbedRun, IsAlignedWithinTheUncertainty) {
  const std::string noise = "noise_pct = 1.0\n";
  const std::pair<double, std::string> runs[] = {
      {4.0, ""},
      {8.0, noise + step(1.0, 0.01, 0.0) + step(2.0, 0.02, 0.0) + step(3.0, 0.2, 40.0) +
                step(4.0, 0.5, 70.0) + step(5.0, 2.0, 80.0)},
      // Dips with the length, depth and spacing of markers.
      {4.0, noise + step(0.5, 0.17, 70.0) + step(1.06, 0.17, 70.0) + step(2.6, 0.17, 70.0)},
      // A dead bus; a dip at the end of the run.
      {8.0, noise + step(1.0, 5.0, 0.0)},
      {4.0, noise + step(3.8, 0.2, 40.0)}};
  for (const auto& [duration_s, signal] : runs) {
    SCOPED_TRACE(signal);
    const Crystal crystal = {80.0, 77, 0, 9};
    const Played played = play(plan_of(duration_s, "ieee24", signal, ""), crystal);
    const auto alignment = align(played.trace, played.markers, kTickRate_hz);
    ASSERT_TRUE(alignment);
    EXPECT_LE(error_ms(played, *alignment), alignment->uncertainty_ms);
    EXPECT_LE(std::fabs(alignment->drift_ppm - crystal.ppm), alignment->drift_uncertainty_ppm);
    EXPECT_LT(alignment->uncertainty_ms, kMostUncertainty_ms);
  }
}

}  // namespace
}  // namespace gsbench::capture
