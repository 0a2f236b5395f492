#include "sample_run.hpp"
#include <test_support/refusal.hpp>
#include <test_support/small_disk.hpp>
#include <test_support/temporary_folder.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>

#include <gmock/gmock.h>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

using sample::write;
using test::refusal_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

class StoredRun : public ::testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const std::string path_ = folder_.file("run.sqlite");
};

TEST_F(StoredRun, ReadsBackWhatWasWritten) {
  const RunRecord run = sample::loss_500mw();
  write(path_, run);
  RunRecord read = read_run(path_);
  EXPECT_EQ(content_digest(read), content_digest(run));
  EXPECT_EQ(read.run_id, run.run_id);
  EXPECT_EQ(read.started_utc, run.started_utc);
  EXPECT_EQ(read.finished_utc, run.finished_utc);
  EXPECT_EQ(read.seed, 18446744073709551615U);
  ASSERT_EQ(read.outlets.size(), 8U);
  // The digest treats NaNs as equal; a missing value must be read as NaN.
  EXPECT_TRUE(std::isnan(sample::measurement(read.outlets[7], "relay.delay").value));
}

TEST_F(StoredRun, ReadsTheHeadWithoutTheOutlets) {
  RunRecord run = sample::loss_500mw(2);
  write(path_, run);
  const RunRecord head = read_head(path_);
  run.outlets.clear();
  EXPECT_EQ(content_digest(head), content_digest(run));
  EXPECT_EQ(head.run_id, run.run_id);
  Writer(folder_.file("begun.sqlite")).begin(run);
  EXPECT_TRUE(read_head(folder_.file("begun.sqlite")).interrupted);
}

TEST_F(StoredRun, KeepsEveryBitOfTracesWithNanAndExtremeTicks) {
  RunRecord run = sample::loss_500mw(1);
  MeasurementTrace& trace = run.outlets[0].reports.trace;
  trace.tick[0] = std::numeric_limits<std::int64_t>::min();
  trace.tick[1] = std::numeric_limits<std::int64_t>::max();
  trace.frequency_hz[2] = -std::numeric_limits<float>::quiet_NaN();
  trace.frequency_hz[3] = -0.0F;
  trace.frequency_hz[4] = std::numeric_limits<float>::infinity();
  trace.frequency_hz[5] = std::numeric_limits<float>::denorm_min();
  write(path_, run);
  const RunRecord read = read_run(path_);
  const OutletRecord& outlet = read.outlets.at(0);
  EXPECT_EQ(outlet.reports.trace.tick, trace.tick);
  EXPECT_TRUE(same_bits(outlet.reports.trace.frequency_hz, trace.frequency_hz));
  EXPECT_TRUE(same_bits(outlet.reports.trace.rocof_hz_s, trace.rocof_hz_s));
  EXPECT_TRUE(same_bits(outlet.reports.trace.voltage_pu, trace.voltage_pu));
  EXPECT_EQ(outlet.reports.trace.validity, trace.validity);
  EXPECT_TRUE(
      same_bits(outlet.reports.estimates.loss_mw, run.outlets[0].reports.estimates.loss_mw));
  EXPECT_TRUE(same_bits(read.reference.frequency_hz, run.reference.frequency_hz));
}

TEST_F(StoredRun, KeepsAnyText) {
  RunRecord run = sample::loss_500mw(1);
  run.profile_text = std::string("nul ") + '\0' + ", quote ', bytes \xff\xfe, ü";
  run.outlets[0].id = "'; DROP TABLE outlet; --";
  write(path_, run);
  const RunRecord read = read_run(path_);
  EXPECT_EQ(read.profile_text, run.profile_text);
  EXPECT_EQ(read.outlets.at(0).id, run.outlets[0].id);
}

TEST_F(StoredRun, KeepsARunWithoutOutletsAndAnOutletWithoutReports) {
  RunRecord run;
  write(folder_.file("empty.sqlite"), run);
  EXPECT_EQ(content_digest(read_run(folder_.file("empty.sqlite"))), content_digest(run));
  run.outlets.emplace_back();
  write(folder_.file("silent.sqlite"), run);
  EXPECT_EQ(content_digest(read_run(folder_.file("silent.sqlite"))), content_digest(run));
}

TEST_F(StoredRun, IsOnePlainFileOnceWritten) {
  write(path_, sample::loss_500mw(1));
  read_run(path_);
  EXPECT_THAT(folder_.entries(), ::testing::ElementsAre("run.sqlite"));
}

TEST_F(StoredRun, WritesTheSameBytesForTheSameRecord) {
  const RunRecord run = sample::loss_500mw(2);
  write(folder_.file("a.sqlite"), run);
  write(folder_.file("b.sqlite"), run);
  EXPECT_EQ(folder_.read("a.sqlite"), folder_.read("b.sqlite"));
}

// An hour of one outlet is 225 000 reports of 21 bytes. Noise makes about two bytes each of
// frequency and voltage incompressible, and three of ROCOF.
TEST_F(StoredRun, TakesLessThanEightBytesPerReport) {
  const RunRecord run = sample::steady(1, 3600.0);
  write(folder_.file("hour.sqlite"), run);
  const double bytes_per_report =
      static_cast<double>(std::filesystem::file_size(folder_.file("hour.sqlite"))) /
      static_cast<double>(run.outlets[0].reports.trace.tick.size());
  RecordProperty("bytes_per_report", std::to_string(bytes_per_report));
  EXPECT_LT(bytes_per_report, 8.0);
}

