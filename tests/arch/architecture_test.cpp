// The tree as it is, held to the rules.
#include "checks.hpp"

#include <sstream>

#include <gtest/gtest.h>

namespace gsbench::arch {
namespace {

class ArchitectureTest : public testing::Test {
 protected:
  const Tree tree_ = read_tree(GSBENCH_SOURCE_DIR);
};

testing::AssertionResult none(const Findings& findings) {
  std::ostringstream text;
  for (const Finding& finding : findings) text << finding << '\n';
  return findings.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << text.str();
}

TEST_F(ArchitectureTest, SeesTheSourcesItIsToCheck) {
  EXPECT_EQ(tree_.count("tests/arch/architecture_test.cpp"), 1U);
  EXPECT_EQ(tree_.count("bench/grid/include/grid/grid.hpp"), 1U);
  EXPECT_EQ(tree_.count(".ci/packages.txt"), 1U);
}

TEST_F(ArchitectureTest, FoldersIncludeOnlyWhatTheyMay) {
  EXPECT_TRUE(none(check_includes(tree_)));
}

TEST_F(ArchitectureTest, TargetsLinkOnlyWhatTheirFoldersMayInclude) {
  EXPECT_TRUE(none(check_links(tree_)));
}

TEST_F(ArchitectureTest, FoldersIncludeEachOtherInNoCycle) {
  EXPECT_TRUE(none(check_cycles(tree_)));
}

TEST_F(ArchitectureTest, FirmwareHasNoHeapAndNoExceptions) {
  EXPECT_TRUE(none(check_firmware_words(tree_)));
}

TEST_F(ArchitectureTest, FilesAreShortFinishedAndTiedToNoMachine) {
  EXPECT_TRUE(none(check_text(tree_)));
}

TEST_F(ArchitectureTest, EveryFolderIsKnownAndBuilt) {
  EXPECT_TRUE(none(check_layout(tree_)));
}

}  // namespace
}  // namespace gsbench::arch
