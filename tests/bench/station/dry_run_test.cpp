// A dry run states what a run would do and refuses what it would refuse.
#include "fake_station.hpp"
#include "plans.hpp"
#include <test_support/refusal.hpp>

#include <cmath>

#include <gmock/gmock.h>

#include <station/dry_run.hpp>

namespace gsbench::station::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal_of(const Script& script, const profile::Plan& plan) {
  FakeStation station(script);
  std::string refusal =
      gsbench::test::refusal_of<profile::ConfigurationError>([&] { (void)dry_run(plan, station); });
  EXPECT_FALSE(station.was_touched());
  return refusal;
}

TEST(DryRun, StatesSignalSourceSlotsAndClocks) {
  Script script;
  script.counts_ticks = false;
  script.answers_within = std::chrono::seconds(20);
  script.accuracy = "not calibrated";
  script.sense_not_known_yet = "how late it starts";
  script.played = {0.0005, 0.001, 0.0003, {"20 points"}};
  FakeStation station(script);
  const DryRun dry = dry_run(plan(1.0), station);
  EXPECT_FALSE(station.was_touched());
  EXPECT_EQ(dry.source, "fake source");
  EXPECT_THAT(dry.played.how, ElementsAre("20 points"));
  EXPECT_DOUBLE_EQ(dry.boot_s, 20.0);
  EXPECT_DOUBLE_EQ(dry.markers_before_s, 2.8);
  EXPECT_DOUBLE_EQ(dry.run_s, 1.0);
  EXPECT_DOUBLE_EQ(dry.markers_after_s, 2.0);
  ASSERT_EQ(dry.slots.size(), 2U);
  EXPECT_EQ(dry.slots[1].serial_number, "serial-2");
  ASSERT_EQ(dry.clocks.size(), 3U);
  EXPECT_EQ(dry.clocks[0].what, "source");
  EXPECT_DOUBLE_EQ(dry.clocks[1].uncertainty_ms, 0.3);
  EXPECT_EQ(dry.clocks[0].not_known_yet, "");
  EXPECT_EQ(dry.clocks[1].not_known_yet, "how late it starts");
  EXPECT_TRUE(std::isnan(dry.clocks[2].uncertainty_ms));
}

TEST(DryRun, RefusesWhatARunRefuses) {
  Script script;
  script.played.voltage_pu = 0.03;
  EXPECT_THAT(refusal_of(script, plan(1.0)), HasSubstr("voltage by 3 %"));
  EXPECT_THAT(refusal_of(with(&Script::without_link, true), plan(1.0)),
              HasSubstr("event.count needs a link"));
  EXPECT_THAT(refusal_of(with(&Script::outlets, 1U), plan(1.0)),
              HasSubstr("2 outlets; the station fake has 1"));
  EXPECT_EQ(refusal_of({}, plan(1.0)), "");
}

}  // namespace
}  // namespace gsbench::station::test
