// A run is judged again from its record alone.
#include "gsbench_process.hpp"
#include <sqlite3.h>
#include <test_support/temporary_folder.hpp>

#include <filesystem>

#include <gmock/gmock.h>

#include <record/store.hpp>

namespace gsbench::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kLimit =
    "[[outlet]]\naccumulated_mw = 100.0\n[[expect]]\nmeasure = \"tracker.error.max\"\nunit = "
    "\"mHz\"\n"
    "max = 500.0\n";

std::string recording() {
  std::string rows = "t,f\n";
  for (int i = 0; i < 40; ++i) {
    rows += std::to_string(0.1 * i) + "," + std::to_string(50.0 - 0.01 * i) + "\n";
  }
  return rows;
}

// Judged as recorded, with the exit code of `verdict`.
void expect_as_recorded(const std::string& run, const char* verdict = "PASS") {
  const Outcome outcome = run_gsbench({"rejudge", run, "--json"});
  EXPECT_EQ(outcome.exit_code, std::string(verdict) == "PASS" ? 0 : 1) << outcome.err;
  const json again = json::parse(outcome.out);
  EXPECT_EQ(again["format_version"], record::kFormatVersion);
  EXPECT_EQ(again["verdict"], verdict);
  EXPECT_EQ(again["recorded_verdict"], verdict);
  EXPECT_EQ(again["differences"], json::array());
  EXPECT_EQ(again["judged"], true);
  EXPECT_FALSE(again["judged_by_version"].get<std::string>().empty());
}

void execute(const std::string& record, const char* sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(record.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK);
  EXPECT_GT(sqlite3_changes(database), 0) << sql;
  sqlite3_close(database);
}

class Rejudge : public testing::Test {
 protected:
  // Runs, and removes all files that it read.
  std::string run_and_remove(const Words& more, int exit_code = 0) {
    Words words = {"run", inputs_.file("profile.toml"), "--out", runs_.path().string()};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run_gsbench(words);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
    for (const std::string& name : inputs_.entries()) {
      std::filesystem::remove(inputs_.file(name));
    }
    return only_run(runs_.path()).string();
  }

  const TemporaryFolder inputs_;
  const TemporaryFolder runs_;
};

TEST_F(Rejudge, NeedsNeitherProfileNorGridNorRecording) {
  inputs_.write("grid.toml",
                text_of(std::filesystem::path(GSBENCH_PROFILES_SOURCE) / "grids/ieee24.toml"));
  inputs_.write("trace.csv", recording());
  inputs_.write(
      "profile.toml",
      std::string("title = \"t\"\nsource = \"s\"\n[grid]\nsystem = \"grid.toml\"\n[signal]\n"
                  "noise_pct = 1.0\n[signal.trace]\nfile = \"trace.csv\"\ntime = \"t\"\n"
                  "frequency = \"f\"\nfrom_s = 0.5\nuntil_s = 2.5\n") +
          kLimit);
  expect_as_recorded(run_and_remove({}));
}

TEST_F(Rejudge, NeedsNoRecordingThatReplacedTheProfilesSignal) {
  inputs_.write("trace.csv", recording());
  inputs_.write("profile.toml",
                std::string("title = \"t\"\nsource = \"s\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
                            "duration_s = 2.0\n") +
                    kLimit);
  expect_as_recorded(
      run_and_remove({"--trace", inputs_.file("trace.csv"), "--trace-time", "t",
                      "--trace-frequency", "f", "--trace-from", "1", "--seed", "7"}));
}

// PMU exporters write the names of columns in ISO 8859-1.
TEST_F(Rejudge, NeedsNoRecordingWithNamesThatAreNotUtf8) {
  inputs_.write("trace.csv",
                "t,f\xe4,u\n,50,230\n0,50,230\n1,\xe4\",230\n2,49.9,230\n3,50,k\xc3\xa4\n");
  inputs_.write("profile.toml",
                std::string("title = \"t\"\nsource = \"s\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
                            "duration_s = 1.0\n") +
                    kLimit);
  expect_as_recorded(run_and_remove({"--trace", inputs_.file("trace.csv"), "--trace-time", "t",
                                     "--trace-frequency", "f\xe4", "--trace-voltage", "u",
                                     "--trace-gaps", "\xe4\",k\xc3\xa4"}));
}

TEST_F(Rejudge, HasTheVerdictsOfARunThatFails) {
  inputs_.write(
      "profile.toml",
      "title = \"t\"\nsource = \"s\"\n[grid]\nsystem = \"ieee24\"\n[[grid.loss]]\nat_s = 0.5\n"
      "power_mw = 500.0\n[signal]\nduration_s = 2.0\n[[outlet]]\naccumulated_mw = 100.0\n"
      "[[expect]]\nmeasure = \"relay.end\"\nequals = \"closed\"\n");
  expect_as_recorded(run_and_remove({}, 1), "FAIL");
}