TEST_F(StoredRun, ReadsAnUnfinishedRunAsErrorWithItsOutletsSoFar) {
  const RunRecord run = sample::loss_500mw(3);
  {
    Writer writer(path_);
    writer.begin(run);
    writer.add_outlet(run.outlets[0]);
  }
  const RunRecord read = read_run(path_);
  EXPECT_EQ(read.verdict, Verdict::kError);
  EXPECT_TRUE(read.interrupted);
  EXPECT_EQ(read.profile, run.profile);
  ASSERT_EQ(read.outlets.size(), 1U);
  EXPECT_EQ(read.outlets[0].verdict, Verdict::kError);
  EXPECT_EQ(read.outlets[0].reports.trace.tick, run.outlets[0].reports.trace.tick);
}

TEST_F(StoredRun, ReadsARecordWithoutBeginAsError) {
  { const Writer writer(path_); }
  EXPECT_EQ(read_run(path_).verdict, Verdict::kError);
}

TEST_F(StoredRun, CanBeReadWhileItIsWritten) {
  const RunRecord run = sample::loss_500mw(2);
  Writer writer(path_);
  writer.begin(run);
  writer.add_outlet(run.outlets[0]);
  EXPECT_EQ(read_run(path_).outlets.size(), 1U);
  writer.add_outlet(run.outlets[1]);
  writer.finish(run);
  EXPECT_EQ(read_run(path_).verdict, Verdict::kPass);
}

TEST_F(StoredRun, RefusesAnExistingFileAndDoesNotChangeIt) {
  write(path_, sample::loss_500mw(1));
  EXPECT_THAT(refusal_of<StoreError>([&] { Writer writer(path_); }),
              AllOf(StartsWith(path_), HasSubstr("File exists")));
  EXPECT_EQ(read_run(path_).outlets.size(), 1U);
}

TEST_F(StoredRun, NamesTheMissingFolder) {
  const std::string path = folder_.file("no/such/run.sqlite");
  const auto says = AllOf(StartsWith(path), HasSubstr("No such file or directory"));
  EXPECT_THAT(refusal_of<StoreError>([&] { Writer writer(path); }), says);
  EXPECT_THAT(refusal_of<StoreError>([&] { read_run(path); }), says);
}

TEST_F(StoredRun, RefusesTwoOutletsWithTheSameId) {
  const RunRecord run = sample::loss_500mw(1);
  Writer writer(path_);
  writer.begin(run);
  writer.add_outlet(run.outlets[0]);
  EXPECT_THAT(refusal_of<StoreError>([&] { writer.add_outlet(run.outlets[0]); }),
              HasSubstr("outlet.id"));
  writer.finish(run);
  EXPECT_EQ(read_run(path_).outlets.size(), 1U);
}

TEST_F(StoredRun, RefusesColumnsOfUnequalLengthAndRemainsUsable) {
  const RunRecord run = sample::loss_500mw(1);
  Writer writer(path_);
  writer.begin(run);
  OutletRecord uneven = run.outlets[0];
  uneven.reports.trace.rocof_hz_s.pop_back();
  EXPECT_THROW(writer.add_outlet(uneven), std::invalid_argument);
  writer.add_outlet(run.outlets[0]);
  writer.finish(run);
  EXPECT_EQ(read_run(path_).outlets.size(), 1U);
}

TEST_F(StoredRun, RefusesCallsOutOfOrder) {
  const RunRecord run = sample::loss_500mw(1);
  Writer writer(path_);
  EXPECT_THROW(writer.add_outlet(run.outlets[0]), std::logic_error);
  EXPECT_THROW(writer.finish(run), std::logic_error);
  writer.begin(run);
  EXPECT_THROW(writer.begin(run), std::logic_error);
  writer.finish(run);
  EXPECT_THROW(writer.finish(run), std::logic_error);
}

TEST_F(StoredRun, KeepsItsReserveForAFullDiskWhileItIsReadAndWritten) {
  Writer writer(path_);
  writer.begin(sample::loss_500mw(0));
  EXPECT_EQ(read_head(path_).seed, sample::loss_500mw(0).seed);
  EXPECT_TRUE(std::filesystem::exists(path_ + "-reserve"));
}

TEST_F(StoredRun, ReportsAFullDiskAndKeepsEarlierOutlets) {
  const test::SmallDisk disk(folder_.path(), "size=1m");
  if (!disk.mounted()) {
    GTEST_SKIP() << "mounting a small tmpfs is not allowed here";
  }
  const RunRecord small = sample::loss_500mw(1);
  const RunRecord large = sample::steady(1, 3600.0);
  {
    Writer writer(path_);
    writer.begin(small);
    writer.add_outlet(small.outlets[0]);
    EXPECT_THAT(refusal_of<StoreError>([&] { writer.add_outlet(large.outlets[0]); }),
                AllOf(StartsWith("run.sqlite: "), HasSubstr("o space left on")));
  }
  const RunRecord read = read_run(path_);
  ASSERT_EQ(read.outlets.size(), 1U);
  EXPECT_EQ(read.outlets[0].id, small.outlets[0].id);
}

}  // namespace
}  // namespace gsbench::record
