// Grids from grid files.
#include <profile_test/texts.hpp>
#include <test_support/temporary_folder.hpp>

#include <gmock/gmock.h>

namespace gsbench::profile::test {
namespace {

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

const std::string kProfileBesideIt = replaced(kMinimal, "ieee24", "small.toml");

TEST(GridFile, GivesItsNameAndTheDocumentedDefaults) {
  const gsbench::test::TemporaryFolder folder;
  const grid::Grid grid = load_grid(folder.write("small.toml", kGrid));
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

TEST(GridFile, IsFoundBesideTheProfile) {
  const gsbench::test::TemporaryFolder folder;
  folder.write("small.toml", kGrid);
  EXPECT_EQ(load_profile(folder.write("case.toml", kProfileBesideIt)).grid.title, "Small");
}

TEST(GridFile, IsNamedInTheRefusalOfAProfile) {
  const gsbench::test::TemporaryFolder folder;
  folder.write("small.toml", replaced(kGrid, "damping_pu = 1.0", "damping_pu = -1"));
  EXPECT_THAT(refusal(kProfileBesideIt, folder.file("case.toml")),
              StartsWith(folder.file("small.toml") + ":8:14: "));
}

TEST(GridName, IsRefusedWithASuggestionIfUnknown) {
  EXPECT_THAT(gsbench::test::refusal_of<ConfigurationError>([] { (void)load_grid("ieee42"); }),
              testing::HasSubstr("unknown grid \"ieee42\"; did you mean \"ieee24\"?"));
}

}  // namespace
}  // namespace gsbench::profile::test
