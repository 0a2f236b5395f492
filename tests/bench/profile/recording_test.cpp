// Recordings as the stimulus, given in the profile or on the command line.
#include <profile_test/texts.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>

#include <gmock/gmock.h>

namespace gsbench::profile::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

constexpr const char* kCsv =
    "t,f,u\n"
    "0,50.0,230\n"
    "1,49.9,230\n"
    "2,49.8,115\n"
    "3,49.7,230\n"
    "4,49.6,230\n"
    "5,49.5,230\n";

class Recording : public testing::Test {
 protected:
  Recording() { folder_.write("recording.csv", kCsv); }

  std::string path(const std::string& name) const { return folder_.file(name); }
  Plan parse_here(const std::string& text, const Overrides& overrides = {}) const {
    return parse_profile(text, path("case.toml"), overrides);
  }
  std::string refusal_here(const std::string& text, const Overrides& overrides = {}) const {
    return refusal(text, path("case.toml"), overrides);
  }
  // The message without the profile's path.
  std::string refusal_of_one_with(const std::string& what, const std::string& by) const {
    const std::string message = refusal_here(replaced(kRecording, what, by));
    EXPECT_THAT(message, StartsWith(path("case.toml") + ":"));
    return message.substr(std::min(message.size(), path("case.toml").size() + 1));
  }
  Overrides replay(const std::string& name) const {
    Overrides overrides;
    overrides.trace_path = path(name);
    overrides.trace_format = {"t", "f", "", {}};
    return overrides;
  }

  const gsbench::test::TemporaryFolder folder_;
};

TEST_F(Recording, IsFoundBesideTheProfileAndCutToItsWindow) {
  const Plan plan = parse_here(kRecording);
  EXPECT_EQ(plan.stimulus.recording.path, path("recording.csv"));
  ASSERT_THAT(plan.stimulus.points, SizeIs(3));  // of 1 s … 4 s, up to the duration
  EXPECT_EQ(plan.stimulus.points[0].t_s, 0.0);
  EXPECT_EQ(plan.stimulus.points[0].frequency_hz, 49.9);
  EXPECT_EQ(plan.stimulus.points[1].voltage_pu, 0.5);
  EXPECT_EQ(plan.stimulus.points[2].t_s, 2.0);
  EXPECT_EQ(plan.stimulus.duration_s, 2.0);
  EXPECT_NEAR(plan.reference()->frequency_hz(2.0), 49.7, 1e-12);  // rounding of a cubic
}

TEST_F(Recording, HasItsNameColumnsAndDigestInThePlan) {
  const profile::Recording own = parse_here(kRecording).stimulus.recording;
  EXPECT_EQ(own.file, "recording.csv") << "as given in the profile";
  EXPECT_EQ(own.format.voltage, "u");
  EXPECT_EQ(own.sha256, "4fa5e3a1c3d7576c5d86a01f68b4974c7a3055ae4491f197a1af73e00d069837");
  EXPECT_FALSE(own.replaces_profile);
  folder_.write("other.csv", "t,f\n0,50\n9,50\n");
  const profile::Recording other = parse_here(kRecording, replay("other.csv")).stimulus.recording;
  EXPECT_EQ(other.file, path("other.csv"));
  EXPECT_EQ(other.format.voltage, "");
  EXPECT_NE(other.sha256, own.sha256);
  EXPECT_TRUE(other.replaces_profile);
  EXPECT_EQ(parse(kMinimal).stimulus.recording.file, "");
}

TEST_F(Recording, IsReadInAForeignFormat) {
  folder_.write("foreign.csv", kForeignCsv);
  const Stimulus stimulus = parse_here(kForeignRecording).stimulus;
  EXPECT_EQ(stimulus.recording.rows, 4U);
  EXPECT_EQ(stimulus.recording.gaps, 2U);
  ASSERT_THAT(stimulus.points, SizeIs(2));
  EXPECT_DOUBLE_EQ(stimulus.points[0].frequency_hz, 49.9895);
  EXPECT_EQ(stimulus.points[1].t_s, 2.0);
  EXPECT_DOUBLE_EQ(stimulus.points[1].frequency_hz, 50.01);
}

