// Checks each measure of the catalogue against a record whose values are calculated by hand.

#include "synthetic_case.hpp"
#include <grid_test/example_grids.hpp>

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>
#include <judge/reading.hpp>
#include <measures/catalogue.hpp>
#include <outlet/estimator.hpp>

namespace gsbench::judge::test {
namespace {

struct Known {
  const char* measure;
  double value;
  double tolerance;
  double uncertainty;
  const char* text = "";
};

// Tolerances of values from the traces, which are floats: 4 µHz near 50 Hz, 30 nHz/s for a ROCOF,
// 0.24 µs near 3 s. Values from ticks are exact except for rounding in doubles.
constexpr double kFrequency_mhz = 0.004;
constexpr double kExact = 1e-9;

const std::vector<Known>& loss_values() {
  static const std::vector<Known> all = {
      {"tracker.error.max", 3.0, kFrequency_mhz, 0.1},
      {"tracker.error.rms", std::sqrt(5.0), kFrequency_mhz, 0.1},
      {"tracker.bias", 1.0, kFrequency_mhz, 0.1},
      {"tracker.rocof_error.rms", 0.1, 1e-6, 0.0},
      // 312 reports after the first second, 4 of them not valid.
      {"validity.valid_share", 100.0 * 308.0 / 312.0, kExact, 0.0},
      {"validity.dead_bus_claims", 0.0, 0.0, 0.0},
      {"event.count", 1.0, 0.0, 0.0},
      {"event.false", 0.0, 0.0, 0.0},
      {"event.delay", 120.0, kExact, 0.4},
      {"condition.hits", 30.0, 0.0, 0.0},
      {"lse.loss", 450.0, 0.0, 0.0},
      {"lse.error", -10.0, kExact, 0.0},
      {"ekf.loss", 515.0, 0.0, 0.0},
      {"ekf.error", 3.0, kExact, 0.0},
      {"ekf.t_x_error", 10.0, 0.0003, 0.4},
      {"decision.delay", 920.0, kExact, 0.4},
      {"decision.trust", NAN, 0.0, 0.0, "trusted"},
      {"decision.cause", NAN, 0.0, 0.0, "loss"},
      {"relay.delay", 928.0, kExact, 0.3},
      {"relay.delay_reported", 920.0, kExact, 0.4},
      {"relay.report_difference", 8.0, kExact, 0.5},
      {"relay.operate_time", 8.0, kExact, 0.5},
      {"relay.end", NAN, 0.0, 0.0, "open"},
      {"relay.edges", 1.0, 0.0, 0.0},
      {"relay.chatter", 0.0, 0.0, 0.0},
      {"trip.time", 3.928, kExact, 0.3e-3},
      // 0.4 Hz/s from 3 s on; the source is 0.1 mHz off.
      {"relay.operate_hz", 50.0 - 0.4 * 0.928, kExact, 0.4 * 0.3e-3 + 0.1e-3},
      {"clock.drift", 30.0, 0.0, 8.0},
      {"clock.uncertainty", 0.4, 0.0, 0.0},
  };
  return all;
}

void expect_known(const SyntheticCase& c, const Known& known) {
  const measures::Measure* measure = measures::find(known.measure);
  ASSERT_NE(measure, nullptr) << known.measure;
  const Reading reading = reading_of(measure->name)(c.view());
  EXPECT_EQ(reading.missing, "") << known.measure;
  EXPECT_EQ(reading.text, known.text) << known.measure;
  EXPECT_NEAR(reading.uncertainty, known.uncertainty, kExact) << known.measure;
  if (measure->is_text()) {
    EXPECT_TRUE(std::isnan(reading.value)) << known.measure;
  } else {
    EXPECT_NEAR(reading.value, known.value, known.tolerance) << known.measure;
  }
}

// Without the errors in the other measures: the fit would take them for a delay.
SyntheticCase exact_tracker(double delay_s) {
  SyntheticCase c = loss_of_500_mw();
  for (std::size_t i = 0; i < c.outlet.reports.trace.tick.size(); ++i) {
    c.outlet.reports.trace.frequency_hz[i] = static_cast<float>(c.reference->frequency_hz(
        1e-3 * static_cast<double>(c.outlet.reports.trace.tick[i]) - delay_s));
  }
  return c;
}

TEST(KnownValues, AreReadFromTheRecordWithALoss) {
  const SyntheticCase c = loss_of_500_mw();
  for (const Known& known : loss_values()) {
    expect_known(c, known);
  }
}

TEST(KnownValues, OfEstimatesByTheGridsStateIncludeThePowerLostBefore) {
  SyntheticCase c = loss_of_500_mw();
  c.plan.grid = grid::ieee24();
  c.plan.stimulus.initial_deviation_hz = -0.1;
  const double before_mw = 0.1 / grid::SfrModel(c.plan.grid).gain_hz_per_mw();
  for (const double method : {0.0, 1.0}) {
    c.outlet.settings["method"] = method;
    c.set_marks("decision.loss", 515.0 + method * before_mw);
    expect_known(c, {"ekf.error", 3.0, 1e-6, 0.0});
  }
}

TEST(KnownValues, OfTheTrustAreTheTextsOfTheFirmware) {
  std::vector<std::string> texts;
  for (std::uint8_t trust = 0; trust <= static_cast<std::uint8_t>(gs::outlet::kLastTrust);
       ++trust) {
    texts.emplace_back(to_string(static_cast<gs::outlet::Trust>(trust)));
  }
  EXPECT_EQ(measures::find("decision.trust")->text_values, texts);
}

TEST(KnownValues, AreReadFromTheRecordWithACommand) {
  const SyntheticCase c = commanded();
  expect_known(c, {"command.delay", 12.0, kExact, 0.6});
  expect_known(c, {"relay.operate_time", 7.0, kExact, 0.5});
  expect_known(c, {"trip.time", 2.012, kExact, 0.3e-3});
  expect_known(c, {"decision.cause", NAN, 0.0, 0.0, "command"});
  expect_known(c, {"relay.end", NAN, 0.0, 0.0, "open"});
}

// The search ends within 0.1 ms; the float adds 4 µHz on 0.4 Hz/s, 0.01 ms.
TEST(KnownValues, OfTheTrackerDelayAreWithinATenthOfAMillisecond) {
  for (const double delay_s : {0.0, 0.028, 0.1}) {
    expect_known(exact_tracker(delay_s),
                 {"tracker.delay", 1e3 * delay_s, 0.1, std::hypot(0.1, 0.4)});
  }
}

TEST(KnownValues, CoverEveryMeasureOfTheCatalogue) {
  std::set<std::string> tested = {"command.delay", "tracker.delay"};
  for (const Known& known : loss_values()) {
    tested.insert(known.measure);
  }
  std::set<std::string> all;
  for (const measures::Measure& measure : measures::catalogue()) {
    all.insert(measure.name);
  }
  EXPECT_EQ(tested, all);
}

TEST(Readings, CoverExactlyTheMeasuresOfTheCatalogue) {
  std::set<std::string> readings;
  for (const auto& [name, read] : all_readings()) {
    EXPECT_EQ(reading_of(name), read) << name;
    EXPECT_NE(measures::find(name), nullptr) << name;
    EXPECT_TRUE(readings.insert(name).second) << name;
  }
  EXPECT_EQ(readings.size(), measures::catalogue().size());
  EXPECT_THROW((void)reading_of("event.dela"), std::logic_error);
}

}  // namespace
}  // namespace gsbench::judge::test