// Also what the report does not show.
TEST_F(Rejudge, AndReportRefuseARecordThatWasChanged) {
  inputs_.write("profile.toml",
                std::string("title = \"t\"\nsource = \"s\"\n[grid]\nsystem = \"ieee24\"\n"
                            "[[grid.loss]]\nat_s = 1.0\npower_mw = 500.0\n[signal]\n"
                            "duration_s = 3.0\n") +
                    kLimit);
  const std::string record = run_and_remove({}) + "/record.sqlite";
  for (const char* change :
       {"UPDATE mark SET tick = tick + 100 WHERE owner = 1", "DELETE FROM sent",
        "DELETE FROM series WHERE owner = 1 AND name = 'trace.voltage_pu'"}) {
    const std::string changed = inputs_.file("changed.sqlite");
    std::filesystem::copy_file(record, changed, std::filesystem::copy_options::overwrite_existing);
    execute(changed, change);
    for (const char* command : {"report", "rejudge"}) {
      const Outcome outcome = run_gsbench({command, changed});
      EXPECT_EQ(outcome.exit_code, 2) << change;
      EXPECT_THAT(outcome.err, HasSubstr("the record is damaged: ")) << change;
    }
  }
  EXPECT_EQ(run_gsbench({"report", record}).exit_code, 0);
}

// The comparison can fail: a record whose figures are not what the judge makes of its reports.
TEST_F(Rejudge, ShowsWhatIsNotAsRecorded) {
  inputs_.write("profile.toml",
                std::string("title = \"t\"\nsource = \"s\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
                            "duration_s = 1.0\n") +
                    kLimit);
  record::RunRecord run = record::read_run(run_and_remove({}) + "/record.sqlite");
  run.outlets.at(0).measurements.at(0).value = 600.0;
  run.outlets.at(0).measurements.at(0).verdict = record::Verdict::kFail;
  run.outlets.at(0).verdict = record::Verdict::kFail;
  run.verdict = record::Verdict::kFail;
  const std::string other = inputs_.file("other.sqlite");
  {
    record::Writer writer(other);
    writer.begin(run);
    writer.add_outlet(run.outlets.at(0));
    writer.finish(run);
  }
  const json again = run_for_json({"rejudge", other, "--json"});
  EXPECT_EQ(again["recorded_verdict"], "FAIL");
  EXPECT_EQ(again["verdict"], "PASS");
  std::vector<std::string> what;
  for (const json& difference : again["differences"]) {
    what.push_back(difference["what"]);
  }
  EXPECT_THAT(what, ElementsAre("tracker.error.max", "verdict", "verdict"));
  EXPECT_THAT(run_gsbench({"rejudge", other}).out, HasSubstr("600 mHz, FAIL"));
}

// It has no copy of its grid, but the grid of that name is still the same.
TEST_F(Rejudge, TakesARecordOfVersion6) {
  expect_as_recorded(GSBENCH_TEST_RECORDS "/version-6.sqlite", "FAIL");
}

TEST_F(Rejudge, RefusesAGridThatHasChangedSinceVersion6) {
  record::RunRecord run = record::read_run(GSBENCH_TEST_RECORDS "/version-6.sqlite");
  run.grid_sha256.front() = run.grid_sha256.front() == '0' ? '1' : '0';
  const std::string other = inputs_.file("other.sqlite");
  {
    record::Writer writer(other);
    writer.begin(run);
    writer.finish(run);
  }
  expect_refused({"rejudge", other}, "no copy of its grid, which has changed since");
}

TEST_F(Rejudge, OfAnEmulatedStationIsAsRecorded) {
  inputs_.write(
      "profile.toml",
      "title = \"t\"\nsource = \"s\"\n[grid]\nsystem = \"ieee24\"\n[[grid.loss]]\nat_s = 0.5\n"
      "power_mw = 500.0\n[signal]\nduration_s = 2.0\nnoise_pct = 1.0\n"
      "[[outlet]]\naccumulated_mw = 100.0\ncount = 4\n"
      "[[command]]\nat_s = 1.8\nswitch = \"on\"\n"
      "[[expect]]\nmeasure = \"decision.delay\"\nunit = \"ms\"\nmax = 960.0\n");
  expect_as_recorded(run_and_remove({"--station", "emulated"}));
}

}  // namespace
}  // namespace gsbench::test
