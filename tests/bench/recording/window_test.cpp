// The window of a recording: what is outside it does not matter, what is inside it does.
#include <algorithm>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include <recording/trace.hpp>

namespace gsbench::recording {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

// What the record of a run keeps gives the same points again.
Trace played(const std::string& text, const std::string& from, const std::string& until,
             const TraceLimits& limits = {}) {
  const TraceFormat format = {"t", "f", "", {}, from, until};
  Trace trace = read_trace(text, "r.csv", format, limits);
  const Trace again = read_trace(trace.text, "kept.csv", format, limits);
  EXPECT_EQ(again.text, trace.text);
  EXPECT_EQ(again.points.size(), trace.points.size());
  for (std::size_t i = 0; i < std::min(again.points.size(), trace.points.size()); ++i) {
    EXPECT_EQ(again.points[i].t_s, trace.points[i].t_s);
    EXPECT_EQ(again.points[i].frequency_hz, trace.points[i].frequency_hz);
  }
  return trace;
}

std::string refusal(const std::string& text, const std::string& from, const std::string& until) {
  try {
    (void)played(text, from, until);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kFlaws[] = {
    "X,0",      "X,-1",   "X,",      "X,fifty", "X,4",
    "X",        "X,\"50", "noon,50", ",50",     "2025-04-28 11:00:00,50",
    "X,\"5\"0", "\"X,50"};

// A flaw at time t.
std::string flaw_at(std::string flaw, int t) {
  const std::size_t x = flaw.find('X');
  return x == std::string::npos ? flaw : flaw.replace(x, 1, std::to_string(t));
}

TEST(RecordingWindow, ProtectsFromFlawsBeforeAndAfter) {
  const TraceLimits plausible = {50.0, 25.0, 75.0};
  for (const std::string flaw : kFlaws) {
    SCOPED_TRACE(flaw);
    const std::string before =
        "t,f\n0,50\n" + flaw_at(flaw, 1) + "\n1,50\n2,50\n3,50.1\n4,50.2\n5,50\n";
    EXPECT_EQ(played(before, "2", "", plausible).rows, 4U);
    const std::string after =
        "t,f\n0,50\n1,50\n2,50\n3,50.1\n4,50\n" + flaw_at(flaw, 5) + "\n6,50\n";
    EXPECT_EQ(played(after, "0", "3.5", plausible).rows, 4U);
    EXPECT_EQ(played(after, "0", "4", plausible).rows, 5U) << "it ends with a row";
    const Trace both = played(
        "t,f\n0,50\n" + flaw_at(flaw, 1) + "\n2,50\n3,50.1\n4,50\n" + flaw_at(flaw, 5) + "\n",
        "1.5", "3.5", plausible);
    EXPECT_EQ(both.points.size(), 2U);
    EXPECT_EQ(both.points[1].t_s, 1.0);
  }
}

TEST(RecordingWindow, ProtectsFromTimesThatDoNotIncrease) {
  const std::string text = "t,f\n0,50\n0,50\n2,50\n1,50\n3,50\n4,50.1\n5,50\n7,50\n7,50\n6,50\n";
  EXPECT_EQ(played(text, "3", "5").rows, 3U);
  EXPECT_THAT(refusal(text, "2", "5"), StartsWith("r.csv:5:1: time `1` is not later"));
  EXPECT_THAT(refusal(text, "3", "7"), StartsWith("r.csv:10:1: time `7` is not later"));
}

TEST(RecordingWindow, DoesNotEndAtAFalseTimeInside) {
  EXPECT_THAT(refusal("t,f\n0,50\n1,50\n99,50\n2,50\n3,50\n", "", "3"),
              AllOf(StartsWith("r.csv:4:1: "), HasSubstr("line 5 is within it")));
}

TEST(RecordingWindow, IsGivenByDatesOfTheRecording) {
  const std::string local =
      "t,f\n2025-10-26 02:00:00,50\n2025-10-26 02:00:01,50\n"
      "2025-10-26 02:00:02,50\n2025-10-26 02:00:03,50\n";
  EXPECT_EQ(played(local, "2025-10-26 02:00:01", "2025-10-26T02:00:02.5").rows, 2U);
  EXPECT_EQ(played(local, "1", "2025-10-26 02:00:02").rows, 2U);
  EXPECT_EQ(played(local, "2025-10-25 00:00:00", "").rows, 4U);
  EXPECT_THAT(refusal(local, "2025-10-26 02:00:01Z", ""), HasSubstr("have no offset from UTC"));
  const std::string zoned =
      "t,f\n2025-10-26T02:00:00+02:00,50\n2025-10-26T02:00:01+02:00,50\n"
      "2025-10-26T02:00:02+02:00,50\n";
  EXPECT_EQ(played(zoned, "2025-10-26 02:00:01", "").rows, 2U) << "the recording's own offset";
  EXPECT_EQ(played(zoned, "2025-10-26T00:00:01Z", "").rows, 2U);
  // The end of summer time: the limits are in the offset of the first row.
  const std::string changing =
      "t,f\n2025-10-26T02:59:58+02:00,50\n2025-10-26T02:59:59+02:00,50\n"
      "2025-10-26T02:00:00+01:00,50\n2025-10-26T02:00:01+01:00,50\n2025-10-26T02:00:02+01:00,50\n";
  EXPECT_EQ(played(changing, "2025-10-26 03:00:01", "2025-10-26 03:00:02").rows, 2U);
  EXPECT_THAT(refusal("t,f\n0,50\n1,50\n", "2025-10-26 02:00:01", ""),
              HasSubstr("the recording's times are numbers"));
  TraceFormat format = {"t", "f", "", {}, "26.10.2025 02:01", "60.5"};
  format.time_format = "%d.%m.%Y %H:%M";
  EXPECT_THAT(
      [&] { (void)read_trace("t,f\n26.10.2025 02:00,50\n26.10.2025 02:01,50\n", "r.csv", format); },
      ThrowsMessage<FormatError>(HasSubstr("fewer than two rows")));
}

TEST(RecordingWindow, IsGivenByDatesWithoutSecondsOrTime) {
  const std::string text =
      "t,f\n2025-10-25 23:59:30,50\n2025-10-26 00:00:00,50\n2025-10-26 00:00:30,50\n"
      "2025-10-26 00:01:00,50\n2025-10-26 00:01:30,50\n";
  EXPECT_EQ(played(text, "2025-10-26", "").rows, 4U);
  EXPECT_EQ(played(text, "", "26-Oct-2025").rows, 2U);
  EXPECT_EQ(played(text, "2025-10-26", "2025-10-26T00:01").rows, 3U);
  const std::string zoned =
      "t,f\n2025-10-26T02:00:00Z,50\n2025-10-26T02:01:00Z,50\n"
      "2025-10-26T02:02:00Z,50\n";
  EXPECT_EQ(played(zoned, "2025-10-26 03:01+01:00", "").rows, 2U);
  EXPECT_EQ(played(zoned, "2025-10-26 02:01Z", "").rows, 2U);
  for (const char* wrong : {"2025-10-26 02", "2025-10-26 02:", "2025-10-26 ", "2025-10",
                            "2025-10-26 02:00:", "2025-10-26 25:00", "2025-02-30"}) {
    EXPECT_THAT(refusal(text, wrong, ""),
                EndsWith("or date and time such as `2025-04-28 11:00:02.5`, also without seconds, "
                         "or a date"))
        << wrong;
  }
  // In rows they might be times that lost their end.
  EXPECT_THAT(refusal("t,f\n2025-10-26 00:00,50\n", "", ""), HasSubstr("is not a time"));
}

TEST(RecordingWindow, IsGivenInTheFormatOfTheRecordingWithoutSecondsOrTime) {
  const auto rows = [](const std::string& format, const std::string& text,
                       const std::string& from) {
    TraceFormat own = {"t", "f", "", {}, from};
    own.time_format = format;
    return read_trace(text, "r.csv", own).rows;
  };
  const std::string german =
      "t,f\n25.10.2025 23:59:59,50\n26.10.2025 00:00:00,50\n26.10.2025 00:01:00,50\n"
      "26.10.2025 00:01:01,50\n";
  for (const auto& [from, expected] : {std::pair("26.10.2025", 3U),
                                       {"26.10.2025 00:01", 2U},
                                       {"26.10.2025 00:00:30", 2U},
                                       {"2025-10-26", 3U}}) {
    EXPECT_EQ(rows("%d.%m.%Y %H:%M:%S", german, from), expected) << from;
  }
  const std::string american =
      "t,f\n10/26/2025 11:59:59 AM,50\n10/26/2025 12:05:00 PM,50\n10/26/2025 12:05:01 PM,50\n";
  EXPECT_EQ(rows("%m/%d/%Y %I:%M:%S %p", american, "10/26/2025 12:05 PM"), 2U);
  const std::string time_first =
      "t,f\n12:00:00 26.10.,50\n12:01:00 26.10.,50\n12:02:00 26.10.,50\n";
  EXPECT_EQ(rows("%H:%M:%S %d.%m.", time_first, "12:01 26.10."), 2U);
  for (const char* wrong :
       {"26.10.2025 00", "26.10.2025 ", "26.10.2025 00:01:", "26.10.2025 25:00"}) {
    EXPECT_THAT([&] { rows("%d.%m.%Y %H:%M:%S", german, wrong); },
                ThrowsMessage<FormatError>(EndsWith("date and time as `%d.%m.%Y %H:%M:%S`, also "
                                                    "without seconds, or a date")))
        << wrong;
  }
}

TEST(RecordingWindow, IsRefusedWithTheKey) {
  const std::string text = "t,f\n0,50\n1,50\n2,50\n";
  EXPECT_THAT(refusal(text, "2", "1"), StartsWith("until_s is 1; it must be above 2, the start"));
  EXPECT_THAT(refusal(text, "noon", ""), StartsWith("from_s is `noon`"));
  EXPECT_THAT(refusal(text, "-1", ""),
              EndsWith("from_s is -1; it must be at least 0 s after the first row"));
  EXPECT_THAT(
      refusal("t,f\n\n100,50\n101,50\nx,50\n103,50\n", "90", ""),
      EndsWith("fewer than two rows to play; the times of the file are `100` (line 3, "
               "column 1) … `103` (line 6, column 1), and numbers are seconds after the first "
               "row"));
  EXPECT_THAT(refusal("t,f\nx,50\n", "1", ""), EndsWith("no row to play; the file has no times"));
}

TEST(RecordingWindow, EndsWithTheDuration) {
  TraceLimits limits;
  limits.duration_s = 1.5;
  const Trace trace = played("t,f\n0,50\n1,50\n2,50.1\n2,bad\n", "", "", limits);
  EXPECT_EQ(trace.rows, 3U) << "up to the first row at or beyond it";
  EXPECT_EQ(trace.text, "t,f\n0,50\n1,50\n2,50.1\n");
}

}  // namespace
}  // namespace gsbench::recording
