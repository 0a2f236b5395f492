// Recordings on the command line.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <fstream>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class PlayedRecording : public testing::Test {
 protected:
  Words with(const std::string& csv, const Words& options) const {
    Words words = {"run",     "regression/steady",      "--json", "--out", folder_.file("runs"),
                   "--trace", folder_.write(name_, csv)};
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }

  const TemporaryFolder folder_;
  std::string name_ = "grid.csv";
};

constexpr const char* kGerman =
    "Netz\nZeit;Abweichung\n26.10.2025 02:00:00;0\n26.10.2025 02:00:00;0\n26.10.2025 "
    "02:00:01;-1,5\n"
    "26.10.2025 02:00:02;k.A.\n26.10.2025 02:00:03;+2,25E0\n26.10.2025 02:00:04;x\n";
const Words kGermanOptions = {"--trace-time",
                              "1",
                              "--trace-frequency",
                              "Abweichung",
                              "--trace-decimal",
                              ",",
                              "--trace-skip-rows",
                              "1",
                              "--trace-time-format",
                              "%d.%m.%Y %H:%M:%S",
                              "--trace-frequency-unit",
                              "mHz",
                              "--trace-frequency-offset",
                              "50",
                              "--trace-gaps",
                              "-999,k.A.",
                              "--trace-from",
                              "1",
                              "--trace-until",
                              "26.10.2025 02:00:03"};

TEST_F(PlayedRecording, IsReadWithEachOptionAndReported) {
  const Outcome outcome = run_gsbench(with(kGerman, kGermanOptions));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("grid.csv: rows: 3, 1 of them a gap; 2 s are played"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("warning")));
  const json recording = json::parse(outcome.out)["recording"];
  EXPECT_EQ(recording["time"], "1");
  EXPECT_EQ(recording["rows"], 3);
  EXPECT_EQ(recording["gaps"], 1);
  EXPECT_EQ(recording["played_s"], 2.0);
  EXPECT_EQ(recording["options"], (json{{"from_s", "1"},
                                        {"until_s", "26.10.2025 02:00:03"},
                                        {"decimal", ","},
                                        {"skip_rows", 1},
                                        {"time_format", "%d.%m.%Y %H:%M:%S"},
                                        {"frequency_unit", "mHz"},
                                        {"frequency_offset_hz", 50},
                                        {"gaps", {"-999", "k.A."}}}));
}

TEST_F(PlayedRecording, IsRefusedByTheNameOfTheOption) {
  Words options = kGermanOptions;
  options.back() = "1";
  expect_refused(with(kGerman, options), "--trace-until is 1; it must be above 1, the start");
  expect_refused(
      with("t,f,v\n0,50,230\n1,50,230\n", {"--trace-time", "t", "--trace-frequency", "f",
                                           "--trace-voltage", "v", "--trace-nominal-voltage", "0"}),
      "--trace-nominal-voltage is 0; it must be finite and above 0");
}

TEST_F(PlayedRecording, IsRefusedWithAdviceOnOptions) {
  const Words columns = {"--trace-time", "t", "--trace-frequency", "f"};
  expect_refused(with("t,f\n0,x\n", columns), "grid.csv:2:3: `x` is not a finite number");
  expect_refused(with("t,f\n0,x\n", columns), "--trace-gaps gives further words");
  expect_refused(with("t,f\n0,314\n1,314\n", columns),
                 "--trace-frequency-unit and --trace-frequency-offset give another unit");
  expect_refused(with("t,f\n0,50\n1,50\n", {"--trace-frequency", "f"}),
                 "the names of the columns, or their numbers from 1");
}

TEST_F(PlayedRecording, ThatLacksRowsGivesAWarning) {
  const Words columns = {"--trace-time", "t", "--trace-frequency", "f"};
  EXPECT_THAT(run_gsbench(with("t,f\n10,50\n10.1,50\n10.2,50\n10.9,50\n11,50\n", columns)).err,
              HasSubstr("grid.csv: no value for 0.7 s after 0.2 s of the played part, where one "
                        "comes each 0.1 s"));
  EXPECT_THAT(run_gsbench(with("t,f\n0,50\n0.1,50\n0.2,50\n0.6,50\n0.7,50\n", columns)).err,
              Not(HasSubstr("warning")));
}

TEST_F(PlayedRecording, OfAnotherNominalFrequencyGivesAWarning) {
  const Words columns = {"--trace-time", "t", "--trace-frequency", "f"};
  EXPECT_THAT(
      run_gsbench(with("t,f\n0,59.9\n1,60\n2,60.1\n", columns)).err,
      HasSubstr("median frequency is 60 Hz, but the nominal frequency of the grid ieee24 is "
                "50 Hz; the recording is of a system of 60 Hz"));
  EXPECT_THAT(run_gsbench(with("t,f\n0,49.1\n1,49.1\n2,49.1\n", columns)).err,
              Not(HasSubstr("warning")));
}

TEST_F(PlayedRecording, MayHaveANameThatIsNotUtf8) {
  name_ =
      "ver\xfc"
      "cht.csv";
  const Outcome outcome =
      run_gsbench(with("t,f\n0,50\n3,50\n", {"--trace-time", "t", "--trace-frequency", "f"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(json::accept(outcome.out)) << "valid UTF-8";
  EXPECT_THAT(json::parse(outcome.out)["recording"]["file"].get<std::string>(),
              HasSubstr("cht.csv"));
}

TEST_F(PlayedRecording, IsWrittenByWaveform) {
  const std::string csv = folder_.write("grid.csv", "t,f\n0,50\n1,49.5\n2,49\n3,0\n");
  const std::string out = folder_.file("out.csv");
  const Outcome outcome =
      run_gsbench({"waveform", "regression/steady", "-o", out, "--trace", csv, "--trace-time", "t",
                   "--trace-frequency", "f", "--trace-until", "2"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(text_of(out), HasSubstr("\n1.000000,49.500000000,"));
}

}  // namespace
}  // namespace gsbench::test
