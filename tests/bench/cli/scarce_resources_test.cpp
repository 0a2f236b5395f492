// Too little memory, too few threads, a full disk during a run: the error names the cause, the
// program never aborts, and no incomplete files remain.
#include "gsbench_process.hpp"
#include <sys/resource.h>
#include <test_support/small_disk.hpp>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <cstring>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::HasSubstr;

// Each thread needs 8 MB of stack: 256 threads are too many for all of these sizes.
TEST(LittleMemory, EndsWithAResultOrAnOutOfMemoryError) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer takes terabytes of address space";
#endif
  const TemporaryFolder folder;
  for (const rlim_t megabytes : {150U, 400U, 1000U}) {
    for (const Words& arguments : std::vector<Words>{
             {"study", "paper/loss-500mw", "--seeds", "2", "--threads", "256"},
             {"run", "paper/loss-500mw", "--threads", "256", "--out", folder.file("runs")}}) {
      const Outcome outcome = run_gsbench(arguments, [&] {
        const rlimit limit{megabytes << 20U, megabytes << 20U};
        if (setrlimit(RLIMIT_AS, &limit) != 0) {
          _exit(127);
        }
      });
      if (outcome.exit_code != 0) {
        EXPECT_EQ(outcome.exit_code, 4) << megabytes << " MB: " << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("out of memory")) << megabytes << " MB";
      }
    }
  }
}

TEST(FullDisk, BeforeTheRunExitsWithTwoAndLeavesNoFiles) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder.path(), "size=32k");
  if (!disk.mounted()) {
    GTEST_SKIP() << "no small disk here: " << std::strerror(errno);
  }
  const Outcome outcome = run_gsbench({"run", "paper/loss-500mw", "--out", folder.file("runs")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr(folder.path().string()));
  // The message is that of the database or, for a folder or a report, that of the system.
  EXPECT_THAT(outcome.err, HasSubstr("o space left on"));
  EXPECT_TRUE(folder.entries().empty());
}

TEST(FullDisk, DuringTheRunEndsItWithErrorAndKeepsWhatWasStored) {
  const TemporaryFolder folder;
  const SmallDisk disk(folder.path(), "size=900k");
  if (!disk.mounted()) {
    GTEST_SKIP() << "no small disk here: " << std::strerror(errno);
  }
  // Half a second and more of the run is stored at a time.
  const Outcome outcome =
      run_gsbench({"run", "paper/loss-500mw", "--real-time", "--out", folder.file("runs")});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.out, HasSubstr("ERROR: "));
  EXPECT_THAT(outcome.out, HasSubstr("o space left on"));
  const Outcome report =
      run_gsbench({"report", only_run(folder.path() / "runs").string(), "--format", "csv"});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_THAT(report.out, HasSubstr("sheds-1,0.512,50,"));
  // The record has the reason, too.
  EXPECT_THAT(run_gsbench({"report", only_run(folder.path() / "runs").string()}).out,
              HasSubstr("o space left on"));
}

TEST(FileSizeLimit, IsAnErrorLikeAFullDisk) {
  const TemporaryFolder folder;
  const auto limited_to = [](rlim_t bytes) {
    return [bytes] {
      const rlimit limit{bytes, bytes};
      if (setrlimit(RLIMIT_FSIZE, &limit) != 0) {
        _exit(127);
      }
    };
  };
  constexpr rlim_t kRecord = 300'000;
  constexpr rlim_t kReport = 1'000;
  const Outcome outcome =
      run_gsbench({"run", "paper/loss-500mw", "--real-time", "--out", folder.file("runs")},
                  limited_to(kRecord));
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("File too large"));
  const std::string kept = only_run(folder.path() / "runs").string();
  const Outcome report = run_gsbench(
      {"report", kept, "--format", "html", "-o", folder.file("report.html")}, limited_to(kReport));
  EXPECT_EQ(report.exit_code, 2);
  EXPECT_THAT(report.err, HasSubstr("report.html: cannot be written: File too large"));
  EXPECT_EQ(folder.entries().front(), "runs") << "a part of a report is left";
  EXPECT_THAT(run_gsbench({"report", kept}).out, HasSubstr("File too large"));
}

TEST(FullDisk, DuringTheReportsKeepsTheFinishedRecord) {
  const TemporaryFolder profiles;
  profiles.write(
      "long.toml",
      "title = \"Long\"\nsource = \"none\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
      "duration_s = 60.0\n[[outlet]]\ncount = 4\n[[expect]]\nmeasure = \"event.count\"\nmax = 0\n");
  const TemporaryFolder folder;
  const SmallDisk disk(folder.path(), "size=1500k");
  if (!disk.mounted()) {
    GTEST_SKIP() << "no small disk here: " << std::strerror(errno);
  }
  const Outcome outcome =
      run_gsbench({"run", profiles.file("long.toml"), "--csv", "--out", folder.file("runs")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("o space left on"));
  EXPECT_THAT(outcome.err, HasSubstr("the run is kept"));
  const std::filesystem::path run = only_run(folder.path() / "runs");
  // Each report is complete or missing; the last one is missing.
  const std::string html = text_of(run / "report.html");
  EXPECT_TRUE(html.empty() || html.find("</html>") != std::string::npos);
  const Outcome report = run_gsbench({"report", run.string()});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_THAT(report.out, HasSubstr("PASS: "));
}

}  // namespace
}  // namespace gsbench::test
