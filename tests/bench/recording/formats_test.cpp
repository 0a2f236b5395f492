// Recordings as recorders and spreadsheets write them, and files that are no recordings.
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include <recording/trace.hpp>

namespace gsbench::recording {
namespace {

using namespace std::string_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using testing::ThrowsMessage;

TraceFormat format_of(const std::string& time = "t", const std::string& frequency = "f") {
  return {time, frequency, "", {}};
}

std::vector<double> frequencies_hz(const std::string& text, const TraceFormat& format) {
  std::vector<double> all;
  for (const TracePoint& point : read_trace(text, "r.csv", format).points) {
    all.push_back(point.frequency_hz);
  }
  return all;
}

std::vector<double> times_s(const std::string& text, const TraceFormat& format) {
  std::vector<double> all;
  for (const TracePoint& point : read_trace(text, "r.csv", format).points) {
    all.push_back(point.t_s);
  }
  return all;
}

void expect_refused(const std::string& text, const TraceFormat& format, const std::string& start,
                    const std::string& what) {
  EXPECT_THAT([&] { (void)read_trace(text, "r.csv", format); },
              ThrowsMessage<std::runtime_error>(AllOf(StartsWith(start), HasSubstr(what))))
      << text;
}

TEST(RecordingGaps, AreEmptyCellsAndTheUsualWords) {
  const Trace trace = read_trace(
      "t,f\n0,50\n1,\n2,NaN\n3,na\n4,N/A\n5,NULL\n6,-nan\n7,\"\"\n8,49\n", "r.csv", format_of());
  EXPECT_EQ(trace.rows, 9U);
  EXPECT_EQ(trace.gaps, 7U);
  EXPECT_EQ(trace.points.size(), 2U);
}

TEST(RecordingGaps, AreAlsoGivenWordsAndNumbers) {
  TraceFormat format = format_of();
  expect_refused("t,f\n0,50\n1,bad\n2,49\n", format, "r.csv:3:3: ", "`bad` is not a finite number");
  expect_refused("t,f\n0,50\n1,-999.00\n2,49\n", format, "r.csv:3:3: ", "the frequency is -999 Hz");
  format.gaps = {"-999", " Bad "};
  EXPECT_THAT(frequencies_hz("t,f\n0,50\n1,bad\n2,-999.00\n3,49\n", format), ElementsAre(50, 49));
  format.decimal = ",";
  format.gaps = {"-999,0", "-1.5"};
  EXPECT_THAT(frequencies_hz("t;f\n0;50\n1;-999\n2;-1,50\n3;49\n", format), ElementsAre(50, 49));
}

TEST(RecordingColumns, AreNamesOrNumbers) {
  const std::string text = ",2,f\n0,50,51\n1,50,51\n";
  EXPECT_THAT(frequencies_hz(text, format_of("1", "2")), ElementsAre(50, 50)) << "the name 2";
  EXPECT_THAT(frequencies_hz(text, format_of("1", "3")), ElementsAre(51, 51));
  EXPECT_THAT(frequencies_hz("t,f,2\n0,50,51\n1,50,51\n", format_of("#1", "#2")),
              ElementsAre(50, 50));
  expect_refused(text, format_of("1", "4"),
                 "r.csv:1:1: ", "no column `4`; the columns are ``, `2`");
  expect_refused(text, format_of("0", "f"), "r.csv:1:1: ", "no column `0`");
  expect_refused("t;f\n0;50\n", format_of(), "r.csv:1:1: ", "is the delimiter `;`?");
  expect_refused("# by PMU\nt,f\n0,50\n", format_of(),
                 "r.csv:1:1: ", "skip_rows skips lines above the names");
}

TEST(RecordingHeader, MayBeMissingOrHaveMoreRows) {
  TraceFormat format = format_of("1", "2");
  expect_refused("0,50\n1,49\n2,49\n", format,
                 "r.csv:1:1: ", "for a file without them, header_rows must be 0");
  format.header_rows = 0;
  EXPECT_THAT(frequencies_hz("0,50\n1,49\n", format), ElementsAre(50, 49));
  expect_refused("0,50\n1\n", format, "r.csv:2:2: ", "the row has 1 cell; it must have at least 2");
  expect_refused(
      "0,50\n1,49\n",
      [] {
        TraceFormat named = format_of("t", "2");
        named.header_rows = 0;
        return named;
      }(),
      "time is `t`", "without a header it must be the number of a column");
  expect_refused("\n", format_of(), "r.csv:", "the file is empty");
  format.skip_rows = 3;
  format.header_rows = 1;
  expect_refused("0,50\n1,49\n", format,
                 "r.csv:", "no row follows the 3 lines that skip_rows skips");
  format.skip_rows = 0;
  format.header_rows = 3;
  expect_refused("t,f\n1,49\n", format, "r.csv:", "the file ends within the 3 rows above the data");
  format.header_rows = 0;
  expect_refused("\n", format, "r.csv:", "no data; at least two rows are needed");
  TraceFormat units = format_of();
  units.header_rows = 2;
  units.skip_rows = 2;
  EXPECT_THAT(frequencies_hz("\"made by\nx\nt,f\ns,Hz\n0,50\n1,49\n", units), ElementsAre(50, 49));
}

TEST(RecordingHeader, IsAdvisedToHaveTheRowOfUnits) {
  const std::string advice = "if this is a heading, header_rows counts the rows above the data";
  TraceFormat format = format_of();
  expect_refused("t,f\n[s],[Hz]\n0,50\n", format, "r.csv:2:1: ", advice);
  EXPECT_THAT([&] { (void)read_trace("t,f\n0,50\ns,Hz\n", "r.csv", format); },
              ThrowsMessage<std::runtime_error>(Not(HasSubstr(advice))));
  format.time_format = "%d.%m.%Y";
  expect_refused("t,f\ndate,Hz\n", format, "r.csv:2:1: ", advice);
}

TEST(RecordingColumns, AreListedUpToTen) {
  const std::string ten = "a,b,c,d,e,f,g,h,i,j";
  expect_refused(ten + "\n", format_of(), "r.csv:1:1: ", "`i`, `j`");
  expect_refused(ten + ",k\n", format_of(), "r.csv:1:1: ", "`i`, `j`, … (11 in all)");
}

TEST(RecordingDelimiter, IsGiven) {
  TraceFormat format = format_of();
  format.delimiter = ";";
  EXPECT_THAT(frequencies_hz("t;f\n0;50\n1;49\n", format), ElementsAre(50, 49));
  format.delimiter = "tab";
  const std::string with_tabs = "t\tx\tf\n0\t\t50\n1\t\t49\n";
  EXPECT_THAT(frequencies_hz(with_tabs, format), ElementsAre(50, 49));
  expect_refused(with_tabs, format_of(), "r.csv:1:1: ", "(is the delimiter `tab`?)");
  format.delimiter = "\t";
  EXPECT_THAT(frequencies_hz(with_tabs, format), ElementsAre(50, 49));
  format.delimiter = "space";
  EXPECT_THAT(frequencies_hz("  t   f \n 0 50\n1\t 49  \n", format), ElementsAre(50, 49));
  for (const char* wrong : {"a", "\"", "::", "", "\n", ".", "+", "-"}) {
    format.delimiter = wrong;
    if (format.delimiter.empty()) {
      EXPECT_THAT(frequencies_hz("t,f\n0,50\n1,49\n", format), ElementsAre(50, 49));
    } else {
      expect_refused("t,f\n0,50\n", format, "delimiter is `", "one character");
    }
  }
}

TEST(RecordingNumbers, MayHaveSignsExponentsAndDecimalCommas) {
  EXPECT_THAT(frequencies_hz("t,f\n-1e-1,+5.0E+01\n+2.5E0,50\n", format_of()), ElementsAre(50, 50));
  for (const char* wrong : {"+", "+-50", "++50", "5 0", "50,0"}) {
    expect_refused("t,f\n0,\""s + wrong + "\"\n", format_of(),
                   "r.csv:2:3: ", "not a finite number");
  }
  TraceFormat comma = format_of();
  comma.decimal = ",";
  EXPECT_THAT(frequencies_hz("t;f\n0,5;50,25\n1,5;+4,9E1\n", comma), ElementsAre(50.25, 49));
  EXPECT_THAT(times_s("t;f\n0,5;50\n1,75;49\n", comma), ElementsAre(0, 1.25));
  expect_refused("t;f\n0;50.25\n", comma, "r.csv:2:3: ", "`50.25` is not a finite number");
  comma.delimiter = ",";
  EXPECT_THAT(frequencies_hz("t,f\n0,\"50,25\"\n1,49\n", comma), ElementsAre(50.25, 49));
}

TEST(RecordingUnits, AreConverted) {
  struct Case {
    const char* unit;
    double offset_hz;
    const char* value;
    double expected_hz;
  };
  for (const Case& c : {Case{"Hz", 50.0, "-0.125", 49.875}, Case{"mHz", 50.0, "-125", 49.875},
                        Case{"mHz", 0.0, "49875", 49.875}, Case{"kHz", 0.0, "0.05", 50.0},
                        Case{"rad/s", 0.0, "314.1592653589793", 50.0},
                        Case{"pu", 0.0, "0.99", 49.5}, Case{"pu", 50.0, "-0.01", 49.5}}) {
    TraceFormat format = format_of();
    format.frequency_unit = c.unit;
    format.frequency_offset_hz = c.offset_hz;
    EXPECT_NEAR(frequencies_hz("t,f\n0,"s + c.value + "\n1," + c.value + "\n", format).at(0),
                c.expected_hz, 1e-12)
        << c.unit;
  }
  TraceFormat format = format_of();
  format.frequency_unit = "GHz";
  expect_refused("t,f\n0,50\n", format, "frequency_unit is `GHz`", "Hz, mHz, kHz, rad/s, pu");
  format = format_of();
  format.time_unit = "ms";
  EXPECT_THAT(times_s("t,f\n1745838002000,50\n1745838002500,50\n", format), ElementsAre(0, 0.5));
}

TEST(RecordingTimes, AreReadByAFormat) {
  struct Case {
    const char* format;
    const char* first;
    const char* second;
    double difference_s;
  };
  for (const Case& c :
       {Case{"%d.%m.%Y %H:%M:%S", "28.04.2025 11:00:02", "28.04.2025 11:00:02.25", 0.25},
        Case{"%d.%m.%y %H:%M", "1.4.25 9:00", "1.4.25 10:30", 5400.0},
        Case{"%m/%d/%Y %I:%M:%S %p", "12/31/2024 11:59:59 PM", "1/1/2025 12:00:00 am", 1.0},
        Case{"%Y%m%d%H%M%S", "20250428110002", "20250428110003", 1.0},
        Case{"%H:%M:%S", "09:00:00", "09:00:00,5", 0.5},
        Case{"%d %b %Y %H:%M:%S %z", "28 Apr 2025 11:00:00 +0200", "28 apr 2025 09:00:01 Z", 1.0},
        Case{"100%% %S", "100% 01", "100%   03", 2.0}}) {
    TraceFormat format = format_of();
    format.time_format = c.format;
    EXPECT_THAT(times_s("t;f\n"s + c.first + ";50\n" + c.second + ";50\n",
                        [&] {
                          TraceFormat with = format;
                          with.delimiter = ";";
                          return with;
                        }()),
                ElementsAre(0, c.difference_s))
        << c.format;
  }
  TraceFormat format = format_of();
  format.time_format = "%d.%m.%Y";
  expect_refused("t,f\n2025-04-28,50\n", format, "r.csv:2:1: ", "as time_format, `%d.%m.%Y`");
  expect_refused("t,f\n30.02.2025,50\n", format, "r.csv:2:1: ", "`30.02.2025` is not a time");
  format.time_format = "%I:%M %p";
  expect_refused("t,f\n13:00 PM,50\n", format, "r.csv:2:1: ", "is not a time");
  format.time_format = "%Q";
  expect_refused("t,f\n0,50\n", format, "time_format has `%Q`", "%Y");
}

TEST(RecordingTimes, BeyondTheRangeOrWithASecond60AreNamed) {
  expect_refused("t,f\n1745838000000000000,50\n", format_of(),
                 "r.csv:2:1: ", "is beyond 10¹⁵ s; time_unit gives another unit, such as ns");
  expect_refused("t,f\n2016-12-31T23:59:59Z,50\n2016-12-31T23:59:60Z,50\n", format_of(),
                 "r.csv:3:1: ", "(a second 60 is not read)");
}

TEST(RecordingMessages, NameOptionsByTheGivenFunction) {
  TraceLimits limits;
  limits.highest_hz = 75.0;
  limits.option_name = [](const std::string& name) { return "--" + name; };
  const auto refusal = [&](const std::string& text) {
    try {
      (void)read_trace(text, "r.csv", format_of(), limits);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal("t,f\n0,x\n"), EndsWith("; --gaps gives further words"));
  EXPECT_THAT(refusal("t,f\n0,314\n"),
              EndsWith("; --frequency_unit and --frequency_offset_hz give another unit and "
                       "deviations"));
  EXPECT_THAT(
      refusal("t,f\nnoon,50\n"),
      HasSubstr("; --time_format gives another format; if this is a heading, --header_rows"));
}

TEST(RecordingTimes, ThatAreMissingMakeAGap) {
  TraceFormat format = format_of();
  format.gaps = {"bad", "1"};
  const std::string text = "t,f\n,50\n0,50\n,49.9\nNA,\nbad,49.8\n1,49.7\n2,50\n,bad\n";
  const Trace trace = read_trace(text, "r.csv", format);
  EXPECT_EQ(trace.rows, 8U);
  EXPECT_EQ(trace.gaps, 5U);
  EXPECT_EQ(trace.text, text);
  EXPECT_THAT(times_s(text, format), ElementsAre(0, 1, 2)) << "1 is a time, although a gap word";
  expect_refused("t,f\n0,50\nnoon,50\n", format, "r.csv:3:1: ", "`noon` is not a time");
  format.time_format = "%H:%M";
  EXPECT_THAT(times_s("t,f\n09:00,50\n1,50\n09:01,50\n", format), ElementsAre(0, 60));
}

TEST(RecordingText, IsUtf8OrNot) {
  for (const char* text : {"", "f", "f\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x98\x80"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
  }
  for (const char* text : {"f\xe4", "\xe4\"", "\xc0\xaf", "\xc3", "\xed\xa0\x80", "\x80"}) {
    EXPECT_FALSE(is_utf8(text));
  }
}

TEST(RecordingMessages, EscapeWhatIsNotPrintable) {
  expect_refused("t,f\n0,\"5\0\x1b\xff\xc3\xa4\"\n"s, format_of(), "r.csv:2:3: ",
                 "`5\\x00\\x1b\\xff\xc3\xa4` is not a finite number, it has NUL bytes");
  expect_refused("t,f\n0,50\xc2\xa0\n", format_of(), "r.csv:2:3: ", "it has the character U+00A0");
  expect_refused(
      "t,f\n0,\xe2\x88\x92"
      "1\n",
      format_of(), "r.csv:2:3: ", "the character U+2212");
  expect_refused("t,f\n0\xe2\x80\x89,50\n", format_of(), "r.csv:2:1: ", "the character U+2009");
  expect_refused("t\0,f\n0,50\n"s, format_of(), "r.csv:1:1: ", "the columns are `t\\x00`, `f`");
  EXPECT_THAT(
      [] { (void)read_trace("t,f\n0," + std::string(5000, 'x') + "\n", "r.csv", format_of()); },
      ThrowsMessage<std::runtime_error>(
          AllOf(HasSubstr("xxx…` is not"), EndsWith("gaps gives further words"))));
}

TEST(RecordingFiles, ThatAreNoTextAreNamed) {
  struct Case {
    std::string bytes;
    const char* name;
  };
  for (const Case& c :
       {Case{"\xff\xfet\0,\0f\0\n\0"s, "UTF-16"}, Case{"\xfe\xff\0t\0,\0f"s, "UTF-16"},
        Case{"t\0,\0f\0\n\0"s, "UTF-16"}, Case{"\0t\0,\0f\0\n"s, "UTF-16"},
        Case{"\xff\xfe\0\0t\0\0\0"s, "UTF-32"}, Case{"t\0\0\0,\0\0\0f\0\0\0\n\0\0\0"s, "UTF-32"},
        Case{"PK\x03\x04..."s, "Excel"}, Case{"\x1f\x8b\x08..."s, "gzip"},
        Case{"\x89HDF\r\n"s, "HDF5"}}) {
    expect_refused(c.bytes, format_of(), "r.csv:1:1: ", c.name);
  }
}

}  // namespace
}  // namespace gsbench::recording
