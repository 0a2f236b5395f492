// Every shipped profile passes, from the first sample to the reports.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <render/render.hpp>

namespace {

namespace fs = std::filesystem;
using gsbench::test::Outcome;
using gsbench::test::run_gsbench;
using gsbench::test::TemporaryFolder;
using nlohmann::json;

class ShippedProfile : public testing::TestWithParam<const char*> {};

TEST_P(ShippedProfile, PassesAndLeavesItsReports) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_gsbench({"run", GetParam(), "--json", "--out", folder.path().string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["profile"], GetParam());
  std::size_t judged = 0;
  for (const json& outlet : result["outlets"]) {
    for (const json& measurement : outlet["measurements"]) {
      judged += measurement["judged"] == true ? 1 : 0;
      EXPECT_EQ(measurement["verdict"], measurement["judged"] == true ? json("PASS") : json())
          << outlet["id"] << measurement;
    }
  }
  EXPECT_GT(judged, 0U);
  const fs::path run = gsbench::test::only_run(folder.path());
  EXPECT_TRUE(fs::exists(run / "record.sqlite"));
  for (const gsbench::render::Format& format : gsbench::render::kFormats) {
    EXPECT_TRUE(!format.is_kept() || fs::is_regular_file(run / format.file)) << format.file;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedProfile,
                         testing::Values("paper/loss-500mw", "paper/loss-351.9mw",
                                         "paper/loss-320mw", "paper/loss-600mw",
                                         "regression/backup", "regression/command",
                                         "events/gb-2019", "events/iberia-2025",
                                         "disturbances/phase-jump", "disturbances/harmonics",
                                         "disturbances/dips", "disturbances/dead-bus"),
                         [](const auto& each) {
                           std::string name = each.param;
                           for (char& c : name) {
                             c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                           }
                           return name;
                         });

// The thirteenth, regression/steady, is an hour: see steady_hour_test.cpp.
TEST(ShippedProfiles, AreAllInThatListButOne) {
  const json list = json::parse(run_gsbench({"list", "--json"}).out);
  EXPECT_EQ(list["profiles"].size(), 13U);
}

// Xiang et al., §6.3: 92.38 % of the estimates within 4 %. The short form of the study over 200
// seeds.
TEST(ShippedProfiles, The500MegawattStudyKeepsItsFigures) {
  const Outcome outcome = run_gsbench({"study", "paper/loss-500mw", "--seeds", "25", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  const json study = json::parse(outcome.out);
  const auto measure = [&](const std::string& name) {
    for (const json& row : study["measures"]) {
      if (row["name"] == name) {
        return row;
      }
    }
    return json();
  };
  EXPECT_EQ(measure("event.delay")["count"], 200);
  EXPECT_LE(measure("event.delay")["p50"], 120.0);
  EXPECT_LE(measure("event.delay")["p99"], 160.0);
  EXPECT_LE(measure("decision.delay")["max"], 960.0);
  EXPECT_EQ(measure("event.false")["max"], 0.0);
  for (const json& share : study["shares"]) {
    EXPECT_GE(share["share"], share["within"] == 4.0 ? 0.999 : 0.90);
  }
}

}  // namespace
