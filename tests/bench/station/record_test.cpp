// Contents of a run's record.

#include "fake_station.hpp"
#include "plans.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include <station/run.hpp>

namespace gsbench::station::test {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

record::RunRecord record_of(const profile::Plan& plan, const Script& script = {}) {
  FakeStation station(script);
  return run(plan, station, {});
}

TEST(RunRecord, ContainsTheProfileTheStationAndTheVersions) {
  profile::Plan plan = test::plan(0.2);
  plan.seed = 42;
  const record::RunRecord record = record_of(plan);
  EXPECT_EQ(record.profile_title, "A test");
  EXPECT_EQ(record.profile_source, "None");
  EXPECT_EQ(record.profile_text, profile_text(0.2));
  EXPECT_EQ(record.profile_sha256, plan.sha256);
  EXPECT_EQ(record.grid, plan.grid.name);
  EXPECT_EQ(record.grid_sha256, plan.grid.sha256);
  EXPECT_EQ(record.grid_sha256.size(), 64U);
  EXPECT_EQ(record.recording.file, "");
  EXPECT_FALSE(record.interrupted);
  EXPECT_EQ(record.station, "fake");
  EXPECT_EQ(record.seed, 42U);
  EXPECT_EQ(record.sample_rate_hz, 8000);
  EXPECT_EQ(record.duration_ticks, 1600);
  EXPECT_EQ(record.nominal_hz, 50.0);
  EXPECT_EQ(record.firmware_sha256.size(), 64U);
  EXPECT_FALSE(record.gsbench_version.empty());
  EXPECT_EQ(record.reference.tick.back(), 1600);
  EXPECT_EQ(record.started_utc.size(), std::string("2025-04-28T12:33:16Z").size());
  EXPECT_LE(record.started_utc, record.finished_utc);
}

TEST(RunRecord, ContainsWhichContactsAreSensed) {
  const record::RunRecord record = record_of(test::plan(0.2), with(&Script::relay_channels, 1U));
  ASSERT_EQ(record.outlets.size(), 2U);
  EXPECT_TRUE(record.outlets[0].relay_sensed);
  EXPECT_FALSE(record.outlets[1].relay_sensed);
}

TEST(RunRecord, ContainsTheIdentityAndSettingsOfEachOutlet) {
  const record::RunRecord record = record_of(test::plan(0.2));
  ASSERT_EQ(record.outlets.size(), 2U);
  const record::OutletRecord& outlet = record.outlets[1];
  EXPECT_EQ(outlet.id, "serial-2") << "its own name, not the profile's";
  EXPECT_EQ(outlet.group, "all");
  EXPECT_EQ(outlet.firmware, "1.2.3");
  EXPECT_NEAR(outlet.settings.at("tracker_delay_s"), 0.028, 1e-9);
  EXPECT_NEAR(outlet.settings.at("threshold_mw"), 340.12, 0.01);
}

TEST(RunRecord, OmitsOutletsThatThePlanDoesNotNeed) {
  FakeStation station(with(&Script::outlets, 4U));
  const record::RunRecord record = run(test::plan(0.2), station, {});
  EXPECT_EQ(record.verdict, record::Verdict::kPass) << record.verdict_reason;
  EXPECT_EQ(record.outlets.size(), 2U);
  EXPECT_TRUE(station.sent_to(2).empty());
}

record::MeasurementResult measured(const record::OutletRecord& outlet, const std::string& name) {
  for (const record::MeasurementResult& result : outlet.measurements) {
    if (result.name == name) {
      return result;
    }
  }
  return {};
}

TEST(RunRecord, HasOnlyTheContactOfAnOutletWithoutALink) {
  Script script = with(&Script::without_link, true);
  script.edges = {{1, 400, false}};
  FakeStation station(script);
  profile::Plan plan =
      test::plan(3.0, "", "[[outlet]]\nid = \"linked\"\n[[outlet]]\nid = \"alone\"\n");
  plan.expectations =
      test::parse(test::profile_text(3.0, "",
                                     "[[outlet]]\nid = \"alone\"\n[[expect]]\n"
                                     "measure = \"relay.edges\"\nmin = 1\nmax = 1\n"))
          .expectations;
  plan.expectations.back().groups = {"linked"};
  const record::RunRecord record = run(plan, station, {});
  const record::OutletRecord& outlet = record.outlets[1];
  EXPECT_EQ(outlet.id, "serial-2");
  EXPECT_TRUE(outlet.took_part);
  EXPECT_EQ(outlet.fault, "") << "an outlet without a link cannot stop reporting";
  EXPECT_TRUE(outlet.settings.empty());
  EXPECT_TRUE(station.sent_to(1).empty());
  EXPECT_EQ(measured(outlet, "relay.edges").verdict, record::Verdict::kPass);
  EXPECT_EQ(record::find_measurement(outlet, "event.count"), nullptr);
  EXPECT_NE(record::find_measurement(record.outlets[0], "event.count"), nullptr);
  EXPECT_EQ(outlet.verdict, record::Verdict::kPass);
}

TEST(RunRecord, AssignsTheSlotWithTheSerialNumberThatThePlanNames) {
  const record::RunRecord record =
      record_of(test::plan(0.2, "", "[[outlet]]\nid = \"any\"\n[[outlet]]\nid = \"serial-1\"\n"));
  EXPECT_EQ(record.outlets[0].id, "serial-2");
  EXPECT_EQ(record.outlets[0].group, "any");
  EXPECT_EQ(record.outlets[1].id, "serial-1");
}

std::string noise_of(const std::string& noise_line, bool per_outlet) {
  return record_of(test::plan(0.2, noise_line), with(&Script::noise_per_outlet, per_outlet)).noise;
}

TEST(RunRecord, ContainsADescriptionOfTheNoise) {
  EXPECT_EQ(noise_of("", true), "none");
  EXPECT_EQ(noise_of("noise_pct = 1.0\n", true), "1 % white, each outlet its own");
  EXPECT_EQ(noise_of("noise_pct = 0.25\n", false), "0.25 % white, the same at all outlets");
  EXPECT_EQ(noise_of("noise_pct = 10\n", false), "10 % white, the same at all outlets");
}

TEST(RunRecord, MarksTheStimulusInOrderOfTime) {
  // 0.017 s is tick 102 at 6 kHz, although 0.017 · 6000 > 102 in doubles.
  const record::RunRecord record =
      record_of(test::plan(0.5,
                           "sample_rate_hz = 6000\n"
                           "[[signal.amplitude_step]]\nat_s = 0.2\nduration_s = 0.1\n"
                           "level_pct = 40.0\n"
                           "[[signal.amplitude_step]]\nat_s = 0.4\nlevel_pct = 80.0\n"
                           "[[signal.phase_jump]]\nat_s = 0.017\ndegrees = -20.0\n"
                           "[[grid.loss]]\nat_s = 0.3\npower_mw = -50.0\n"
                           "[[grid.loss]]\nat_s = 0.1\npower_mw = 500.0\n"));
  std::vector<std::string> marks;
  for (const record::Mark& mark : record.stimulus) {
    marks.push_back(std::to_string(mark.tick) + " " + mark.kind + " " +
                    std::to_string(static_cast<int>(mark.value)));
    EXPECT_FALSE(mark.text.empty()) << mark.kind;
  }
  EXPECT_THAT(marks, ElementsAre("102 phase jump -20", "600 loss 500", "1200 amplitude 40",
                                 "1800 shed -50", "1800 amplitude 100", "2400 amplitude 80"));
}

TEST(RunRecord, MarksTheStartAndTheEndOfARamp) {
  const record::RunRecord record =
      record_of(test::plan(0.5,
                           "[[grid.loss]]\nat_s = 0.1\npower_mw = 500.0\nramp_s = 0.25\n"
                           "[[grid.loss]]\nat_s = 0.2\npower_mw = -40.0\nramp_s = 3.0\n"));
  std::vector<std::string> marks;
  for (const record::Mark& mark : record.stimulus) {
    marks.push_back(std::to_string(mark.tick) + " " + mark.kind + ": " + mark.text);
  }
  EXPECT_THAT(marks,
              ElementsAre("800 loss: 500 MW lost over 0.25 s", "1600 shed: 40 MW shed over 3 s",
                          "2800 ramp end: end of 500 MW lost over 0.25 s"));
}

TEST(RunRecord, MarksTheStartAndTheEndOfAnOscillation) {
  const record::RunRecord record =
      record_of(test::plan(0.5,
                           "[[signal.oscillation]]\nfrequency_hz = 0.4\namplitude_mhz = 60\n"
                           "[[signal.oscillation]]\nat_s = 0.1\nduration_s = 0.3\n"
                           "frequency_hz = 1.5\namplitude_mhz = 5\n"));
  std::vector<std::string> marks;
  for (const record::Mark& mark : record.stimulus) {
    marks.push_back(std::to_string(mark.tick) + " " + mark.kind + ": " + mark.text);
  }
  EXPECT_THAT(marks, ElementsAre("0 oscillation: 0.4 Hz oscillation, ± 60 mHz",
                                 "800 oscillation: 1.5 Hz oscillation, ± 5 mHz",
                                 "3200 oscillation: end of 1.5 Hz oscillation"));
}

TEST(RunRecord, MarksTheStartAndTheEndOfATone) {
  const record::RunRecord record =
      record_of(test::plan(0.5,
                           "[[signal.tone]]\nat_s = 0.1\nduration_s = 0.3\n"
                           "frequency_hz = 216.7\namplitude_pct = 9\n"));
  std::vector<std::string> marks;
  for (const record::Mark& mark : record.stimulus) {
    marks.push_back(std::to_string(mark.tick) + " " + mark.kind + ": " + mark.text);
  }
  EXPECT_THAT(marks,
              ElementsAre("800 tone: 216.7 Hz tone, 9 %", "3200 tone: end of 216.7 Hz tone"));
}

TEST(RunRecord, SendsCommandsToTheirOutletsAndMarksThem) {
  FakeStation station({});
  const record::RunRecord record =
      run(test::plan(1.0,
                     "[[command]]\nat_s = 0.333\noutlets = [\"b\"]\nswitch = \"off\"\n"
                     "[[command]]\nat_s = 0.5\nswitch = \"on\"\n",
                     "[[outlet]]\nid = \"a\"\n[[outlet]]\nid = \"b\"\n"),
          station, {});
  // Settings and self test, then the commands.
  EXPECT_EQ(station.sent_to(0).size(), 3U);
  ASSERT_EQ(station.sent_to(1).size(), 4U);
  EXPECT_FALSE(station.sent_to(1)[2].close_relay);
  EXPECT_TRUE(station.sent_to(1)[3].close_relay);
  std::vector<std::int64_t> ticks;
  for (const record::Mark& mark : record.outlets[1].reports.marks) {
    if (mark.kind == "command") {
      ticks.push_back(mark.tick);
    }
  }
  EXPECT_THAT(ticks, ElementsAre(2664, 4000));
}

TEST(RunRecord, SendsSettingsAgainToTheirOutletsAndMarksThem) {
  FakeStation station({});
  const record::RunRecord record =
      run(test::plan(1.0,
                     "[[settings]]\nat_s = 0.333\noutlets = [\"b\"]\naccumulated_mw = 120\n"
                     "threshold_mw = 300\n"
                     "[[settings]]\nat_s = 0.5\n",
                     "[[outlet]]\nid = \"a\"\n[[outlet]]\nid = \"b\"\n"),
          station, {});
  // Settings and self test, then the settings again.
  ASSERT_EQ(station.sent_to(0).size(), 3U);
  ASSERT_EQ(station.sent_to(1).size(), 4U);
  const gs::outlet::Settings& first = station.sent_to(1)[0].settings;
  const gs::outlet::Settings& second = station.sent_to(1)[2].settings;
  const gs::outlet::Settings& third = station.sent_to(1)[3].settings;
  EXPECT_EQ(station.sent_to(1)[2].kind, gs::wire::DownlinkKind::kSettings);
  EXPECT_EQ(second.version, first.version + 1);
  EXPECT_EQ(third.version, first.version + 2);
  EXPECT_EQ(first.accumulated_mw, 0.0F);
  EXPECT_EQ(second.accumulated_mw, 120.0F);
  EXPECT_EQ(second.threshold_mw, 300.0F);
  EXPECT_EQ(third.threshold_mw, 300.0F) << "the changes stay";
  EXPECT_EQ(station.sent_to(0)[2].settings.version, station.sent_to(0)[0].settings.version + 1);
  EXPECT_EQ(station.sent_to(0)[2].settings.threshold_mw,
            station.sent_to(0)[0].settings.threshold_mw);

  std::vector<std::string> marks;
  for (const record::Mark& mark : record.outlets[1].reports.marks) {
    if (mark.kind == "settings") {
      marks.push_back(std::to_string(mark.tick) + " version " +
                      std::to_string(static_cast<int>(mark.value)) + ": " + mark.text);
    }
  }
  const auto version = [&](const gs::outlet::Settings& of) { return std::to_string(of.version); };
  EXPECT_THAT(marks, ElementsAre("2664 version " + version(second) +
                                     ": accumulated_mw = 120, threshold_mw = 300",
                                 "4000 version " + version(third) + ": unchanged"));
  EXPECT_EQ(record.outlets[1].settings.at("accumulated_mw"), 0.0) << "those of the start";
}

TEST(RunRecord, ComparesTheGridWithThePublication) {
  const profile::Plan plan = test::plan(0.2);
  const std::vector<record::Comparison> all = record_of(plan).comparisons;
  ASSERT_EQ(all.size(), 2 + plan.grid.reference.condition_rocof_hz_s.size());
  EXPECT_EQ(all[0].name, "threshold loss, eq. (15)");
  EXPECT_EQ(all[0].unit, "MW");
  EXPECT_NEAR(all[0].ours, 351.92, 0.1);
  EXPECT_EQ(all[0].published, *plan.grid.reference.threshold_mw);
  // For the time of the nadir the publication deviates from its own equations.
  EXPECT_EQ(all[1].unit, "s");
  EXPECT_NEAR(all[1].ours, 3.76, 0.01);
  EXPECT_NEAR(all[1].published, 3.72, 0.01);
  EXPECT_FALSE(all[1].note.empty());
  for (std::size_t row = 2; row < all.size(); ++row) {
    EXPECT_THAT(all[row].name, StartsWith("condition "));
    EXPECT_NEAR(all[row].ours, all[row].published, 3e-4) << all[row].name;
  }
}

TEST(RunRecord, HasNoComparisonsWithoutAPublication) {
  profile::Plan plan = test::plan(0.2);
  plan.grid.reference = {};
  EXPECT_TRUE(record_of(plan).comparisons.empty());
}

TEST(RunRecord, HasTheWorstVerdictAndTheNumberOfOutletsThatDidNotPass) {
  const record::RunRecord record =
      record_of(test::plan(0.5, "",
                           "[[outlet]]\nid = \"a\"\n[[outlet]]\nid = \"b\"\n"
                           "[[expect]]\nmeasure = \"relay.edges\"\nmin = 1\noutlets = [\"b\"]\n"));
  EXPECT_EQ(record.outlets[0].verdict, record::Verdict::kPass);
  EXPECT_EQ(record.outlets[1].verdict, record::Verdict::kFail);
  EXPECT_EQ(record.verdict, record::Verdict::kFail);
  EXPECT_EQ(record.verdict_reason, "1 of 2 outlets did not pass");
}

TEST(RunRecord, ProgressRisesToOne) {
  FakeStation station({});
  std::vector<double> parts;
  RunOptions options;
  options.progress = [&](double part) { parts.push_back(part); };
  run(test::plan(1.0), station, options);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_GT(parts.front(), 0.0);
  EXPECT_EQ(parts.back(), 1.0);
}

}  // namespace
}  // namespace gsbench::station::test
