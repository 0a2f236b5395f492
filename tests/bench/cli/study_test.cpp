// A study as scripts read it.
#include "gsbench_process.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using gsbench::test::Outcome;
using gsbench::test::run_gsbench;
using nlohmann::json;

TEST(Study, TellsScriptsWhatWasPlayedAndHowEachMeasureSpread) {
  const Outcome outcome = run_gsbench({"study", "paper/loss-500mw", "--seeds", "3", "--first-seed",
                                       "7", "--within", "ekf.error=4", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json study = json::parse(outcome.out);
  EXPECT_EQ(study["profile"], "paper/loss-500mw");
  EXPECT_EQ(study["profile_sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(study["first_seed"], 7);
  EXPECT_EQ(study["seeds"], 3);
  EXPECT_EQ(study["verdict"], "PASS");
  EXPECT_TRUE(study["first_reason"].is_null());
  EXPECT_EQ(study["outlets"]["PASS"], 24);
  bool has_delay = false;
  for (const json& measure : study["measures"]) {
    if (measure["name"] == "event.delay") {
      has_delay = true;
      EXPECT_EQ(measure["unit"], "ms");
      EXPECT_EQ(measure["count"], 24);
      EXPECT_EQ(measure["verdicts"]["PASS"], 24);
      EXPECT_LE(measure["min"], measure["p50"]);
      EXPECT_LE(measure["p50"], measure["max"]);
    }
  }
  EXPECT_TRUE(has_delay);
  ASSERT_EQ(study["shares"].size(), 1U);
  EXPECT_EQ(study["shares"][0]["count"], 24);
  EXPECT_EQ(study["shares"][0]["share"], 1.0);
}

TEST(Study, SaysWhereNoOutletHasAValueForAShare) {
  const Outcome outcome =
      run_gsbench({"study", "paper/loss-320mw", "--seeds", "1", "--within", "command.delay=3"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("no outlet has a value"), std::string::npos) << outcome.out;
}

}  // namespace
