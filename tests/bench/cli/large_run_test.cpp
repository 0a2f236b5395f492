// A run of many outlets: what it takes, and what it leaves.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string profile_of(int outlets, int duration_s) {
  return fmt::format(R"(title = "Many outlets"
source = "made for this test"
[grid]
system = "ieee24"
[[grid.loss]]
at_s = {}
power_mw = 500.0
[signal]
duration_s = {}
noise_pct = 1.0
[[outlet]]
id = "sheds"
count = {}
accumulated_mw = 100.0
[[outlet]]
id = "stays"
count = {}
accumulated_mw = 900.0
[[expect]]
measure = "relay.end"
equals = "open"
)",
                     duration_s / 2, duration_s, outlets / 2, outlets / 2);
}

struct Left {
  Outcome outcome;
  double page_mb = 0.0;
  std::ptrdiff_t lines = 0;
};

// Half of the outlets fail.
Left left_by(int outlets, int duration_s) {
  const TemporaryFolder folder;
  Left left;
  left.outcome = run_gsbench({"run", folder.write("many.toml", profile_of(outlets, duration_s)),
                              "--out", folder.file("runs")});
  EXPECT_EQ(left.outcome.exit_code, 1) << left.outcome.err << left.outcome.out;
  const fs::path run = only_run(folder.path() / "runs");
  left.page_mb = static_cast<double>(fs::file_size(run / "report.html")) / 1e6;
  left.lines = std::count(left.outcome.out.begin(), left.outcome.out.end(), '\n');
  std::printf("%d outlets for %d s: %.0f MB of memory, report of %.2f MB, %td lines\n", outlets,
              duration_s, left.outcome.peak_memory_mb, left.page_mb, left.lines);
  EXPECT_THAT(left.outcome.out,
              HasSubstr(fmt::format("FAIL: {} of {} outlets did not pass", outlets / 2, outlets)));
  return left;
}

// The lower bounds show that all of it was measured.
TEST(LargeRun, OfAThousandOutletsForAMinuteStaysSmall) {
  const Left left = left_by(1000, 60);
  EXPECT_LE(left.outcome.peak_memory_mb, 250.0);
  EXPECT_GE(left.outcome.peak_memory_mb, 50.0);
  EXPECT_LE(left.page_mb, 5.0);
  EXPECT_GE(left.page_mb, 1.0);
  EXPECT_LE(left.lines, 40);
  EXPECT_GE(left.lines, 10);
}

// The traces of one outlet take 13 MB in two hours. They are judged and drawn piece by piece.
TEST(LargeRun, TakesNoMoreMemoryIfItIsLonger) {
  constexpr double kMore_mb = 6.0;
  const Left minute = left_by(4, 60);
  const Left longer = left_by(4, 7200);
  EXPECT_LE(longer.outcome.peak_memory_mb, minute.outcome.peak_memory_mb + kMore_mb);
  EXPECT_LE(longer.page_mb, 5.0);
}

}  // namespace
}  // namespace gsbench::test