TEST_F(Recording, HasOptionsThatArePrintedAndReadAgain) {
  recording::TraceFormat format = {"t", "#2", "u \"1\"", 230.5, "1", "2025-04-28 11:00:03"};
  format.delimiter = "\t";
  format.decimal = ",";
  format.skip_rows = 3;
  format.header_rows = 0;
  format.time_unit = "ms";
  format.time_format = "%H:%M:%S";
  format.frequency_unit = "rad/s";
  format.frequency_offset_hz = 49.95;
  format.gaps = {"-999", "it's bad"};
  const std::string text = trace_options(format);
  EXPECT_EQ(trace_options(trace_format(text)), text);
  int fields = 0;
  recording::visit_fields(format, [&](const char* key, const auto&) {
    EXPECT_THAT(text, HasSubstr(std::string(key) + " = "));
    ++fields;
  });
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), fields);
}

TEST_F(Recording, HasOptionsOfAnyBytes) {
  recording::TraceFormat format = {"t\xe4\xc3\xa4", "f\x80\xff", "\\u\"\xe4", {}};
  format.gaps = {"\xe4,\"", "k\xc3\xa4"};
  const recording::TraceFormat again = trace_format(trace_options(format));
  EXPECT_EQ(again.time, format.time);
  EXPECT_EQ(again.frequency, format.frequency);
  EXPECT_EQ(again.voltage, format.voltage);
  EXPECT_EQ(again.gaps, format.gaps);
  EXPECT_EQ(trace_format(trace_options({"t\xc3\xa4", "f", "", {}})).time, "t\xc3\xa4");
  EXPECT_THAT(trace_options({"t\xc3\xa4", "f", "", {}}), HasSubstr("t\\u00E4"));
}

TEST_F(Recording, IsPlayedToItsEndWithoutADuration) {
  EXPECT_EQ(parse_here(replaced(kRecording, "duration_s = 2.0", "")).stimulus.duration_s, 3.0);
}

TEST_F(Recording, IsRefusedAtThePositionInTheProfile) {
  EXPECT_EQ(refusal_of_one_with("duration_s = 2.0", "duration_s = 3.5"),
            "6:14: duration_s is 3.5; it must be at most 3 (the recording's length)");
  EXPECT_EQ(refusal_of_one_with("recording.csv", "none.csv"),
            "8:8: file is \"none.csv\"; " + path("none.csv") + " does not exist");
  std::filesystem::create_directory(path("folder.csv"));
  EXPECT_EQ(refusal_of_one_with("recording.csv", "folder.csv"),
            "8:8: file is \"folder.csv\"; " + path("folder.csv") +
                " is a folder, device or pipe; save the recording as an ordinary file");
  EXPECT_EQ(refusal_of_one_with("voltage = \"u\"", ""),
            "12:19: nominal_voltage is given without a voltage column; give both or none");
  EXPECT_EQ(refusal_of_one_with("from_s = 1.0", "from_s = 3.5"),
            "13:10: from_s leaves fewer than two rows to play; the times of the file are `0` "
            "(line 2, column 1) … `5` (line 7, column 1), and numbers are seconds after the first "
            "row");
  EXPECT_EQ(refusal_of_one_with("until_s = 4.0", "until_s = 0.5"),
            "14:11: until_s is 0.5; it must be above 1, the start");
}

TEST_F(Recording, IsNamedInTheRefusalIfAColumnIsMissing) {
  EXPECT_THAT(refusal_here(replaced(kRecording, "frequency = \"f\"", "frequency = \"g\"")),
              StartsWith(path("recording.csv") + ":1:"));
}

TEST_F(Recording, OfTheCommandLineReplacesLossesAmplitudeStepsAndPhaseSteps) {
  folder_.write("long.csv", std::string(kCsv) + "20,49.5,230\n");
  const Stimulus stimulus = parse_here(kLossesInPlace, replay("long.csv")).stimulus;
  EXPECT_EQ(stimulus.duration_s, 20.0);
  EXPECT_THAT(stimulus.losses, IsEmpty());
  EXPECT_THAT(stimulus.signal.amplitude_steps, IsEmpty());
  EXPECT_THAT(stimulus.signal.phase_jumps, IsEmpty());
  EXPECT_THAT(stimulus.signal.harmonics, SizeIs(26));
  EXPECT_EQ(stimulus.noise_pct, 0.5);
}

TEST_F(Recording, OfTheCommandLineReplacesTheFrequencyBeforeOscillationsAndTones) {
  folder_.write("long.csv", std::string(kCsv) + "20,49.5,230\n");
  const Plan plan = parse_here(kDisturbed, replay("long.csv"));
  EXPECT_EQ(plan.stimulus.initial_deviation_hz, 0.0);
  EXPECT_THAT(plan.stimulus.oscillations, IsEmpty());
  EXPECT_THAT(plan.stimulus.signal.tones, IsEmpty());
  EXPECT_THAT(plan.stimulus.signal.flickers, IsEmpty());
  EXPECT_EQ(plan.reference()->frequency_hz(20.0), 49.5);
}

