// The checks can fail: each rule is broken in a small tree made up for it, and must be reported
// with the place, beside the nearest thing that is allowed.
#include "checks.hpp"

#include <ostream>

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

TEST(IncludeCheck, ReportsAFolderThatTheTableDoesNotGrant) {
  const Tree tree = {{"bench/grid/a.cpp", "\n" + include("waveform/truth.hpp")}};
  EXPECT_THAT(check_includes(tree), ElementsAre(At("bench/grid/a.cpp", 2, "may not include")));
}

TEST(IncludeCheck, AcceptsAFolderThatTheTableGrants) {
  const Tree tree = {{"bench/waveform/a.cpp", include("grid/grid.hpp") + include("vector")}};
  EXPECT_THAT(check_includes(tree), IsEmpty());
}

TEST(IncludeCheck, ReportsAGrantedFolderInReverse) {
  const Tree tree = {{"reports/record/a.hpp", include("render/render.hpp")}};
  EXPECT_THAT(check_includes(tree), ElementsAre(At("reports/record/a.hpp", 1, "may not include")));
}

TEST(IncludeCheck, GrantsTheJudgeTheRecordsDataButNotItsStore) {
  const Tree data = {{"bench/judge/a.cpp", include("record/run_record.hpp")}};
  const Tree store = {{"bench/judge/a.cpp", include("record/store.hpp")}};
  EXPECT_THAT(check_includes(data), IsEmpty());
  EXPECT_THAT(check_includes(store), ElementsAre(At("bench/judge/a.cpp", 1, "record/store.hpp")));
}

TEST(IncludeCheck, ReportsAFolderIncludedInQuotes) {
  const Tree tree = {{"firmware/outlet/a.cpp", "#include \"grid/sfr_model.hpp\"\n"}};
  EXPECT_THAT(check_includes(tree), ElementsAre(At("firmware/outlet/a.cpp", 1, "bench/grid")));
}

TEST(IncludeCheck, ReportsAQuotedIncludeThatLeavesItsFolder) {
  const Tree tree = {{"bench/grid/a.cpp", "#include \"../waveform/private.hpp\"\n"}};
  EXPECT_THAT(check_includes(tree), ElementsAre(At("bench/grid/a.cpp", 1, "stays within")));
}

TEST(IncludeCheck, ReportsAnAbsoluteInclude) {
  const Tree tree = {{"bench/grid/a.cpp", "#include \"/usr/include/zlib.h\"\n"}};
  EXPECT_THAT(check_includes(tree), ElementsAre(At("bench/grid/a.cpp", 1, "absolute")));
}

TEST(IncludeCheck, SeesAnIncludeWithSpacesInIt) {
  const Tree tree = {{"bench/grid/a.cpp", "  #  include <cli/main.hpp>\n"}};
  EXPECT_THAT(check_includes(tree), ElementsAre(At("bench/grid/a.cpp", 1, "bench/cli")));
}

TEST(IncludeCheck, IgnoresAnIncludeInACommentOrARawString) {
  const Tree tree = {{"bench/grid/a.cpp", "// " + include("cli/main.hpp") + "/*\n" +
                                              include("cli/main.hpp") + "*/ auto s = R\"x(\n" +
                                              include("cli/main.hpp") + ")x\";\n"}};
  EXPECT_THAT(check_includes(tree), IsEmpty());
}

TEST(IncludeCheck, SeesAnIncludeBehindADigitSeparatorAndAQuoteInACharacter) {
  const Tree tree = {{"bench/grid/a.cpp",
                      "int n = 1'000; char c = '\"'; char d = '\\'';\n" + include("cli/main.hpp")}};
  EXPECT_THAT(check_includes(tree), ElementsAre(At("bench/grid/a.cpp", 2, "bench/cli")));
}

struct Misplaced {
  std::string file;
  std::string header;
};
std::ostream& operator<<(std::ostream& out, const Misplaced& misplaced) {
  return out << misplaced.header << " in " << misplaced.file;
}

class MisplacedLibrary : public testing::TestWithParam<Misplaced> {};

TEST_P(MisplacedLibrary, IsReported) {
  const Tree tree = {{GetParam().file, include(GetParam().header)}};
  EXPECT_THAT(check_includes(tree), ElementsAre(At(GetParam().file, 1, GetParam().header)));
}

