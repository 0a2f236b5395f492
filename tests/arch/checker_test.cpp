// Tests of the checks: each rule is broken in a small artificial tree, and the finding must name
// the place. The nearest allowed case must not be reported.
#include "checks.hpp"

#include <utility>

#include <gmock/gmock.h>

namespace gsbench::arch {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MATCHER_P3(At, file, line, what, "") {
  return arg.file == file && arg.line == line && arg.broken_rule.find(what) != std::string::npos;
}

std::string include(const std::string& header) {
  return "#include <" + header + ">\n";
}

struct Case {
  std::string file;
  std::string text;
  int line;  // of the finding
  std::string message;
};

void expect_reported(const std::vector<Case>& cases) {
  for (const auto& [file, text, line, message] : cases) {
    EXPECT_THAT(check_includes({{file, text}}), ElementsAre(At(file, line, message))) << text;
  }
}

TEST(IncludeCheck, ReportsAnIncludeThatTheTableDoesNotAllow) {
  expect_reported(
      {{"bench/grid/a.cpp", "\n" + include("waveform/reference_signal.hpp"), 2, "may not include"},
       // Only the reverse direction is allowed.
       {"reports/record/a.hpp", include("render/render.hpp"), 1, "may not include"},
       {"bench/judge/a.cpp", include("record/store.hpp"), 1, "record/store.hpp"},
       {"bench/grid/a.hpp", include("drivers/result.hpp"), 1, "drivers/common"},
       {"firmware/outlet/a.cpp", "#include \"grid/sfr_model.hpp\"\n", 1, "bench/grid"}});
}

TEST(IncludeCheck, AcceptsAnIncludeThatTheTableAllows) {
  const Tree tree = {{"bench/waveform/a.cpp", include("grid/grid.hpp") + include("vector")},
                     {"bench/judge/a.cpp", include("record/run_record.hpp")},
                     {"drivers/link/a.hpp", include("drivers/result.hpp")},
                     {"firmware/boards/host/a.cpp", include("string") + include("termios.h")},
                     {"tests/a.cpp", include("sqlite3.h") + include("oracle/power_system.hpp")}};
  EXPECT_THAT(check_includes(tree), IsEmpty());
}

TEST(IncludeCheck, ReportsAQuotedIncludeThatLeavesItsFolder) {
  expect_reported(
      {{"bench/grid/a.cpp", "#include \"../waveform/private.hpp\"\n", 1, "must stay within"},
       {"bench/grid/a.cpp", "#include \"/usr/include/zlib.h\"\n", 1, "absolute"}});
}

TEST(IncludeCheck, FindsIncludesAfterSpacesDigitSeparatorsAndQuotedCharacters) {
  expect_reported({{"bench/grid/a.cpp", "  #  include <cli/main.hpp>\n", 1, "bench/cli"},
                   {"bench/grid/a.cpp",
                    "int n = 1'000; char c = '\"'; char d = '\\'';\n" + include("cli/main.hpp"), 2,
                    "bench/cli"}});
}

TEST(IncludeCheck, IgnoresAnIncludeInACommentOrARawString) {
  const Tree tree = {{"bench/grid/a.cpp", "// " + include("cli/main.hpp") + "/*\n" +
                                              include("cli/main.hpp") + "*/ auto s = R\"x(\n" +
                                              include("cli/main.hpp") + ")x\";\n"}};
  EXPECT_THAT(check_includes(tree), IsEmpty());
}

const std::pair<const char*, const char*> kMisplaced[] = {
    {"bench/waveform/a.cpp", "Eigen/Dense"},
    {"bench/grid/a.cpp", "unsupported/Eigen/MatrixFunctions"},
    {"reports/render/a.cpp", "sqlite3.h"},
    {"reports/render/a.cpp", "zlib.h"},
    {"bench/grid/a.cpp", "toml++/toml.h"},
    {"bench/station/a.cpp", "CLI/CLI.hpp"},
    {"bench/waveform/a.cpp", "Random123/philox.h"},
    {"reports/record/a.cpp", "kainjow/mustache.hpp"},
    {"bench/station/a.cpp", "nlohmann/json.hpp"},
    {"firmware/wire/a.cpp", "fmt/format.h"},
    {"drivers/simulated/a.cpp", "QFile"},
    {"firmware/app/a.cpp", "QByteArray"},
    {"bench/station/a.cpp", "libserialport.h"},
    {"drivers/simulated/a.cpp", "MQTTAsync.h"},
    {"bench/waveform/a.cpp", "alsa/asoundlib.h"},
    {"bench/grid/a.cpp", "gtest/gtest.h"},
    {"drivers/models/a.cpp", "benchmark/benchmark.h"},
    {"firmware/outlet/a.cpp", "unistd.h"},
    {"bench/grid/a.cpp", "boost/optional.hpp"},
    {"bench/grid/a.cpp", "math.h"}};

TEST(IncludeCheck, ReportsEachLibraryInAFolderWhereItIsNotAllowed) {
  for (const auto& [file, header] : kMisplaced) {
    expect_reported({{file, include(header), 1, header}});
  }
}

TEST(IncludeCheck, ReportsHostedHeadersInFirmwareOnly) {
  for (const char* header : {"cmath", "vector", "string", "memory", "new", "iostream", "chrono",
                             "stdexcept", "functional", "thread"}) {
    expect_reported({{"firmware/outlet/a.hpp", include(header), 1, "not for firmware"},
                     {"firmware/boards/stm32f405/a.cpp", include(header), 1, "not for firmware"}});
    EXPECT_THAT(check_includes({{"bench/grid/a.hpp", include(header)}}), IsEmpty());
  }
}

TEST(CycleCheck, ReportsDriversThatIncludeEachOther) {
  const Tree tree = {{"drivers/link/a.hpp", include("source/a.hpp")},
                     {"drivers/source/a.hpp", "\n" + include("link/a.hpp")}};
  EXPECT_THAT(check_cycles(tree), ElementsAre(At("drivers/source/a.hpp", 2,
                                                 "drivers/link, drivers/source, drivers/link")));
}

TEST(CycleCheck, ReportsACycleOfThreeFoldersReachedFromOutside) {
  const Tree tree = {{"bench/capture/a.hpp", include("link/a.hpp")},
                     {"drivers/link/a.hpp", include("source/a.hpp")},
                     {"drivers/relay/a.hpp", include("link/a.hpp")},
                     {"drivers/source/a.hpp", include("relay/a.hpp")}};
  EXPECT_THAT(check_cycles(tree),
              ElementsAre(At("drivers/relay/a.hpp", 1, "drivers/link, drivers/source")));
}

TEST(CycleCheck, AcceptsTwoPathsToTheSameFolder) {
  const Tree tree = {{"bench/waveform/a.hpp", include("grid/a.hpp")},
                     {"bench/profile/a.hpp", include("grid/a.hpp") + include("waveform/a.hpp")}};
  EXPECT_THAT(check_cycles(tree), IsEmpty());
}

TEST(LinkCheck, ReportsATargetThatTheTableDoesNotAllow) {
  const Tree tree = {
      {"bench/judge/CMakeLists.txt",
       "gs_library(bench_judge\n  DEPENDS bench_grid reports_record reports_render)"}};
  EXPECT_THAT(check_links(tree),
              ElementsAre(At("bench/judge/CMakeLists.txt", 2, "may not link reports_render")));
}

TEST(LinkCheck, AcceptsOwnAndAllowedTargetsAndComments) {
  const Tree tree = {{"bench/waveform/CMakeLists.txt",
                      "# not reports_render\ngs_library(bench_waveform DEPENDS bench_grid)"},
                     {"tests/oracle/CMakeLists.txt", "gs_test(t DEPENDS bench_grid gsbench)"}};
  EXPECT_THAT(check_links(tree), IsEmpty());
}

TEST(FirmwareKeywordCheck, ReportsEachKeywordInFirmwareOnly) {
  for (const std::string code :
       {"auto p = new int;", "delete p;", "malloc(4);", "std::free(p);", "throw 1;", "try {",
        "} catch (...) {", "dynamic_cast<A*>(b);", "typeid(a);"}) {
    const std::string line = "\n  " + code + "\n";
    const Tree tree = {{"firmware/app/a.cpp", line}, {"bench/grid/a.cpp", line}};
    EXPECT_THAT(check_firmware_keywords(tree), ElementsAre(At("firmware/app/a.cpp", 2, "no `")));
  }
}

TEST(FirmwareKeywordCheck, AcceptsKeywordsInCommentsNamesAndDeletedFunctions) {
  const Tree tree = {{"firmware/app/a.hpp",
                      "// a new try\nA(const A&) =  delete;\nint new_value;\nf(\"throw\");\n"}};
  EXPECT_THAT(check_firmware_keywords(tree), IsEmpty());
}

TEST(TextCheck, ReportsAFileThatIsOneLineTooLong) {
  const std::string longest(kLongestFile, '\n');
  const Tree tree = {{"bench/grid/fits.cpp", longest}, {"bench/grid/long.cpp", longest + "\n"}};
  EXPECT_THAT(check_text(tree), ElementsAre(At("bench/grid/long.cpp", 0, "501 lines")));
}

TEST(TextCheck, ReportsNotesOfUnfinishedWork) {
  const std::string note =
      "TO"
      "DO";
  const Tree tree = {{"README.md", "one\n" + note + ": more\n"},
                     {"bench/grid/a.cpp", "int " + note +
                                              "S;  // FIX"
                                              "ME\n"}};
  EXPECT_THAT(check_text(tree),
              ElementsAre(At("README.md", 2, note), At("bench/grid/a.cpp", 1, "")));
}

TEST(TextCheck, ReportsAbsolutePathsOfAMachine) {
  const Tree tree = {{"dev",
                      "cd \"/"
                      "home/me/gsbench\"\n"},
                     {"tests/a.cpp",
                      "\nopen(\"/"
                      "tmp/x\");\n"}};
  EXPECT_THAT(check_text(tree),
              ElementsAre(At("dev", 1, "absolute path"), At("tests/a.cpp", 2, "absolute path")));
}

TEST(TextCheck, AcceptsRelativePathsAndUrls) {
  const Tree tree = {{"README.md",
                      "https://example.org/home/x ./tmp/x ${root}/"
                      "work/x frame/"
                      "work/\n"}};
  EXPECT_THAT(check_text(tree), IsEmpty());
}

// A tree that satisfies check_layout.
Tree valid_tree() {
  return {{"CMakeLists.txt", ""},
          {"bench/grid/CMakeLists.txt", "gs_library(\n  bench_grid\n  SOURCES src/grid.cpp)"},
          {"bench/grid/include/grid/grid.hpp", ""},
          {"bench/grid/src/grid.cpp", ""},
          {"bench/cli/CMakeLists.txt", "add_executable(gsbench main.cpp)"},
          {"bench/cli/main.cpp", ""},
          {"tests/bench/grid/CMakeLists.txt", "gs_test(test_bench_grid SOURCES grid_test.cpp)"},
          {"tests/bench/grid/grid_test.cpp", ""}};
}

Findings check_layout_with(const std::string& path, const std::string& text) {
  Tree tree = valid_tree();
  tree[path] = text;
  return check_layout(tree);
}

TEST(LayoutCheck, AcceptsAValidTree) {
  EXPECT_THAT(check_layout(valid_tree()), IsEmpty());
}

TEST(LayoutCheck, ReportsUnknownFoldersAndFoldersWithoutTheirTarget) {
  EXPECT_THAT(check_layout_with("misc/notes.md", ""), ElementsAre(At("misc", 0, "top level")));
  EXPECT_THAT(check_layout_with("bench/helpers/a.cpp", ""),
              ElementsAre(At("bench/helpers/a.cpp", 0, "not in the table")));
  EXPECT_THAT(check_layout_with("bench/grid/CMakeLists.txt",
                                "gs_library(bench_grid2 SOURCES src/grid.cpp)"),
              ElementsAre(At("bench/grid", 0, "no target bench_grid")));
}

TEST(LayoutCheck, ReportsASourceInNoTarget) {
  Tree tree = valid_tree();
  tree["bench/grid/src/orphan.cpp"] = "";
  tree["tests/oracle/oracle_test.cpp"] = "";
  EXPECT_THAT(check_layout(tree),
              ElementsAre(At("bench/grid/src/orphan.cpp", 0, "is not named"),
                          At("tests/oracle/oracle_test.cpp", 0, "no CMakeLists.txt")));
}

TEST(Finding, PrintsAsFileLineAndRule) {
  EXPECT_EQ(testing::PrintToString(Finding{"a.cpp", 3, "broken"}), "a.cpp:3: broken");
  EXPECT_EQ(testing::PrintToString(Finding{"a.cpp", 0, "broken"}), "a.cpp: broken");
}

}  // namespace
}  // namespace gsbench::arch
