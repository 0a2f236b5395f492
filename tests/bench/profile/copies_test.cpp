// A plan is made again from the texts that a record keeps, without the files that they come from.
#include <profile_test/texts.hpp>
#include <test_support/temporary_folder.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

namespace gsbench::profile::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kElsewhere = "/nowhere/case.toml";

Copies copies_of(const Plan& plan) {
  return {plan.grid_text, plan.stimulus.recording.played_text};
}

void expect_same(const Plan& copy, const Plan& plan) {
  EXPECT_EQ(copy.grid.name, plan.grid.name);
  EXPECT_EQ(copy.grid.sha256, plan.grid.sha256);
  EXPECT_EQ(copy.grid_text, plan.grid_text);
  EXPECT_EQ(copy.stimulus.recording.played_text, plan.stimulus.recording.played_text);
  EXPECT_EQ(copy.stimulus.recording.rows, plan.stimulus.recording.rows);
  ASSERT_EQ(copy.duration_ticks(), plan.duration_ticks());
  const auto expected = plan.reference();
  const auto actual = copy.reference();
  constexpr int kInstants = 1000;
  for (int i = 0; i <= kInstants; ++i) {
    const double t_s = plan.stimulus.duration_s * i / kInstants;
    ASSERT_EQ(actual->frequency_hz(t_s), expected->frequency_hz(t_s)) << t_s;
    ASSERT_EQ(actual->voltage_pu(t_s), expected->voltage_pu(t_s)) << t_s;
    ASSERT_EQ(actual->excess_cycles(t_s), expected->excess_cycles(t_s)) << t_s;
  }
}

TEST(Copies, MakeEveryShippedPlanAgain) {
  for (const NamedFile& file : all_profiles()) {
    SCOPED_TRACE(file.name);
    const Plan plan = load_profile(file.name);
    EXPECT_NE(plan.grid_text, "");
    expect_same(parse_profile(plan.text, kElsewhere, {}, copies_of(plan)), plan);
  }
}

class RecordingCopy : public testing::Test {
 protected:
  static constexpr const char* kGridFile = GSBENCH_SOURCE_DIR "/profiles/grids/ieee24.toml";

  Plan plan_of(const std::string& csv, const std::string& options,
               const std::string& signal = "") const {
    folder_.write("own.toml", grid_text());
    folder_.write("recording.csv", csv);
    return parse_profile(profile_text(options, signal), folder_.file("case.toml"));
  }
  static std::string grid_text() {
    std::ostringstream text;
    text << std::ifstream(kGridFile).rdbuf();
    return text.str();
  }
  static std::string profile_text(const std::string& options, const std::string& signal) {
    std::string text = replaced(kRecording, "ieee24", "own.toml");
    text = replaced(text, "duration_s = 2.0\n", signal);
    return replaced(text,
                    "time = \"t\"\nfrequency = \"f\"\nvoltage = \"u\"\nnominal_voltage = "
                    "230.0\nfrom_s = 1.0\nuntil_s = 4.0\n",
                    options);
  }
  static Plan again(const Plan& plan) {
    return parse_profile(plan.text, kElsewhere, {}, copies_of(plan));
  }

  const gsbench::test::TemporaryFolder folder_;
};

TEST_F(RecordingCopy, PlaysTheSameWithEachOption) {
  const std::string csv =
      "t,f,u\n0.1,50.0,230\n1.2,49.9,231\n2.3,,115\n3.7,49.7,230\n4.1,49.65,230\n5.3,49.5,200\n"
      "6.1,49.6,210\n";
  const std::string columns = "time = \"t\"\nfrequency = \"f\"\n";
  for (const char* options :
       {"", "from_s = 1.0", "until_s = 4.0", "from_s = 1.1\nuntil_s = 5.2", "voltage = \"u\"",
        "voltage = \"u\"\nfrom_s = 1.1", "voltage = \"u\"\nnominal_voltage = 230\nuntil_s = 4"}) {
    for (const char* signal : {"", "duration_s = 1.5\n"}) {
      SCOPED_TRACE(std::string(options) + signal);
      const Plan plan = plan_of(csv, columns + options + "\n", signal);
      expect_same(again(plan), plan);
    }
  }
}

TEST_F(RecordingCopy, PlaysTheSameInAForeignFormat) {
  folder_.write("foreign.csv", kForeignCsv);
  const Plan plan = parse_profile(kForeignRecording, folder_.file("case.toml"));
  expect_same(again(plan), plan);
  EXPECT_THAT(plan.stimulus.recording.played_text, Not(HasSubstr("11:00:04")));
}

TEST_F(RecordingCopy, HasNoFlawOutsideThePlayedPart) {
  const std::string csv =
      "t,f\n2019-08-09 16:52:00,50\n2019-08-09 16:52:00,0\nbroken\n2019-08-09 16:52:10.1,50.01\n"
      "2019-08-09 16:52:11.3,50.02\n2019-08-09 16:52:12,50.03\n2019-08-09 16:52:13,\"4\n";
  for (const char* window : {"from_s = 5\nuntil_s = 12\n",
                             "from_s = \"2019-08-09 16:52:10\"\nuntil_s = 2019-08-09 16:52:12\n"}) {
    SCOPED_TRACE(window);
    const Plan plan = plan_of(csv, std::string("time = \"t\"\nfrequency = \"f\"\n") + window);
    EXPECT_EQ(plan.stimulus.recording.rows, 3U);
    const std::string& copy = plan.stimulus.recording.played_text;
    EXPECT_THAT(copy, HasSubstr("16:52:12,50.03\n"));
    EXPECT_THAT(copy, Not(HasSubstr("broken")));
    EXPECT_THAT(copy, Not(HasSubstr("16:52:00,0")));
    EXPECT_THAT(copy, Not(HasSubstr("16:52:13")));
    expect_same(again(plan), plan);
  }
}

TEST_F(RecordingCopy, HasNoDigestOfTheFile) {
  const Plan plan = plan_of("t,f\n0,50\n1,50\n2,50\n", "time = \"t\"\nfrequency = \"f\"\n");
  EXPECT_EQ(plan.stimulus.recording.sha256, sha256("t,f\n0,50\n1,50\n2,50\n"));
  EXPECT_EQ(again(plan).stimulus.recording.sha256, "");
}

TEST_F(RecordingCopy, PlaysARecordingOfTheCommandLineByItsOptions) {
  Overrides overrides;
  overrides.trace_path = folder_.file("other.csv");
  overrides.trace_format = {"Zeit, \"lokal\"", "f", "u", 231.5, "2", "15"};
  folder_.write("other.csv",
                "\"Zeit, \"\"lokal\"\"\",f,u\n0,x,y\n5,50,230\n8,49.9,231\n14,49.8,230\n40,1,1\n");
  const Plan plan = parse_profile(kLossesInPlace, "test.toml", overrides);
  EXPECT_EQ(plan.grid_text, "") << "the grid is part of the profile";
  Overrides recorded;
  recorded.trace_path = "other.csv";
  recorded.trace_format = trace_format(trace_options(overrides.trace_format));
  expect_same(parse_profile(kLossesInPlace, kElsewhere, recorded, copies_of(plan)), plan);
}

}  // namespace
}  // namespace gsbench::profile::test
