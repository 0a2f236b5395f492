// Values with their uncertainty, the terminal's table, thinning, and files that are written
// completely or not at all.
#include "format.hpp"
#include "sample_run.hpp"
#include "thinning.hpp"
#include <test_support/refusal.hpp>
#include <test_support/small_disk.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>

#include <render/file.hpp>
#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::RunRecord;
using record::Verdict;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ValueOf, NeverUnderstatesTheUncertainty) {
  record::MeasurementResult result;
  result.unit = "ms";
  result.value = 112.0;
  result.uncertainty = 0.125;
  EXPECT_EQ(value_of(result), "112.00 ± 0.13 ms");
  result.uncertainty = 0.05;
  EXPECT_EQ(value_of(result), "112.000 ± 0.050 ms");
  result.value = kNan;
  EXPECT_EQ(value_of(result), "–");
}

TEST(ValueOf, HasFourDigitsWithoutAnUncertainty) {
  record::MeasurementResult result;
  result.low = result.high = kNan;
  result.unit = "MW";
  result.value = 503.75024;
  EXPECT_EQ(value_of(result), "503.8 MW");
  result.value = 920.0;
  EXPECT_EQ(value_of(result), "920 MW");
}

TEST(ValueOf, IsNotRoundedOntoALimitThatItMisses) {
  record::MeasurementResult result;
  result.low = -4.0;
  result.high = 4.0;
  result.unit = "%";
  result.value = 4.0031;
  EXPECT_EQ(value_of(result), "4.003 %");
  result.value = 3.9991;
  EXPECT_EQ(value_of(result), "4.00 %");
}

TEST(Limits, AreShownWithTheirUnit) {
  record::MeasurementResult result;
  result.unit = "%";
  result.low = -4.0;
  result.high = 4.0;
  EXPECT_EQ(limits(result), "");  // not judged
  result.judged = true;
  EXPECT_EQ(limits(result), "-4 … 4 %");
  result.low = kNan;
  EXPECT_EQ(limits(result), "≤ 4 %");
  result.low = 1.0;
  result.high = kNan;
  EXPECT_EQ(limits(result), "≥ 1 %");
  result.high = 1.0;
  EXPECT_EQ(limits(result), "= 1 %");
  result.expected_text = "open";
  EXPECT_EQ(limits(result), "open");
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    all.push_back(line);
  }
  return all;
}

TEST(Terminal, HasAnAlignedRowPerOutlet) {
  const auto all = lines(terminal(sample::loss_500mw()));
  ASSERT_EQ(all.size(), 12U);  // the run, two lines of headings, eight outlets, the verdict
  const auto column = [](const std::string& line, const char* word) {
    return columns_of(line.substr(0, line.rfind(word)));
  };
  for (std::size_t i = 3; i < 11; ++i) {
    EXPECT_EQ(column(all[i], "PASS"), column(all[2], "verdict"));
  }
  EXPECT_EQ(all[11], "PASS: All 76 judged measurements on 8 outlets are within limits.");
}

TEST(Terminal, HasTheSameDecimalsDownAColumn) {
  RunRecord run = sample::loss_500mw(2);
  sample::measurement(run.outlets[0], "ekf.loss").value = 503.75;
  sample::measurement(run.outlets[1], "ekf.loss").value = 498.0;
  sample::measurement(run.outlets[0], "ekf.error").value = 0.75005;
  sample::measurement(run.outlets[1], "ekf.error").value = -0.016;
  const auto all = lines(terminal(run));
  EXPECT_THAT(all[2], AllOf(HasSubstr("  ΔP, MW  error, %  "), HasSubstr(" sensed, ms")));
  EXPECT_THAT(all[3], AllOf(HasSubstr(" 503.8 "), HasSubstr(" 0.75 "), HasSubstr(" 926.4 ")));
  EXPECT_THAT(all[4], AllOf(HasSubstr(" 498.0 "), HasSubstr(" -0.02 ")));
}

// The longest ids of simulated outlets have 64 letters, the longest verdict is INCONCLUSIVE.
TEST(Terminal, KeepsTheTableWithin100ColumnsWithFewerKeyFigures) {
  for (const std::size_t length : {10U, 32U, 64U}) {
    RunRecord run = sample::loss_500mw(2);
    run.outlets[0].id = std::string(length - 2, 'x') + "-1";
    run.outlets[0].verdict = Verdict::kInconclusive;
    for (const std::string& line : lines(terminal(run))) {
      EXPECT_LE(columns_of(line), kLineColumns) << line;
    }
    EXPECT_THAT(lines(terminal(run))[3], AllOf(HasSubstr("xx-1  "), HasSubstr(" 920.0 ")));
  }
}

