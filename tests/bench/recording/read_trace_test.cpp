#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>

#include <recording/trace.hpp>

namespace gsbench::recording {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

class ReadTrace : public testing::Test {
 protected:
  std::vector<TracePoint> read(const std::string& text, const TraceFormat& columns) const {
    return read_trace(text, path_, columns).points;
  }

  void expect_refused(const std::string& text, const TraceFormat& columns, const std::string& place,
                      const std::string& what) const {
    EXPECT_THAT([&] { return read(text, columns); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(StartsWith(path_ + ":" + place + ": "), HasSubstr(what))))
        << text;
  }

  const std::string path_ = testing::TempDir() + "none.csv";
  TraceFormat columns_{"t", "f", "", {}};
  TraceFormat with_voltage_{"t", "f", "v", {}};
};

TEST_F(ReadTrace, TakesColumnsInAnyOrderAndTimeFromTheFirstRow) {
  const auto points = read("v,x,f,t\n230,9,50.01,100\n115,9,49.5,102.25\n", {"t", "f", "v", 230.0});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].t_s, 0.0);
  EXPECT_EQ(points[0].frequency_hz, 50.01);
  EXPECT_EQ(points[0].voltage_pu, 1.0);
  EXPECT_EQ(points[1].t_s, 2.25);
  EXPECT_EQ(points[1].frequency_hz, 49.5);
  EXPECT_EQ(points[1].voltage_pu, 0.5);
}

TEST_F(ReadTrace, HasNominalVoltageWithoutAVoltageColumn) {
  EXPECT_EQ(read("t,f\n0,50\n1,50\n", columns_).at(1).voltage_pu, 1.0);
}

TEST_F(ReadTrace, TakesTheMedianAsDefaultOfTheNominalVoltage) {
  const auto points = read("t,f,v\n0,50,400\n1,50,8\n2,50,404\n", with_voltage_);
  EXPECT_EQ(points[0].voltage_pu, 1.0);
  EXPECT_EQ(points[1].voltage_pu, 0.02);
}

TEST_F(ReadTrace, KeepsTheRecordedFrequencyOfADeadBus) {
  const auto points = read("t,f,v\n0,50,230\n1,47.4,0\n2,40,230\n", with_voltage_);
  EXPECT_EQ(points[1].voltage_pu, 0.0);
  EXPECT_EQ(points[1].frequency_hz, 47.4);
}

TEST_F(ReadTrace, SkipsGapsButChecksTheirTime) {
  const auto points =
      read("t,f,v\n0,50,230\n1,NaN,230\n2,50,nan\n3,,NA\n3.5,null,230\n4,49,230\n", with_voltage_);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].t_s, 4.0);
  EXPECT_EQ(points[1].frequency_hz, 49.0);
  expect_refused("t,f\n0,50\n5,NaN\n4,50\n", columns_, "4:1", "time `4` is not later");
}

TEST_F(ReadTrace, AcceptsQuotesCarriageReturnsByteOrderMarksBlanksAndEmptyLines) {
  const auto points = read(
      "\xef\xbb\xbf\"t\",\"f, in \"\"Hz\"\"\",note\r\n0 ,\t50 ,\"two\nlines\"\r\n\r\n\"1\",49.9,x",
      {"t", "f, in \"Hz\"", "", {}});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].frequency_hz, 50.0);
  EXPECT_EQ(points[1].t_s, 1.0);
  EXPECT_EQ(points[1].frequency_hz, 49.9);
}

TEST_F(ReadTrace, AcceptsCarriageReturnsAloneAsLineEnds) {
  EXPECT_EQ(read("t,f\r0,50\r1,49\r", columns_).at(1).frequency_hz, 49.0);
  expect_refused("t,f\r0,50\r1,x\r", columns_, "3:3", "`x` is not");
}

TEST_F(ReadTrace, ReadsDatesAndTimes) {
  struct Case {
    const char* first;
    const char* second;
    double difference_s;
  };
  for (const Case& times : {
           Case{"28-Apr-2025 11:00:02", "28-Apr-2025 12:33:16", 5594.0},
           Case{"31-DEC-2024 23:59:59.75", "01-jan-2025 00:00:00.25", 0.5},
           Case{"2025-04-28T11:00:02Z", "2025-04-28T11:00:02.5Z", 0.5},
           Case{"2025-04-28T11:00:00Z", "2025-04-28T13:30:00+02:00", 1800.0},
           Case{"2025-04-28T11:00:00-0130", "2025-04-28T13:00:00Z", 1800.0},
           Case{"2025-04-28 11:00:02.5", "2025-04-28 11:00:04", 1.5},
           Case{"2024-02-28 00:00:00", "2024-03-01 00:00:00", 2 * 86400.0},
           Case{"2100-02-28 00:00:00", "2100-03-01 00:00:00", 86400.0},
           Case{"2000-02-28 00:00:00", "2000-03-01 00:00:00", 2 * 86400.0},
           Case{"1745838002.125", "1745838002.25", 0.125},
           Case{"-1.5", "2", 3.5},
           Case{"1e3", "1001", 1.0},
       }) {
    const auto points =
        read(std::string("t,f\n") + times.first + ",50\n" + times.second + ",50\n", columns_);
    EXPECT_EQ(points.at(1).t_s, times.difference_s) << times.first;
  }
}

