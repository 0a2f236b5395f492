// Output of gsbench compare. Comparisons with emulated stations are in
// tests/bench/station/emulated/equivalence_test.cpp.
#include "gsbench_process.hpp"

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::HasSubstr;

TEST(Compare, PrintsWhatEachOutletOfEachStationMeasured) {
  const json compared = run_for_json({"compare", "regression/equivalence", "--station", "simulated",
                                      "--station", "simulated", "--json"});
  EXPECT_EQ(compared["profile"], "regression/equivalence");
  ASSERT_EQ(compared["stations"].size(), 2U);
  for (const json& station : compared["stations"]) {
    EXPECT_EQ(station["station"], "simulated");
    EXPECT_EQ(station["verdict"], "PASS");
    EXPECT_EQ(station["planned"]["frequency_mhz"], 0.0);
    ASSERT_EQ(station["outlets"].size(), 2U);
    for (const json& outlet : station["outlets"]) {
      // The tracker's own error on this profile.
      EXPECT_GT(outlet["frequency_mhz"]["rms"], 0.5);
      EXPECT_LT(outlet["frequency_mhz"]["rms"], 3.0);
      EXPECT_LT(outlet["voltage_pct"]["largest"], 0.6);
      // Simulated outlets without noise measure the same.
      EXPECT_EQ(outlet["from_first_mhz"]["largest"], 0.0);
    }
  }
}

TEST(Compare, HasTheWorstVerdictAsExitCode) {
  const Outcome outcome =
      run_gsbench({"compare", "regression/equivalence", "--station", "simulated"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("simulated: PASS"));
}

TEST(Compare, RefusesAnUnknownStationBeforeItPlays) {
  expect_refused(
      {"compare", "regression/equivalence", "--station", "simulated", "--station", "nonesuch"},
      "unknown station \"nonesuch\"");
}

}  // namespace
}  // namespace gsbench::test