TEST(Terminal, WrapsItsLinesForATerminalOnly) {
  RunRecord run = sample::loss_500mw(1);
  run.profile_title = "A title of many words " + std::string(90, 't');
  auto& delay = sample::measurement(run.outlets[0], "event.delay");
  delay.verdict = Verdict::kFail;
  delay.reason = std::string(60, 'x') + " and " + std::string(60, 'y');
  run.outlets[0].fault = std::string(60, 'u') + " and " + std::string(60, 'v');
  for (const std::string& line : lines(coloured_terminal(run))) {
    const std::size_t escapes = line.find('\x1b') == std::string::npos ? 0 : 11;
    EXPECT_LE(columns_of(line), kLineColumns + escapes) << line;
  }
  EXPECT_THAT(lines(terminal(run)), Contains(AllOf(StartsWith("FAIL stays-1 event.delay: "),
                                                   HasSubstr("and " + std::string(60, 'y')))));
}

TEST(Terminal, ColoursOnlyWhenAsked) {
  EXPECT_THAT(terminal(sample::loss_500mw(1)), Not(HasSubstr("\x1b")));
  EXPECT_THAT(coloured_terminal(sample::loss_500mw(1)), HasSubstr("\x1b[1;32mPASS\x1b[0m"));
}

TEST(Terminal, PassesNoControlCharactersOfTheRecord) {
  RunRecord run = sample::loss_500mw(1);
  run.outlets[0].id = run.profile = run.profile_title = "x\x1b[2J\ny";
  run.verdict_reason = "z\x1b]0;title\x07";
  run.verdict = Verdict::kError;
  const std::string text = terminal(run);
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, Not(HasSubstr("\x07")));
  EXPECT_EQ(lines(text).size(), 5U);
}

TEST(Terminal, ListsUpToTenMeasurementsThatDidNotPass) {
  RunRecord run = sample::loss_500mw(4);
  for (auto& outlet : run.outlets) {
    outlet.verdict = Verdict::kFail;
    for (auto& result : outlet.measurements) {
      if (result.judged) {
        result.verdict = Verdict::kFail;
      }
    }
  }
  run.verdict = Verdict::kFail;
  const auto all = lines(terminal(run));
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
                          [](const auto& line) { return line.rfind("FAIL sheds-1 ", 0) == 0; }),
            10);
  EXPECT_THAT(all, Contains("… and 28 more"));
  EXPECT_EQ(all.back(), "FAIL: 38 of 38 judged measurements on 4 outlets did not pass.");
}

TEST(Terminal, SaysThatTheOnlyJudgedMeasurementPassed) {
  RunRecord run = sample::loss_500mw(1);
  auto& results = run.outlets[0].measurements;
  results.erase(std::remove_if(results.begin(), results.end(),
                               [](const auto& result) { return result.name != "event.delay"; }),
                results.end());
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(lines(terminal(run)).back(), "PASS: The only judged measurement is within limits.");
}

TEST(Terminal, MarksAnEstimateThatTheOutletFlaggedAsUnreliable) {
  RunRecord run = sample::loss_500mw(2);
  const auto doubts = [&] {
    const std::string text = terminal(run);
    return std::count(text.begin(), text.end(), '?');
  };
  run.outlets[0].reports.marks.push_back({0, "decision.trust", 1.0, "trusted"});
  EXPECT_EQ(doubts(), 0);
  run.outlets[1].reports.marks.push_back({0, "decision.trust", 0.0, "not settled"});
  EXPECT_EQ(doubts(), 3) << "ΔP, its error, and the note";
  EXPECT_THAT(lines(terminal(run))[4], ContainsRegex("[0-9] \\?"));
}

TEST(Terminal, NamesTheRecordingPlayedInPlaceOfTheProfile) {
  RunRecord run = sample::loss_500mw(1);
  run.recording = {"grid.csv", "cd34", "t", "f", "", 0.0, true};
  EXPECT_THAT(lines(terminal(run)),
              Contains(StartsWith("The recording grid.csv (time: column t, frequency: column f; "
                                  "SHA-256 cd34) was played")));
}

TEST(Terminal, ShowsTheMeasuresThatTheRunHas) {
  RunRecord run = sample::steady(1, 1.0);
  record::MeasurementResult error;
  error.name = "tracker.error.rms";
  error.value = 3.1;
  error.unit = "mHz";
  run.outlets[0].measurements = {error};
  const auto all = lines(terminal(run));
  EXPECT_THAT(all[1], HasSubstr("RMS"));
  EXPECT_THAT(all[2], AllOf(HasSubstr("error, mHz"), Not(HasSubstr("ΔP"))));
}

class Thinning : public ::testing::Test {
 protected:
  Thinning() {
    for (std::size_t i = 0; i < tick_.size(); ++i) {
      tick_[i] = 128 * static_cast<std::int64_t>(i);
    }
  }

  std::vector<std::int64_t> tick_ = std::vector<std::int64_t>(100000);
  std::vector<double> frequency_ = std::vector<double>(100000, 50.0);
  std::vector<double> rocof_ = std::vector<double>(100000);
};

