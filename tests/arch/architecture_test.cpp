// Checks the source tree against the rules. The Walk tests count the files that an addition touches
// (CONTRIBUTING.md), by the example of an existing addition.
#include "checks.hpp"

#include <set>
#include <sstream>

#include <gmock/gmock.h>

namespace gsbench::arch {
namespace {

using testing::ElementsAre;

class ArchitectureTest : public testing::Test {
 protected:
  const Tree tree_ = read_tree(GSBENCH_SOURCE_DIR);
};

testing::AssertionResult none(const Findings& findings) {
  std::ostringstream text;
  for (const Finding& finding : findings) {
    text << finding << '\n';
  }
  return findings.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << text.str();
}

TEST_F(ArchitectureTest, ReadsTheSourceTree) {
  EXPECT_EQ(tree_.count("tests/arch/architecture_test.cpp"), 1U);
  EXPECT_EQ(tree_.count("bench/grid/include/grid/grid.hpp"), 1U);
  EXPECT_EQ(tree_.count(".ci/packages.txt"), 1U);
}

TEST_F(ArchitectureTest, FoldersIncludeOnlyAllowedFolders) {
  EXPECT_TRUE(none(check_includes(tree_)));
}

TEST_F(ArchitectureTest, TargetsLinkOnlyAllowedTargets) {
  EXPECT_TRUE(none(check_links(tree_)));
}

TEST_F(ArchitectureTest, FoldersHaveNoCyclicIncludes) {
  EXPECT_TRUE(none(check_cycles(tree_)));
}

TEST_F(ArchitectureTest, FirmwareHasNoHeapAndNoExceptions) {
  EXPECT_TRUE(none(check_firmware_keywords(tree_)));
}

TEST_F(ArchitectureTest, FilesAreShortFinishedAndIndependentOfTheMachine) {
  EXPECT_TRUE(none(check_text(tree_)));
}

TEST_F(ArchitectureTest, EveryFolderIsInTheTableAndBuilt) {
  EXPECT_TRUE(none(check_layout(tree_)));
}

// C++ files outside of tests, profiles and `own_folder` that contain `text`.
std::set<std::string> files_that_name(const std::string& text,
                                      const std::string& own_folder = "-") {
  std::set<std::string> files;
  for (const auto& [path, content] : read_tree(GSBENCH_SOURCE_DIR)) {
    if (!starts_with(path, "tests/") && !starts_with(path, "profiles/") && is_cpp(path) &&
        !starts_with(path, own_folder) && content.find(text) != std::string::npos) {
      files.insert(path);
    }
  }
  return files;
}

TEST(Walk, SourceTouchesItsFolderAndItsStation) {
  EXPECT_THAT(files_that_name("simulated/bench.hpp", "drivers/simulated/"),
              ElementsAre("bench/station/simulated_station.cpp"));
}

TEST(Walk, MeasureTouchesTheCatalogueAndTheJudge) {
  EXPECT_THAT(files_that_name("\"relay.chatter\""),
              ElementsAre("bench/judge/relay_measures.cpp", "bench/measures/catalogue.cpp"));
}

TEST(Walk, ReportFormatTouchesItsFileAndTheTableOfFormats) {
  EXPECT_THAT(files_that_name("junit"), ElementsAre("reports/render/include/render/render.hpp",
                                                    "reports/render/junit_xml.cpp"));
}

TEST(Walk, SettingTouchesTheTableOfSettingsAndItsAlgorithm) {
  EXPECT_THAT(files_that_name("event_departure_hz"),
              ElementsAre("firmware/outlet/event_detector.cpp",
                          "firmware/outlet/include/outlet/event_detector.hpp",
                          "firmware/outlet/include/outlet/settings.hpp"));
}

TEST(Walk, BoardTouchesItsFolderAndTheTableOfBoards) {
  EXPECT_THAT(files_that_name("mps2_an386", "firmware/boards/mps2_an386/"),
              ElementsAre("firmware/boards/list/include/boards/boards.hpp"));
}

}  // namespace
}  // namespace gsbench::arch
