// Records of earlier versions stay readable. A record of each version is kept in records/.
#include "read_parts.hpp"
#include <test_support/temporary_folder.hpp>

#include <filesystem>

#include <gmock/gmock.h>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

using ::testing::StartsWith;

std::string kept_record(const char* name) {
  return (std::filesystem::path(GSBENCH_TEST_RECORDS) / name).string();
}

std::string record_of_version_6() {
  return kept_record("version-6.sqlite");
}

// As a gsbench reads it for which `newest` is the version of its own records.
RunRecord read_by(std::int64_t newest, const std::string& path) {
  Database database(path, Database::Mode::kRead);
  const StoredFields stored(database, newest);
  bool complete = false;
  RunRecord run = read_head(database, stored, complete);
  run.interrupted = !complete;
  run.outlets.push_back(read_results(database, stored, 1));
  read_reports(database, stored, 1,
               [&](const Reports& piece) { run.outlets.back().reports.append(piece); });
  return run;
}

double value_of(const OutletRecord& outlet, const char* measure) {
  const MeasurementResult* result = find_measurement(outlet, measure);
  return result != nullptr ? result->value : -1.0;
}

TEST(RecordOfVersion6, HasItsVerdictsFiguresAndTraces) {
  const RunRecord run = read_run(record_of_version_6());
  EXPECT_EQ(run.run_id, "20261130T175057Z-65b204c6");
  EXPECT_EQ(run.verdict, Verdict::kFail);
  EXPECT_EQ(run.verdict_reason, "1 of 2 outlets did not pass");
  EXPECT_FALSE(run.interrupted);
  EXPECT_EQ(run.stimulus.at(0).text, "500 MW lost");
  ASSERT_EQ(run.outlets.size(), 2U);
  const OutletRecord& outlet = run.outlets[0];
  EXPECT_EQ(outlet.verdict, Verdict::kFail);
  EXPECT_EQ(outlet.settings.size(), 58U);
  EXPECT_EQ(value_of(outlet, "event.delay"), 104.0);
  EXPECT_EQ(value_of(outlet, "decision.delay"), 728.0);
  // A report every 16 ms.
  ASSERT_EQ(outlet.reports.trace.tick.size(), 187U);
  EXPECT_EQ(outlet.reports.trace.tick.front(), 128);
  EXPECT_EQ(outlet.reports.trace.tick.back(), 23936);
  EXPECT_EQ(outlet.reports.marks.front().kind, "event");
  EXPECT_EQ(outlet.reports.marks.front().tick, 8832);
  // What it does not have takes its default.
  EXPECT_EQ(outlet.board, "");
  EXPECT_TRUE(outlet.clock.counts_ticks());
  EXPECT_TRUE(outlet.reports.sent.empty());
}

TEST(RecordOfVersion6, HasTheInstantOfTheLossOnTheTimeOfTheRun) {
  const EstimateTrace estimates = read_run(record_of_version_6()).outlets.at(0).reports.estimates;
  ASSERT_FALSE(estimates.tick.empty());
  const std::size_t last = estimates.tick.size() - 1;
  EXPECT_NEAR(loss_instant_s(estimates, last, 8000.0), 1.0, 0.2);
}

TEST(RecordOfVersion6, IsRefusedIfItWasChanged) {
  const test::TemporaryFolder folder;
  const std::string changed = folder.file("changed.sqlite");
  std::filesystem::copy_file(record_of_version_6(), changed);
  std::string bytes = folder.read("changed.sqlite");
  const std::size_t at = bytes.find("500 MW lost");
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, 3, "900");
  folder.write("changed.sqlite", bytes);
  EXPECT_THROW(read_run(changed), StoreError);
}

class RecordOfVersion7 : public ::testing::TestWithParam<std::int64_t> {};

// Without an event, the columns of estimates are empty.
TEST_P(RecordOfVersion7, OfAQuietRunHasItsVerdictAndTraces) {
  const RunRecord run = read_by(GetParam(), kept_record("version-7-quiet.sqlite"));
  EXPECT_EQ(run.run_id, "20261130T213818Z-f24b16d3");
  EXPECT_FALSE(run.interrupted);
  EXPECT_EQ(run.verdict, Verdict::kPass);
  const OutletRecord& outlet = run.outlets.at(0);
  EXPECT_EQ(value_of(outlet, "event.count"), 0.0);
  EXPECT_EQ(outlet.settings.size(), 58U);
  ASSERT_EQ(outlet.reports.trace.tick.size(), 31U);
  EXPECT_EQ(outlet.reports.trace.tick.back(), 3968);
  EXPECT_NEAR(outlet.reports.trace.frequency_hz.back(), 50.0, 0.001);
  EXPECT_TRUE(outlet.reports.estimates.tick.empty());
}

// Five appends, of which only some have an event or an estimate.
TEST_P(RecordOfVersion7, OfAKilledRunHasWhatWasKept) {
  const RunRecord run = read_by(GetParam(), kept_record("version-7-killed.sqlite"));
  EXPECT_EQ(run.run_id, "20261130T213808Z-e09093be");
  EXPECT_TRUE(run.interrupted);
  const OutletRecord& outlet = run.outlets.at(0);
  EXPECT_TRUE(outlet.measurements.empty());
  EXPECT_EQ(outlet.reports.trace.tick.size(), 160U);
  EXPECT_EQ(outlet.reports.trace.tick.back(), 20480);
  ASSERT_EQ(outlet.reports.marks.size(), 11U);
  EXPECT_EQ(outlet.reports.marks.front().tick, 5888);
  EXPECT_EQ(outlet.reports.marks.back().kind, "relay.sense");
  EXPECT_FALSE(outlet.reports.estimates.tick.empty());
}

INSTANTIATE_TEST_SUITE_P(ReadNowAndByTheNextVersion, RecordOfVersion7,
                         ::testing::Values(kSchemaVersion, kSchemaVersion + 1));

TEST(KilledRunOfVersion7, IsInterrupted) {
  const RunRecord run = read_run(kept_record("version-7-killed.sqlite"));
  EXPECT_TRUE(run.interrupted);
  EXPECT_EQ(run.verdict, Verdict::kError);
  EXPECT_THAT(run.verdict_reason, StartsWith("interrupted"));
}

}  // namespace
}  // namespace gsbench::record
