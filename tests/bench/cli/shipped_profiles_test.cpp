// Every shipped profile passes and leaves its reports; judged again from its record, it has the
// same results.
#include "gsbench_process.hpp"
#include <test_support/shipped_profiles.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include <render/render.hpp>

namespace gsbench::test {
namespace {

namespace fs = std::filesystem;

class ShippedProfile : public testing::TestWithParam<std::string> {};

TEST_P(ShippedProfile, PassesLeavesItsReportsAndIsJudgedAgainAsRecorded) {
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
  const json again = run_for_json({"rejudge", run.string(), "--json"});
  EXPECT_EQ(again["differences"], json::array());
}

std::vector<std::string> passing_profiles() {
  std::vector<std::string> names = shipped_profiles();
  // regression/steady takes an hour: see long_runs_test.cpp.
  names.erase(std::remove_if(names.begin(), names.end(),
                             [](const std::string& name) { return name == "regression/steady"; }),
              names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedProfile, testing::ValuesIn(passing_profiles()), test_name);

TEST(ShippedProfiles, AreAllListed) {
  const json all = run_for_json({"list", "--json"});
  std::vector<std::string> listed;
  for (const json& profile : all["profiles"]) {
    listed.push_back(profile["name"]);
  }
  EXPECT_EQ(listed, shipped_profiles());
}

}  // namespace
}  // namespace gsbench::test
