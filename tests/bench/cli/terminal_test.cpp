// Output on a terminal: no line is longer than 100 columns.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <sstream>

#include <gmock/gmock.h>

#include <render/layout.hpp>

namespace gsbench::test {
namespace {

using render::columns_of;
using render::kLineColumns;

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

// A line with one word only may be longer: a path, a digest.
bool is_one_word(const std::string& line) {
  const std::size_t start = line.find_first_not_of(' ');
  return start == std::string::npos || line.find(' ', start) == std::string::npos;
}

void expect_narrow(const Words& arguments) {
  const std::string text = run_on_terminal(arguments);
  EXPECT_NE(text, "") << testing::PrintToString(arguments);
  for (const std::string& line : lines_of(text)) {
    EXPECT_TRUE(columns_of(line) <= kLineColumns || is_one_word(line))
        << testing::PrintToString(arguments) << ", " << columns_of(line) << " columns:\n"
        << line;
  }
}

// With an id of the maximum length, missed limits and a long title.
constexpr const char* kLongTexts =
    R"(title = "A title that goes on and on, so that it fills more than a line of a terminal, which is 100 columns"
source = "made for this test"
[grid]
system = "ieee24"
[[grid.loss]]
at_s = 1.0
power_mw = 500.0
[signal]
duration_s = 3.0
noise_pct = 1.0
[[outlet]]
id = "an-outlet-with-the-longest-id-that-a-profile-may-give-it-2345678"
accumulated_mw = 100.0
[[expect]]
measure = "event.delay"
unit = "ms"
max = 1.0
[[expect]]
measure = "tracker.error.max"
unit = "mHz"
min = 1000.0
max = 2000.0
[[expect]]
measure = "relay.end"
equals = "closed"
)";

TEST(Terminal, ShowsNoLineOver100ColumnsForListsAndTables) {
  for (const Words& arguments :
       std::vector<Words>{{"list"},
                          {"measures"},
                          {"params", "ieee24"},
                          {"params", "ieee24-by-unit"},
                          {"params", "island-60hz"},
                          {"check", "paper/loss-500mw"},
                          {"study", "paper/loss-500mw", "--seeds", "2"},
                          {"study", "regression/command", "--seeds", "2"}}) {
    expect_narrow(arguments);
  }
}

TEST(Terminal, ShowsNoLineOver100ColumnsForRunsAndTheirReports) {
  const TemporaryFolder folder;
  const std::string runs = folder.file("runs");
  const std::string profile = folder.write("long.toml", kLongTexts);
  const std::string recording = folder.write("grid.csv", "t,f\n0,50\n3,49.9\n");
  expect_narrow({"run", profile, "--out", runs});
  const std::string kept = only_run(runs).string();
  expect_narrow({"report", kept});
  expect_narrow({"run", profile, "--out", runs, "--trace", recording, "--trace-time", "t",
                 "--trace-frequency", "f"});
  for (const char* name : {"paper/loss-500mw", "regression/command", "disturbances/dips"}) {
    expect_narrow({"run", name, "--out", runs});
  }
  expect_narrow({"runs", "--out", runs});
  expect_narrow({"check", profile});
  expect_narrow({"study", profile, "--seeds", "2", "--within", "ekf.error=4"});
}

TEST(Terminal, ShowsNoLineOver100ColumnsInAnyHelp) {
  const std::string help = run_on_terminal({"--help"});
  EXPECT_THAT(help, testing::HasSubstr("Exit codes"));
  expect_narrow({"--help"});
  const Words lines = lines_of(help.substr(help.find("\nCommands:\n")));
  std::size_t commands = 0;
  for (const std::string& line : lines) {
    if (line.rfind("  ", 0) == 0 && line[2] != ' ') {
      expect_narrow({line.substr(2, line.find(' ', 2) - 2), "--help"});
      ++commands;
    }
  }
  EXPECT_GT(commands, 10U);
}

TEST(Terminal, WrapsErrorsThatScriptsReadOnOneLine) {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("bad.toml", "title = \"t\"\n[signal]\nsample_rate_hz = 8001\n");
  const Words bad = {"check", path};
  expect_narrow(bad);
  expect_narrow({"frobnicate"});
  expect_narrow({"reproduce", "--only", "table9"});
  expect_narrow({"study", "paper/loss-500mw", "--within", "nonsense"});
  expect_narrow({"runs", "--out", folder.file("none")});
  EXPECT_GT(lines_of(run_on_terminal({"frobnicate"})).size(), 1U);
  EXPECT_EQ(lines_of(run_gsbench({"frobnicate"}).err).size(), 1U);
  EXPECT_THAT(run_gsbench(bad).err, testing::StartsWith("gsbench: " + path + ":"));
}

TEST(Terminal, WrapsShortfallsThatScriptsReadOnOneLine) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_gsbench({"run", folder.write("long.toml", kLongTexts), "--out", folder.file("runs")});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_THAT(lines_of(outcome.out), testing::Contains(testing::ContainsRegex(
                                         "^FAIL an-outlet.*2345678 event.delay: .* limit ≤ 1 ms")));
  const Words lines = lines_of(outcome.out);
  ASSERT_GT(lines.size(), 3U);
  EXPECT_LE(columns_of(lines[3]), kLineColumns) << "tables are the same on a pipe";
}

}  // namespace
}  // namespace gsbench::test