TEST_F(Recording, OfTheCommandLineIsPlayedBeyondTheDurationOfTheProfile) {
  folder_.write("long.csv", "t,f\n0,50\n14,49.9\n");
  EXPECT_EQ(parse_here(kMinimal).stimulus.duration_s, 6.0);
  EXPECT_EQ(parse_here(kMinimal, replay("long.csv")).stimulus.duration_s, 14.0);
}

TEST_F(Recording, IsRefusedIfItsFrequencyTakesAHarmonicToHalfTheSampleRate) {
  folder_.write("rise.csv", "t,f\n0,50\n1,60\n2,50\n");
  const std::string text =
      replaced(kMinimal, "[signal]", "[signal]\nharmonics = [[5, 1, 0], [66.7, 1.0, 0.0]]");
  EXPECT_EQ(refusal_here(text), "");
  EXPECT_THAT(refusal_here(text, replay("rise.csv")),
              HasSubstr("harmonic order 66.7 is at 4002 Hz at 1 s, where the frequency is 60 Hz; "
                        "it must be below 4000 Hz"));
  EXPECT_EQ(refusal_here(replaced(text, "66.7", "66.6"), replay("rise.csv")), "");
}

TEST_F(Recording, OfTheCommandLineReplacesAMissingOne) {
  const Plan plan =
      parse_here(replaced(kRecording, "recording.csv", "none.csv"), replay("recording.csv"));
  EXPECT_EQ(plan.stimulus.recording.path, path("recording.csv"));
  EXPECT_EQ(plan.stimulus.duration_s, 5.0);
}

TEST_F(Recording, IsRefusedWithAVoltageBeyondFullScale) {
  EXPECT_EQ(
      refusal_here(replaced(kRecording, "nominal_voltage = 230.0", "nominal_voltage = 150.0")),
      path("recording.csv") +
          ":3:8: the voltage reaches 1.533 p.u. at 0 s, harmonics and offset included; it must be "
          "at most 1.5 p.u.");
  folder_.write("peak.csv", "u,t,f\n230,0,50\n230,1,50\nNA,2,50\n 500,3,50\n230,4,50\n");
  Overrides overrides = replay("peak.csv");
  overrides.trace_format.voltage = "u";
  EXPECT_THAT(refusal_here(kMinimal, overrides),
              StartsWith(path("peak.csv") + ":5:2: the voltage reaches 2.174 p.u. at 3 s"));
  // The greatest voltage is between two points, at the end of a dip.
  folder_.write("recording.csv", "t,f,u\n1,50,230\n2,50,115\n4,50,690\n");
  EXPECT_THAT(refusal_here(replaced(kRecording, "[signal.trace]",
                                    "[[signal.amplitude_step]]\nat_s = 0.0\nduration_s = "
                                    "1.5\nlevel_pct = 50.0\n[signal.trace]")),
              StartsWith(path("recording.csv") + ":4:6: the voltage reaches "));
}

TEST_F(Recording, OfTheCommandLineIsNamedInItsRefusal) {
  folder_.write("short.csv", "t,f\n0,50\n0.09,50\n");
  EXPECT_EQ(refusal_here(kMinimal, replay("short.csv")),
            path("short.csv") + ":3:1: the recording is 0.09 s long; it must be at least 0.1 s");
  EXPECT_EQ(refusal_here(kMinimal, replay("none.csv")), path("none.csv") + ": does not exist");
  EXPECT_EQ(refusal_here(kMinimal, replay("/dev/null")),
            "/dev/null: is a folder, device or pipe; save the recording as an ordinary file");
  folder_.write("bad.csv", "t,f\n0,50\n1,fifty\n");
  EXPECT_THAT(refusal_here(kMinimal, replay("bad.csv")), StartsWith(path("bad.csv") + ":3:"));
}

TEST_F(Recording, IsRefusedIfItEndsBeforeACommand) {
  const std::string text = std::string(kMinimal) + "[[command]]\nat_s = 5.5\nswitch = \"off\"\n";
  EXPECT_EQ(refusal_here(text), "");
  EXPECT_THAT(refusal_here(text, replay("recording.csv")),
              HasSubstr(":12:8: at_s is 5.5; it must be at least 0 and at most 4.999875"));
}

}  // namespace
}  // namespace gsbench::profile::test
