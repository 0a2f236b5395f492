// Every shipped profile passes and leaves its reports.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include <render/render.hpp>

namespace gsbench::test {
namespace {

namespace fs = std::filesystem;

class ShippedProfile : public testing::TestWithParam<const char*> {};

TEST_P(ShippedProfile, PassesAndLeavesItsReports) {
  const TemporaryFolder folder;
  const json result = run_for_json({"run", GetParam(), "--json", "--out", folder.path().string()});
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
  const fs::path run = only_run(folder.path());
  EXPECT_TRUE(fs::exists(run / "record.sqlite"));
  for (const render::Format& format : render::kFormats) {
    EXPECT_TRUE(!format.is_kept() || fs::is_regular_file(run / format.file)) << format.file;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedProfile,
                         testing::Values("paper/loss-500mw", "paper/loss-351.9mw",
                                         "paper/loss-320mw", "paper/loss-600mw",
                                         "regression/backup", "regression/command",
                                         "regression/contact-only", "regression/equivalence",
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

// regression/steady takes an hour: see long_runs_test.cpp. Those of cascades/ are read by the tests
// of profiles, not run here.
TEST(ShippedProfiles, AreAllTestedAbove) {
  const json profiles = run_for_json({"list", "--json"})["profiles"];
  EXPECT_EQ(std::count_if(profiles.begin(), profiles.end(),
                          [](const json& profile) {
                            return profile["name"].get<std::string>().rfind("cascades/", 0) != 0;
                          }),
            15);
}

}  // namespace
}  // namespace gsbench::test
