// A disk that fills while a run is written: told by name, and nothing half written stays.
#include "gsbench_process.hpp"
#include <test_support/small_disk.hpp>
#include <test_support/temporary_folder.hpp>

#include <cstring>

#include <gtest/gtest.h>

namespace {

using gsbench::test::Outcome;
using gsbench::test::run_gsbench;
using gsbench::test::SmallDisk;
using gsbench::test::TemporaryFolder;

// The sizes end the writing early in the record, and late in it.
class FullDisk : public testing::TestWithParam<const char*> {};

TEST_P(FullDisk, EndsWithTwoAndLeavesNothing) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder.path(), GetParam());
  if (!disk.mounted()) {
    GTEST_SKIP() << "no small disk can be mounted here: " << std::strerror(errno);
  }
  const Outcome outcome =
      run_gsbench({"run", "paper/loss-500mw", "--out", (folder.path() / "runs").string()});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_NE(outcome.err.find(folder.path().string()), std::string::npos) << outcome.err;
  // The database says it in its own words, a folder or a report in the system's.
  EXPECT_TRUE(outcome.err.find("o space left on") != std::string::npos) << outcome.err;
  EXPECT_TRUE(folder.entries().empty());
}

INSTANTIATE_TEST_SUITE_P(Sizes, FullDisk, testing::Values("size=32k", "size=300k"));

TEST(FullDisk, AmongTheReportsKeepsTheFinishedRecord) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder.path(), "size=800k");
  if (!disk.mounted()) {
    GTEST_SKIP() << "no small disk can be mounted here: " << std::strerror(errno);
  }
  const std::filesystem::path runs = folder.path() / "runs";
  const Outcome outcome = run_gsbench({"run", "paper/loss-500mw", "--out", runs.string()});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_NE(outcome.err.find("o space left on"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("the run is kept"), std::string::npos) << outcome.err;
  const std::filesystem::path run = gsbench::test::only_run(runs);
  // Each report is whole or not there, and the last cannot be.
  const std::string html = gsbench::test::text_of(run / "report.html");
  EXPECT_TRUE(html.empty() || html.find("</html>") != std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(run / "traces.csv"));
  const Outcome report = run_gsbench({"report", run.string()});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_NE(report.out.find("PASS: "), std::string::npos) << report.out;
}

}  // namespace