INSTANTIATE_TEST_SUITE_P(OfEachLibrary, MisplacedLibrary,
                         testing::Values(Misplaced{"bench/waveform/a.cpp", "Eigen/Dense"},
                                         Misplaced{"bench/grid/a.cpp",
                                                   "unsupported/Eigen/MatrixFunctions"},
                                         Misplaced{"reports/render/a.cpp", "sqlite3.h"},
                                         Misplaced{"reports/render/a.cpp", "zlib.h"},
                                         Misplaced{"bench/grid/a.cpp", "toml++/toml.h"},
                                         Misplaced{"bench/station/a.cpp", "CLI/CLI.hpp"},
                                         Misplaced{"bench/waveform/a.cpp", "Random123/philox.h"},
                                         Misplaced{"reports/record/a.cpp", "kainjow/mustache.hpp"},
                                         Misplaced{"bench/station/a.cpp", "nlohmann/json.hpp"},
                                         Misplaced{"firmware/wire/a.cpp", "fmt/format.h"},
                                         Misplaced{"drivers/simulated/a.cpp", "QFile"},
                                         Misplaced{"firmware/app/a.cpp", "QByteArray"},
                                         Misplaced{"bench/station/a.cpp", "libserialport.h"},
                                         Misplaced{"drivers/simulated/a.cpp", "MQTTAsync.h"},
                                         Misplaced{"bench/waveform/a.cpp", "alsa/asoundlib.h"},
                                         Misplaced{"bench/grid/a.cpp", "gtest/gtest.h"},
                                         Misplaced{"drivers/models/a.cpp", "benchmark/benchmark.h"},
                                         Misplaced{"firmware/outlet/a.cpp", "unistd.h"},
                                         Misplaced{"bench/grid/a.cpp", "boost/optional.hpp"},
                                         Misplaced{"bench/grid/a.cpp", "math.h"}));

TEST(IncludeCheck, OfTheBoardsOnlyTheHostsHasAnOperatingSystem) {
  const Tree host = {{"firmware/boards/host/a.cpp", include("string") + include("termios.h")}};
  const Tree metal = {{"firmware/boards/stm32f405/a.cpp", include("string")}};
  EXPECT_THAT(check_includes(host), IsEmpty());
  EXPECT_THAT(check_includes(metal),
              ElementsAre(At("firmware/boards/stm32f405/a.cpp", 1, "not for firmware")));
}

TEST(IncludeCheck, KnowsAFolderWhoseIncludeRootHasAnotherName) {
  const Tree granted = {{"drivers/link/a.hpp", include("drivers/result.hpp")}};
  const Tree not_granted = {{"bench/grid/a.hpp", include("drivers/result.hpp")}};
  EXPECT_THAT(check_includes(granted), IsEmpty());
  EXPECT_THAT(check_includes(not_granted),
              ElementsAre(At("bench/grid/a.hpp", 1, "drivers/common")));
}

TEST(IncludeCheck, GrantsTestsEveryLibraryAndTheirOwnHelpers) {
  const Tree tree = {{"tests/a.cpp", include("sqlite3.h") + include("oracle/power_system.hpp")}};
  EXPECT_THAT(check_includes(tree), IsEmpty());
}

class HostedHeader : public testing::TestWithParam<const char*> {};

