// Long runs: a complete recorded collapse, such as that of Iberia on 28 April 2025, and an hour
// without an event.
#include "gsbench_process.hpp"
#include <test_support/collapse_recordings.hpp>

#include <gtest/gtest.h>

namespace gsbench::test {
namespace {

std::string profile_of(const CollapseRecording& collapse) {
  return fmt::format(R"(title = "A recorded collapse"
source = "a grid analyser"
[grid]
system = "ieee24"
[signal]
noise_pct = 1.0
[signal.trace]
file = "{}"
time = "{}"
frequency = "{}"
voltage = "{}"
[[outlet]]
count = 2
accumulated_mw = 2500.0
switch_off_hz = 48.9
[[expect]]
measure = "trip.time"
unit = "s"
min = {}
max = {}
[[expect]]
measure = "decision.cause"
equals = "frequency"
[[expect]]
measure = "validity.dead_bus_claims"
max = 0
[[expect]]
measure = "relay.edges"
min = 1
max = 1
)",
                     collapse.path, kCollapseTime, kCollapseFrequency, kCollapseVoltage,
                     collapse.last_ordinary_s, collapse.last_ordinary_s + 8.0);
}

TEST(RecordedCollapse, TripsByTheSwitchOffFrequencyAndReportsNoFrequencyOnTheDeadBus) {
  const TemporaryFolder folder;
  for (const CollapseRecording& collapse : collapse_recordings(folder)) {
    SCOPED_TRACE(collapse.path);
    const json result = run_for_json({"run", folder.write("collapse.toml", profile_of(collapse)),
                                      "--json", "--out", folder.file("runs")});
    EXPECT_EQ(result["verdict"], "PASS") << result;
    EXPECT_EQ(result["outlets"].size(), 2U);
  }
}

// At nominal frequency with 1 % noise.
TEST(SteadyHour, PassesWithoutAnEvent) {
  const TemporaryFolder folder;
  const Outcome outcome = run_gsbench({"run", "regression/steady", "--out", folder.file("runs")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
}

}  // namespace
}  // namespace gsbench::test
