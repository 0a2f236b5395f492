// A source that deviates too much is refused; what it states is in the record.
#include "fake_station.hpp"
#include "plans.hpp"
#include <test_support/refusal.hpp>

#include <gmock/gmock.h>

#include <station/run.hpp>
#include <station/source_check.hpp>

namespace gsbench::station::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Beyond, AcceptsUpToTheTolerance) {
  const profile::Tolerances tolerances{0.2, 0.5, 0.1};
  EXPECT_EQ(beyond(tolerances, {0.2, 0.5, 0.1}), "");
  EXPECT_EQ(beyond(tolerances, {0.21, 0.5, 0.1}),
            "frequency by 0.21 mHz (frequency_tolerance_mhz is 0.2)");
  EXPECT_EQ(beyond(tolerances, {0.2, 0.6, 0.1}), "voltage by 0.6 % (voltage_tolerance_pct is 0.5)");
  EXPECT_EQ(beyond(tolerances, {0.2, 0.5, 0.2}), "time by 0.2 ms (time_tolerance_ms is 0.1)");
  EXPECT_THAT(beyond(tolerances, {kNaN, kNaN, kNaN}),
              AllOf(HasSubstr("frequency"), HasSubstr("voltage"), HasSubstr("time")));
}

Script instrument(const source::Played& played) {
  Script script;
  script.played = played;
  script.accuracy = "not calibrated";
  return script;
}

TEST(SourceCheck, RunIsRefusedBeforeAnythingIsTouched) {
  FakeStation station(instrument({0.0021, 0.001, 0.0001}));
  EXPECT_EQ(gsbench::test::refusal_of<profile::ConfigurationError>(
                [&] { (void)run(plan(0.5), station, {}); }),
            "test.toml: fake source: the played signal would deviate too much from the profile: "
            "frequency by 2.1 mHz (frequency_tolerance_mhz is 2)");
  EXPECT_FALSE(station.was_touched());
  EXPECT_EQ(run(plan(0.5, "frequency_tolerance_mhz = 2.2\n"), station, {}).verdict,
            record::Verdict::kPass);
}

// 1.5 % of the waveform and 1 % of the amplitude.
TEST(SourceCheck, AccuracyOfTheAmplitudeCountsOnceBesideThePlannedVoltage) {
  FakeStation station(instrument({0.0, 0.015, 0.0, {}, 0.01}));
  EXPECT_THAT(gsbench::test::refusal_of<profile::ConfigurationError>(
                  [&] { (void)run(plan(0.5), station, {}); }),
              HasSubstr("voltage by 2.5 % (voltage_tolerance_pct is 2)"));
  EXPECT_THAT(gsbench::test::refusal_of<profile::ConfigurationError>(
                  [&] { (void)run(plan(0.5, "voltage_tolerance_pct = 2.49\n"), station, {}); }),
              HasSubstr("voltage by 2.5 %"));
  const record::RunRecord record = run(plan(0.5, "voltage_tolerance_pct = 2.51\n"), station, {});
  EXPECT_EQ(record.verdict, record::Verdict::kPass);
  EXPECT_NEAR(record.bench_uncertainty.voltage_pct, 2.5, 1e-9);
}

TEST(SourceCheck, SourceThatFindsMoreWhenItIsPreparedIsNotEnergised) {
  Script script = instrument({0.0021, 0.0, 0.0});
  script.accuracy = "";  // no check before prepare()
  FakeStation station(script);
  const record::RunRecord record = run(plan(0.5), station, {});
  EXPECT_EQ(record.verdict, record::Verdict::kError);
  EXPECT_THAT(record.fault, HasSubstr("frequency by 2.1 mHz"));
  EXPECT_FALSE(station.was_energised());
}

TEST(SourceCheck, StatementsOfTheSourceAreInTheRecord) {
  FakeStation station(instrument({0.0005, 0.002, 0.0003, {"20 points", "2 kSa/s"}}));
  const record::RunRecord record = run(plan(0.5), station, {});
  EXPECT_EQ(record.source.name, "fake source");
  EXPECT_EQ(record.source.how, "20 points\n2 kSa/s");
  EXPECT_EQ(record.source.accuracy, "not calibrated");
  EXPECT_DOUBLE_EQ(record.bench_uncertainty.frequency_mhz, 0.5);
  EXPECT_DOUBLE_EQ(record.bench_uncertainty.voltage_pct, 0.2);
  EXPECT_DOUBLE_EQ(record.bench_uncertainty.time_ms, 0.3);
}

// 8 and 16 ticks at 8 kHz are 3 ms; the source adds 0.5 ms.
TEST(SourceCheck, UncertaintyOfTheRelaySenseIsThatAfterTheRunAndOfTheSource) {
  Script script = instrument({0.0, 0.0, 0.0005});
  script.sense_uncertainty_ticks = 8.0;
  script.sense_uncertainty_grows_ticks = 16.0;
  script.edges = {{0, 2000, false}};
  FakeStation station(script);
  const record::RunRecord record = run(plan(0.5), station, {});
  EXPECT_DOUBLE_EQ(record.bench_uncertainty.relay_sense_ms, 3.5);
  EXPECT_DOUBLE_EQ(record::find_measurement(record.outlets.at(0), "trip.time")->uncertainty,
                   0.0035);
  ASSERT_EQ(record.clocks.size(), 3U);
  EXPECT_EQ(record.clocks[0].what, "source");
  EXPECT_DOUBLE_EQ(record.clocks[0].uncertainty_ms, 0.5);
  EXPECT_EQ(record.clocks[1].what, "relay sense");
  EXPECT_DOUBLE_EQ(record.clocks[1].uncertainty_ms, 3.5);
  EXPECT_EQ(record.clocks[2].what, "outlets");
}

}  // namespace
}  // namespace gsbench::station::test