TEST_F(Thinning, KeepsAllOfAShortSeries) {
  EXPECT_EQ(thinned({1, 2, 3}, {1, 1, 1}, {1, 1, 1}, {}, 20).size(), 3U);
}

TEST_F(Thinning, KeepsSpikesOfBothColumnsEndsAndGaps) {
  frequency_[12345] = 50.5;
  frequency_[54321] = 49.5;
  rocof_[777] = 3.0;
  rocof_[99000] = -3.0;
  frequency_[40000] = std::numeric_limits<double>::quiet_NaN();
  const auto kept = thinned(tick_, frequency_, rocof_, {}, 4000);
  EXPECT_LE(kept.size(), 4000U);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(std::adjacent_find(kept.begin(), kept.end()), kept.end());
  for (const std::size_t index : {0U, 12345U, 54321U, 777U, 99000U, 40000U, 99999U}) {
    EXPECT_THAT(kept, Contains(index));
  }
}

TEST_F(Thinning, KeepsAllEntriesOfTheGivenIntervals) {
  const auto kept = thinned(tick_, frequency_, rocof_, {{128 * 500, 128 * 900}}, 4000);
  EXPECT_LE(kept.size(), 4000U);
  for (std::size_t index = 500; index <= 900; ++index) {
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), index)) << index;
  }
}

TEST_F(Thinning, CoversTheWholeSeriesEvenIfOneIntervalSpansIt) {
  frequency_[99500] = 51.0;
  const auto kept = thinned(tick_, frequency_, rocof_, {{0, tick_.back()}}, 4000);
  EXPECT_LE(kept.size(), 4000U);
  EXPECT_THAT(kept, Contains(99500U));
}

std::string write_error(const std::string& path, const std::string& content) {
  return test::refusal_of<WriteError>([&] { write_file(path, content); });
}

TEST(WriteFile, CreatesOrReplacesTheFile) {
  const test::TemporaryFolder folder;
  const std::string name = "r\xc3\xa9port.html";
  write_file(folder.file(name), std::string("a\0b", 3));
  EXPECT_EQ(folder.read(name), std::string("a\0b", 3));
  write_file(folder.file(name), "new");
  EXPECT_EQ(folder.read(name), "new");
}

// Names are bytes: of another encoding, or as long as the file system permits.
TEST(WriteFile, TakesAnyNameThatTheFileSystemTakes) {
  constexpr std::size_t kLongest = 255;
  for (const std::string& name : {std::string("r\xefport"), std::string(kLongest, 'x')}) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "o\xefut");
    const std::string path = folder.file("o\xefut/" + name);
    write_file(path, "text");
    EXPECT_EQ(folder.read("o\xefut/" + name), "text");
    EXPECT_EQ(folder.entries().size(), 2U) << "a temporary file is left";
  }
}

TEST(WriteFile, KeepsThePermissionsAndTheLinkOfAFileThatItReplaces) {
  const test::TemporaryFolder folder;
  folder.write("there.html", "old");
  const auto permissions = std::filesystem::perms(0604);
  std::filesystem::permissions(folder.file("there.html"), permissions);
  std::filesystem::create_symlink("there.html", folder.file("link.html"));
  write_file(folder.file("link.html"), "new");
  EXPECT_EQ(folder.read("there.html"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.html")));
  EXPECT_EQ(std::filesystem::status(folder.file("there.html")).permissions(), permissions);
}

TEST(WriteFile, NamesPathAndCause) {
  const test::TemporaryFolder folder;
  const std::string missing = folder.file("no/report.html");
  EXPECT_THAT(write_error(missing, "x"),
              AllOf(StartsWith(missing), HasSubstr("No such file or directory")));
  std::filesystem::create_directory(folder.file("taken"));
  EXPECT_THAT(write_error(folder.file("taken"), "x"), HasSubstr("directory"));
}

// Sizes below and above those of buffers: the disk is full at the first write or at a later one.
TEST(WriteFile, LeavesTheOldFileWhenTheDiskIsFull) {
  const test::TemporaryFolder folder;
  const test::SmallDisk disk(folder.path(), "size=64k");
  if (!disk.mounted()) {
    GTEST_SKIP() << "mounting a small tmpfs is not allowed here";
  }
  const std::string path = folder.file("report.html");
  write_file(path, "old");
  for (const std::size_t size : {61441U, 70000U, 1000000U}) {
    const std::string error = write_error(path, std::string(size, 'x'));
    EXPECT_THAT(error, AllOf(StartsWith(path), HasSubstr("No space left on device")));
    EXPECT_TRUE(folder.read("report.html") == "old") << size;
    EXPECT_EQ(folder.entries().size(), 1U) << "a temporary file is left";
  }
}

}  // namespace
}  // namespace gsbench::render
