// Numbers as people read them, the terminal's table, thinning, and files written whole or not at
// all.
#include "format.hpp"
#include "plot_data.hpp"
#include "sample_run.hpp"
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
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Figure, HasSignificantDigitsWithoutTrailingZeros) {
  EXPECT_EQ(figure(351.92), "351.92");
  EXPECT_EQ(figure(112.0), "112");
  EXPECT_EQ(figure(-1011.9204), "-1011.9");
  EXPECT_EQ(figure(1234567.0), "1234567");
  EXPECT_EQ(figure(0.0), "0");
  EXPECT_EQ(figure(-0.0), "0");
  EXPECT_EQ(figure(3e-12), "3e-12");
  EXPECT_EQ(figure(kNan), "–");
  EXPECT_EQ(figure(std::numeric_limits<double>::infinity()), "∞");
}

TEST(Figure, HasTheDecimalsItsUncertaintyDeserves) {
  EXPECT_EQ(figure_within(112.0, 0.125), "112.00");
  EXPECT_EQ(figure_within(112.3456, 3.0), "112.3");
  EXPECT_EQ(figure_within(112.3456, 42.0), "112");
  EXPECT_EQ(figure_within(-0.001, 0.125), "0.00");
  EXPECT_EQ(figure_within(112.3456, 0.0), "112.35");
  EXPECT_EQ(figure_within(kNan, 0.1), "–");
}

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

TEST(Limits, SayWhatWasAsked) {
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

TEST(Terminal, AlignsOneRowAnOutletWithin120Columns) {
  const auto all = lines(terminal(sample::loss_500mw()));
  ASSERT_EQ(all.size(), 11U);  // the run, the heading, eight outlets, the verdict
  const auto column = [](const std::string& line, const char* word) {
    return columns_of(line.substr(0, line.rfind(word)));
  };
  for (std::size_t i = 2; i < 10; ++i) {
    EXPECT_EQ(column(all[i], "PASS"), column(all[1], "verdict"));
    EXPECT_LE(columns_of(all[i]), 120U);
  }
  EXPECT_EQ(all[10], "PASS: All 76 judged measurements on 8 outlets are within limits.");
}

TEST(Terminal, ColoursOnlyWhenAsked) {
  EXPECT_THAT(terminal(sample::loss_500mw(1)), Not(HasSubstr("\x1b")));
  EXPECT_THAT(coloured_terminal(sample::loss_500mw(1)), HasSubstr("\x1b[1;32mPASS\x1b[0m"));
}

TEST(Terminal, LetsNoTextOfTheRecordSteerTheTerminal) {
  RunRecord run = sample::loss_500mw(1);
  run.outlets[0].id = run.profile = run.profile_title = "x\x1b[2J\ny";
  run.verdict_reason = "z\x1b]0;title\x07";
  run.verdict = Verdict::kError;
  const std::string text = terminal(run);
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, Not(HasSubstr("\x07")));
  EXPECT_EQ(lines(text).size(), 4U);
}

TEST(Terminal, ListsWhatDidNotPassUpToTen) {
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

TEST(Terminal, MarksAnEstimateThatTheOutletFlaggedAsUnreliable) {
  RunRecord run = sample::loss_500mw(2);
  const auto doubts = [&] {
    const std::string text = terminal(run);
    return std::count(text.begin(), text.end(), '?');
  };
  run.outlets[0].marks.push_back({0, "decision.trust", 1.0, "trusted"});
  EXPECT_EQ(doubts(), 0);
  run.outlets[1].marks.push_back({0, "decision.trust", 0.0, "not settled"});
  EXPECT_EQ(doubts(), 3) << "ΔP, its error, and what the mark means";
  EXPECT_THAT(lines(terminal(run))[3], HasSubstr(" MW ?"));
}

TEST(Terminal, SaysWhatWasPlayedInPlaceOfTheProfile) {
  RunRecord run = sample::loss_500mw(1);
  run.recording = {"grid.csv", "cd34", "t", "f", "", 0.0, true};
  EXPECT_THAT(
      lines(terminal(run)),
      Contains(StartsWith("The recording grid.csv (columns t, f; SHA-256 cd34) was played")));
}

TEST(Terminal, ShowsTheMeasurementsTheRunHas) {
  RunRecord run = sample::steady(1, 1.0);
  record::MeasurementResult error;
  error.name = "tracker.error.rms";
  error.value = 3.1;
  error.unit = "mHz";
  run.outlets[0].measurements = {error};
  EXPECT_THAT(lines(terminal(run))[1], AllOf(HasSubstr("Error, rms"), Not(HasSubstr("ΔP"))));
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

TEST_F(Thinning, KeepsEveryEntryOfTheStretchesAskedFor) {
  const auto kept = thinned(tick_, frequency_, rocof_, {{128 * 500, 128 * 900}}, 4000);
  EXPECT_LE(kept.size(), 4000U);
  for (std::size_t index = 500; index <= 900; ++index) {
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), index)) << index;
  }
}

TEST_F(Thinning, CoversTheRestEvenWhenStretchesAskForEverything) {
  frequency_[99500] = 51.0;
  const auto kept = thinned(tick_, frequency_, rocof_, {{0, tick_.back()}}, 4000);
  EXPECT_LE(kept.size(), 4000U);
  EXPECT_THAT(kept, Contains(99500U));
}

std::string write_error(const std::string& path, const std::string& content) {
  return test::refusal_of<WriteError>([&] { write_file(path, content); });
}

TEST(WriteFile, WritesAndReplaces) {
  const test::TemporaryFolder folder;
  const std::string name = "r\xc3\xa9port.html";
  write_file(folder.file(name), std::string("a\0b", 3));
  EXPECT_EQ(folder.read(name), std::string("a\0b", 3));
  write_file(folder.file(name), "new");
  EXPECT_EQ(folder.read(name), "new");
}

TEST(WriteFile, NamesPathAndCause) {
  const test::TemporaryFolder folder;
  const std::string missing = folder.file("no/report.html");
  EXPECT_THAT(write_error(missing, "x"),
              AllOf(StartsWith(missing), HasSubstr("No such file or directory")));
  std::filesystem::create_directory(folder.file("taken"));
  EXPECT_THAT(write_error(folder.file("taken"), "x"), HasSubstr("directory"));
}

// Sizes below and above what any buffer holds: a disk may fill up at the first or at a later write.
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