TEST_P(HostedHeader, IsReportedInFirmwareAlone) {
  const Tree firmware = {{"firmware/outlet/a.hpp", include(GetParam())}};
  const Tree bench = {{"bench/grid/a.hpp", include(GetParam())}};
  EXPECT_THAT(check_includes(firmware),
              ElementsAre(At("firmware/outlet/a.hpp", 1, "not for firmware")));
  EXPECT_THAT(check_includes(bench), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(NamedInTheDesign, HostedHeader,
                         testing::Values("cmath", "vector", "string", "memory", "new", "iostream",
                                         "chrono", "stdexcept", "functional", "thread"));

TEST(CycleCheck, ReportsDriversThatIncludeEachOther) {
  const Tree tree = {{"drivers/link/a.hpp", include("source/a.hpp")},
                     {"drivers/source/a.hpp", "\n" + include("link/a.hpp")}};
  EXPECT_THAT(check_cycles(tree), ElementsAre(At("drivers/source/a.hpp", 2,
                                                 "drivers/link, drivers/source, drivers/link")));
}

TEST(CycleCheck, ReportsACycleOfThreeThatAPathFromOutsideLeadsTo) {
  const Tree tree = {{"bench/capture/a.hpp", include("link/a.hpp")},
                     {"drivers/link/a.hpp", include("source/a.hpp")},
                     {"drivers/relay/a.hpp", include("link/a.hpp")},
                     {"drivers/source/a.hpp", include("relay/a.hpp")}};
  EXPECT_THAT(check_cycles(tree),
              ElementsAre(At("drivers/relay/a.hpp", 1, "drivers/link, drivers/source")));
}

TEST(CycleCheck, AcceptsTwoWaysToTheSameFolder) {
  const Tree tree = {{"bench/waveform/a.hpp", include("grid/a.hpp")},
                     {"bench/profile/a.hpp", include("grid/a.hpp") + include("waveform/a.hpp")}};
  EXPECT_THAT(check_cycles(tree), IsEmpty());
}

TEST(LinkCheck, ReportsATargetThatTheTableDoesNotGrant) {
  const Tree tree = {
      {"bench/judge/CMakeLists.txt",
       "gs_library(bench_judge\n  DEPENDS bench_grid reports_record reports_render)"}};
  EXPECT_THAT(check_links(tree),
              ElementsAre(At("bench/judge/CMakeLists.txt", 2, "may not link reports_render")));
}

TEST(LinkCheck, AcceptsOwnAndGrantedTargetsAndComments) {
  const Tree tree = {{"bench/waveform/CMakeLists.txt",
                      "# not reports_render\ngs_library(bench_waveform DEPENDS bench_grid)"},
                     {"tests/oracle/CMakeLists.txt", "gs_test(t DEPENDS bench_grid gsbench)"}};
  EXPECT_THAT(check_links(tree), IsEmpty());
}

class ForbiddenInFirmware : public testing::TestWithParam<const char*> {};

TEST_P(ForbiddenInFirmware, IsReportedThereAlone) {
  const std::string line = std::string("\n  ") + GetParam() + "\n";
  const Tree tree = {{"firmware/app/a.cpp", line}, {"bench/grid/a.cpp", line}};
  EXPECT_THAT(check_firmware_words(tree), ElementsAre(At("firmware/app/a.cpp", 2, "no `")));
}

INSTANTIATE_TEST_SUITE_P(EachWord, ForbiddenInFirmware,
                         testing::Values("auto p = new int;", "delete p;", "malloc(4);",
                                         "std::free(p);", "throw 1;", "try {", "} catch (...) {",
                                         "dynamic_cast<A*>(b);", "typeid(a);"));

TEST(FirmwareWordCheck, AcceptsThemInCommentsNamesAndDeletedFunctions) {
  const Tree tree = {{"firmware/app/a.hpp",
                      "// a new try\nA(const A&) =  delete;\nint new_value;\nf(\"throw\");\n"}};
  EXPECT_THAT(check_firmware_words(tree), IsEmpty());
}

TEST(TextCheck, ReportsAFileALineTooLong) {
  const std::string longest(kLongestFile, '\n');
  const Tree tree = {{"bench/grid/fits.cpp", longest}, {"bench/grid/long.cpp", longest + "\n"}};
  EXPECT_THAT(check_text(tree), ElementsAre(At("bench/grid/long.cpp", 0, "501 lines")));
}

TEST(TextCheck, ReportsWhatIsLeftUndone) {
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

TEST(TextCheck, ReportsAPathOfOneMachine) {
  const Tree tree = {{"dev",
                      "cd \"/"
                      "home/me/gsbench\"\n"},
                     {"tests/a.cpp",
                      "\nopen(\"/"
                      "tmp/x\");\n"}};
  EXPECT_THAT(check_text(tree),
              ElementsAre(At("dev", 1, "path of one machine"), At("tests/a.cpp", 2, "machine")));
}

TEST(TextCheck, AcceptsRelativePathsAndUrls) {
  const Tree tree = {{"README.md",
                      "https://example.org/home/x ./tmp/x ${root}/"
                      "work/x frame/"
                      "work/\n"}};
  EXPECT_THAT(check_text(tree), IsEmpty());
}

// A tree that satisfies check_layout, to be broken.
Tree well_laid() {
  return {{"CMakeLists.txt", ""},
          {"bench/grid/CMakeLists.txt", "gs_library(\n  bench_grid\n  SOURCES src/grid.cpp)"},
          {"bench/grid/include/grid/grid.hpp", ""},
          {"bench/grid/src/grid.cpp", ""},
          {"bench/cli/CMakeLists.txt", "add_executable(gsbench main.cpp)"},
          {"bench/cli/main.cpp", ""},
          {"tests/bench/grid/CMakeLists.txt", "gs_test(test_bench_grid SOURCES grid_test.cpp)"},
          {"tests/bench/grid/grid_test.cpp", ""}};
}

TEST(LayoutCheck, AcceptsAWellLaidTree) {
  EXPECT_THAT(check_layout(well_laid()), IsEmpty());
}

TEST(LayoutCheck, ReportsAStrangerAtTheTopLevel) {
  Tree tree = well_laid();
  tree["misc/notes.md"] = "";
  EXPECT_THAT(check_layout(tree), ElementsAre(At("misc", 0, "top level")));
}

TEST(LayoutCheck, ReportsAFolderThatIsNotInTheTable) {
  Tree tree = well_laid();
  tree["bench/helpers/a.cpp"] = "";
  EXPECT_THAT(check_layout(tree), ElementsAre(At("bench/helpers/a.cpp", 0, "not in the table")));
}

TEST(LayoutCheck, ReportsAFolderWithoutItsTarget) {
  Tree tree = well_laid();
  tree["bench/grid/CMakeLists.txt"] = "gs_library(bench_grid2 SOURCES src/grid.cpp)";
  EXPECT_THAT(check_layout(tree), ElementsAre(At("bench/grid", 0, "no target bench_grid")));
}

TEST(LayoutCheck, ReportsASourceThatNoTargetNames) {
  Tree tree = well_laid();
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
