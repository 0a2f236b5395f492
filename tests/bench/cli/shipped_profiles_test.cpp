// Every shipped profile passes and leaves its reports.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <cctype>
#include <string>

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

// "paper/loss-500mw" as a part of a test's name.
std::string test_name(const testing::TestParamInfo<const char*>& each) {
  std::string name = each.param;
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    All, ShippedProfile,
    testing::Values("paper/loss-500mw", "paper/loss-351.9mw", "paper/loss-320mw",
                    "paper/loss-600mw", "regression/backup", "regression/command",
                    "regression/contact-only", "regression/equivalence", "events/gb-2019",
                    "events/iberia-2025", "disturbances/phase-jump", "disturbances/harmonics",
                    "disturbances/dips", "disturbances/dead-bus", "disturbances/mains-signalling"),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Cascades, ShippedProfile,
    testing::Values("cascades/deep-dip-at-the-loss", "cascades/dip-after-the-loss",
                    "cascades/dip-at-the-loss", "cascades/dip-then-loss",
                    "cascades/dips-from-a-voltage-zero", "cascades/four-losses",
                    "cascades/high-frequency-before", "cascades/loss-after-a-return",
                    "cascades/loss-that-returns", "cascades/loss-that-returns-in-part",
                    "cascades/low-frequency-before", "cascades/low-frequency-without-need",
                    "cascades/oscillation-then-loss", "cascades/oscillations-alone",
                    "cascades/phase-step-at-the-loss", "cascades/phase-steps-after-the-loss",
                    "cascades/ramp-after-a-loss", "cascades/ramp-of-one-second",
                    "cascades/ramp-of-three-seconds", "cascades/ramp-without-need",
                    "cascades/second-loss-after-two-seconds", "cascades/settings-during-the-event",
                    "cascades/three-losses", "cascades/two-losses-close-together",
                    "cascades/two-losses-half-a-second-apart", "cascades/two-losses-with-dips"),
    test_name);

// regression/steady takes an hour: see long_runs_test.cpp.
TEST(ShippedProfiles, AreAllTestedAbove) {
  EXPECT_EQ(run_for_json({"list", "--json"})["profiles"].size(), 16U + 26U);
}

}  // namespace
}  // namespace gsbench::test