TEST_F(ReadTrace, RefusesInvalidTimes) {
  for (const char* time :
       {"noon", "28-Apr-2025", "2025-13-01 00:00:00", "2025-02-29 00:00:00", "29-Feb-2025 00:00:00",
        "2025-04-28 24:00:00", "2025-04-28 11:60:00", "2025-04-28 11:00:60", "2025-04-28 11:00:02.",
        "2025-04-28 11:00:02x", "2025-04-28T11:00:02+2", "28-Abr-2025 11:00:00", "inf", "12 s"}) {
    expect_refused("f,t\n50," + std::string(time) + "\n", columns_, "2:4", "is not a time");
  }
}

TEST_F(ReadTrace, RefusesTimesThatDoNotIncrease) {
  expect_refused("t,f\n0,50\n2,50\n1,50\n", columns_, "4:1", "time `1` is not later");
  expect_refused("t,f\n0,50\n0,50\n", columns_, "3:1", "time `0` is not later");
  expect_refused("t,f\n0,50\n1e-13,51\n", columns_, "3:1", "must increase by at least 1 ps");
  EXPECT_EQ(read_trace("t,f\n0,50\n2e-12,51\n", "r.csv", columns_).points.size(), 2U);
}

TEST_F(ReadTrace, RefusesTimesOfDifferentFormats) {
  expect_refused("t,f\n0,50\n2025-04-28 11:00:00,50\n", columns_, "3:1", "another format");
  expect_refused("t,f\n2025-04-28 11:00:00,50\n2025-04-28T11:00:01Z,50\n", columns_, "3:1",
                 "another format");
}

TEST_F(ReadTrace, RefusesValuesThatAreNotNumbers) {
  for (const char* value : {"fifty", "50,1", "50 Hz", "inf", "-inf", "0x32", "1e999"}) {
    expect_refused("t,f\n0,\"" + std::string(value) + "\"\n", columns_, "2:3",
                   "`" + std::string(value) + "` is not a finite number");
  }
}

TEST_F(ReadTrace, RefusesValuesOutOfRange) {
  expect_refused("t,f\n0,50\n1,0\n", columns_, "3:3", "the frequency is 0 Hz; it must be above 0");
  expect_refused("t,f,v\n0,50,-1\n", with_voltage_, "2:6", "the RMS voltage is -1");
}

TEST_F(ReadTrace, RefusesANominalVoltageThatIsNotAbove0) {
  expect_refused("t,f,v\n0,50,0\n1,50,0\n", with_voltage_, "1:5",
                 "the nominal voltage of `v` is 0");
  for (const double nominal : {0.0, -230.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(
        [&] {
          return read("t,f,v\n0,50,230\n1,50,230\n", {"t", "f", "v", nominal});
        },
        ThrowsMessage<FormatError>(
            AllOf(StartsWith("nominal_voltage is "), HasSubstr("finite and above 0"))));
  }
}

TEST_F(ReadTrace, ListsTheColumnsIfOneIsMissing) {
  expect_refused("time,f\n0,50\n", columns_, "1:1", "no column `t`; the columns are `time`, `f`");
  expect_refused("t,f\n0,50\n", with_voltage_, "1:1", "no column `v`");
  expect_refused("t,f,f\n0,50,50\n", columns_, "1:5", "a second column `f`");
}

TEST_F(ReadTrace, RefusesARowThatIsTooShort) {
  expect_refused("t,x,f\n0,1,50\n1,2\n", columns_, "3:4",
                 "the row has 2 cells; it must have at least 3, up to column `f`");
}

TEST_F(ReadTrace, RefusesInvalidQuotes) {
  expect_refused("t,f\n0,\"50\n", columns_, "2:3", "not closed");
  expect_refused("t,f\n0,\"50\"1\n", columns_, "2:7", "after a closing quote");
}

TEST_F(ReadTrace, CountsQuotedLineBreaksAsLines) {
  expect_refused("t,f,n\n0,50,\"a\nb\"\n1,x,c\n", columns_, "4:3", "`x` is not");
}

TEST_F(ReadTrace, RefusesAFileWithoutData) {
  expect_refused("", columns_, "1:1", "empty");
  expect_refused("t,f\n", columns_, "1:4", "no data below");
}

TEST_F(ReadTrace, RefusesAFileThatCannotBeRead) {
  EXPECT_THAT([&] { return read_trace_file(path_); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(StartsWith(path_ + ":1:1: "), HasSubstr("No such file"))));
  EXPECT_THAT([&] { return read_trace_file(testing::TempDir()); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(StartsWith(testing::TempDir() + ":1:1: "), HasSubstr("cannot be read"))));
}

}  // namespace
}  // namespace gsbench::recording
