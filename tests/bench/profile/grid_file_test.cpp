// Grids from files of their own.
#include <control_centre/threshold.hpp>
#include <profile_test/texts.hpp>

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsbench::profile::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kGrid = R"(title = "Small"
source = "Here"
[system]
nominal_hz = 50.0
threshold_hz = 49.5
base_mw = 100.0
load_mw = 100.0
damping_pu = 1.0
[[plant]]
id = "one"
rating_mw = 100.0
inertia_s = 4.0
droop_pu = 0.05
)";

class GridFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  std::string grid_refusal(const std::string& text) const {
    const std::string path = write("grid.toml", text);
    try {
      (void)load_grid(path);
    } catch (const ConfigurationError& error) {
      const std::string message = error.what();
      EXPECT_THAT(message, StartsWith(path + ":"));
      return message.substr(path.size() + 1);
    }
    return "";
  }

  const fs::path folder_ = fs::path(testing::TempDir()) /
                           (std::string("gsbench-grid-") +
                            testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(GridFile, IsNamedByItsFileAndHasTheDocumentedDefaults) {
  const grid::Grid grid = load_grid(write("small.toml", kGrid));
  EXPECT_EQ(grid.name, "small");
  EXPECT_EQ(grid.title, "Small");
  EXPECT_EQ(grid.source, "Here");
  EXPECT_EQ(grid.gain_km, 0.95);
  EXPECT_EQ(grid.reheat_fraction, 0.3);
  EXPECT_EQ(grid.reheat_s, 8.0);
  EXPECT_EQ(grid.condition_row_hz, 0.05);
  EXPECT_TRUE(grid.blocks.empty());
  EXPECT_FALSE(grid.reference.threshold_mw);
  EXPECT_EQ(grid.sha256, "3849cd1463c76ffd2dfb8cfc66602c500229c7e7f67a7e5e2a254e7019773b05")
      << "of its text";
}

TEST_F(GridFile, IsFoundBesideTheProfile) {
  write("small.toml", kGrid);
  const std::string path = write("case.toml", replaced(kMinimal, "ieee24", "small.toml"));
  EXPECT_EQ(load_profile(path).grid.title, "Small");
}

TEST_F(GridFile, RefusesWithItsOwnPathAndPlace) {
  EXPECT_EQ(grid_refusal(replaced(kGrid, "inertia_s = 4.0", "inertia_s = \"4 s\"")),
            "12:13: inertia_s is the text \"4 s\"; it must be a plain number, in the unit that its "
            "name says");
  EXPECT_EQ(grid_refusal(replaced(kGrid, "title = \"Small\"", "")),
            "1:1: a grid file lacks \"title\": a text in quotes");
  EXPECT_EQ(grid_refusal(replaced(kGrid, "[system]", "[grid]")),
            "3:2: unknown key \"grid\" in a grid file; its keys are: title, source, system, plant, "
            "block, reference");
  EXPECT_EQ(grid_refusal(replaced(kGrid, "rating_mw = 100.0", "rating_mw = -100.0")),
            "11:13: rating_mw is -100; it must be at least 1e-06 and at most 10000000");
}

TEST_F(GridFile, RefusedInsideAProfileNamesTheGridsFile) {
  const std::string grid =
      write("bad.toml", replaced(kGrid, "damping_pu = 1.0", "damping_pu = -1"));
  const std::string path = write("case.toml", replaced(kMinimal, "ieee24", "bad.toml"));
  try {
    (void)load_profile(path);
    FAIL() << "a negative damping was taken";
  } catch (const ConfigurationError& error) {
    EXPECT_THAT(error.what(), StartsWith(grid + ":8:14: "));
  }
}

TEST(GridName, UnknownIsRefusedWithASuggestion) {
  try {
    (void)load_grid("ieee42");
    FAIL() << "an unknown grid was taken";
  } catch (const ConfigurationError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no grid \"ieee42\"; did you mean \"ieee24\"?"));
  }
}

TEST(ShippedGrid, GivesThePapersThreshold) {
  const grid::Grid grid = load_grid("ieee24");
  // Calibrated value 351.92 MW, printed 351.90 MW (Xiang et al., §6.1).
  EXPECT_NEAR(control_centre::threshold_mw(grid::SfrModel(grid), grid.threshold_hz), 351.92, 0.1);
}

}  // namespace
}  // namespace gsbench::profile::test
