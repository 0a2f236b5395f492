// When a command was sent, on the time base of the run, and how uncertain the time from it to an
// edge is. The fake source has a clock at which the whole run lies within one tick.
#include "fake_station.hpp"
#include "plans.hpp"

#include <gtest/gtest.h>

#include <station/run.hpp>

namespace gsbench::station::test {
namespace {

constexpr const char* kSwitchOff = "[[command]]\nat_s = 0.5\nswitch = \"off\"\n";

Script with_sense() {
  Script script;
  script.sense_uncertainty_ticks = 8.0;
  script.edges = {{0, 5000, false}, {1, 5000, false}};
  return script;
}

// In ticks of the run, 0.125 ms each.
void expect_sent_at(const Script& script, std::int64_t tick, double uncertainty_ms) {
  FakeStation station(script);
  const record::RunRecord record = run(plan(1.0, kSwitchOff), station, {});
  ASSERT_EQ(record.fault, "");
  for (const record::OutletRecord& outlet : record.outlets) {
    const auto sent = std::find_if(outlet.reports.marks.begin(), outlet.reports.marks.end(),
                                   [](const record::Mark& mark) { return mark.kind == "command"; });
    ASSERT_NE(sent, outlet.reports.marks.end());
    EXPECT_EQ(sent->tick, tick);
    const auto* const delay = record::find_measurement(outlet, "command.delay");
    EXPECT_DOUBLE_EQ(delay->value, 0.125 * static_cast<double>(5000 - tick));
    EXPECT_NEAR(delay->uncertainty, uncertainty_ms, 1e-9);
  }
}

TEST(CommandTime, IsTheTickThatASourceInVirtualTimeHasReached) {
  expect_sent_at(with_sense(), 4000, 1.0);
}

TEST(CommandTime, IsAsUncertainAsTheSourcesClockOnThisMachine) {
  Script script = with_sense();
  constexpr double kTick_s = 1e6;
  script.host_clock = {
      {std::chrono::steady_clock::now() - std::chrono::seconds(4100'000'000), kTick_s, 0.010}};
  expect_sent_at(script, 4100, 1.0 + 10.0);
}

// A relay sense that counts this machine's clock was aligned with the voltage: the trigger of the
// source was 100 ticks earlier than the source believes.
TEST(CommandTime, IsAlignedLikeTheEdgesIfTheRelaySenseCountsThisMachinesClock) {
  Script script = with_sense();
  script.host_clock = {{std::chrono::steady_clock::now(), 1.0, 0.010}};
  script.sense_count_at_tick_0 = -100.0;
  script.sense_count_now = 4200;
  script.sense_uncertainty_between_ticks = 4.0;
  script.edges = {{0, 4900, false}, {1, 4900, false}};
  expect_sent_at(script, 4300, 0.5);
}

}  // namespace
}  // namespace gsbench::station::test
