#include "sample_run.hpp"
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
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

template <class Action>
std::string store_error(Action&& action) {
  try {
    action();
  } catch (const StoreError& error) {
    return error.what();
  }
  return "no StoreError";
}

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

TEST(Store, ReadsBackWhatWasWritten) {
  const test::TemporaryFolder folder;
  const RunRecord run = sample::loss_500mw();
  write(folder.file("run.sqlite"), run);
  RunRecord read = read_run(folder.file("run.sqlite"));
  EXPECT_EQ(content_digest(read), content_digest(run));
  EXPECT_EQ(read.run_id, run.run_id);
  EXPECT_EQ(read.started_utc, run.started_utc);
  EXPECT_EQ(read.finished_utc, run.finished_utc);
  EXPECT_EQ(read.seed, 18446744073709551615U);
  ASSERT_EQ(read.outlets.size(), 8U);
  // What the digest takes for equal is compared by hand: a measurement that is not there.
  EXPECT_TRUE(std::isnan(sample::measurement(read.outlets[7], "relay.delay").value));
}

TEST(Store, GivesTheHeadWithoutTheOutlets) {
  const test::TemporaryFolder folder;
  RunRecord run = sample::loss_500mw(2);
  write(folder.file("run.sqlite"), run);
  const RunRecord head = read_head(folder.file("run.sqlite"));
  run.outlets.clear();
  EXPECT_EQ(content_digest(head), content_digest(run));
  EXPECT_EQ(head.run_id, run.run_id);
  Writer(folder.file("begun.sqlite")).begin(run);
  EXPECT_EQ(read_head(folder.file("begun.sqlite")).verdict_reason, "the run did not finish");
}

TEST(Store, KeepsTracesToTheBitIncludingNanAndWildTicks) {
  const test::TemporaryFolder folder;
  RunRecord run = sample::loss_500mw(1);
  MeasurementTrace& trace = run.outlets[0].trace;
  trace.tick[0] = std::numeric_limits<std::int64_t>::min();
  trace.tick[1] = std::numeric_limits<std::int64_t>::max();
  trace.frequency_hz[2] = -std::numeric_limits<float>::quiet_NaN();
  trace.frequency_hz[3] = -0.0F;
  trace.frequency_hz[4] = std::numeric_limits<float>::infinity();
  trace.frequency_hz[5] = std::numeric_limits<float>::denorm_min();
  write(folder.file("run.sqlite"), run);
  const RunRecord read = read_run(folder.file("run.sqlite"));
  const OutletRecord& outlet = read.outlets.at(0);
  EXPECT_EQ(outlet.trace.tick, trace.tick);
  EXPECT_TRUE(same_bits(outlet.trace.frequency_hz, trace.frequency_hz));
  EXPECT_TRUE(same_bits(outlet.trace.rocof_hz_s, trace.rocof_hz_s));
  EXPECT_TRUE(same_bits(outlet.trace.voltage_pu, trace.voltage_pu));
  EXPECT_EQ(outlet.trace.validity, trace.validity);
  EXPECT_TRUE(same_bits(outlet.estimates.loss_mw, run.outlets[0].estimates.loss_mw));
  EXPECT_TRUE(same_bits(read.truth.frequency_hz, run.truth.frequency_hz));
}

TEST(Store, KeepsAnyText) {
  const test::TemporaryFolder folder;
  RunRecord run = sample::loss_500mw(1);
  run.profile_text = std::string("nul ") + '\0' + ", quote ', bytes \xff\xfe, ü";
  run.outlets[0].id = "'; DROP TABLE outlet; --";
  write(folder.file("run.sqlite"), run);
  const RunRecord read = read_run(folder.file("run.sqlite"));
  EXPECT_EQ(read.profile_text, run.profile_text);
  EXPECT_EQ(read.outlets.at(0).id, run.outlets[0].id);
}

TEST(Store, KeepsARunWithoutOutletsAndAnOutletWithoutReports) {
  const test::TemporaryFolder folder;
  RunRecord run;
  write(folder.file("empty.sqlite"), run);
  EXPECT_EQ(content_digest(read_run(folder.file("empty.sqlite"))), content_digest(run));
  run.outlets.emplace_back();
  write(folder.file("silent.sqlite"), run);
  EXPECT_EQ(content_digest(read_run(folder.file("silent.sqlite"))), content_digest(run));
}

TEST(Store, IsOnePlainFileOnceWritten) {
  const test::TemporaryFolder folder;
  write(folder.file("run.sqlite"), sample::loss_500mw(1));
  read_run(folder.file("run.sqlite"));
  EXPECT_THAT(folder.entries(), ::testing::ElementsAre("run.sqlite"));
}

TEST(Store, WritesTheSameBytesForTheSameRecord) {
  const test::TemporaryFolder folder;
  const RunRecord run = sample::loss_500mw(2);
  write(folder.file("a.sqlite"), run);
  write(folder.file("b.sqlite"), run);
  EXPECT_EQ(folder.read("a.sqlite"), folder.read("b.sqlite"));
}

// An hour of one outlet is 225 000 reports of 21 bytes. What noise leaves incompressible are about
// two bytes each of frequency and voltage and three of ROCOF, whose mantissa is noise throughout.
TEST(Store, TakesUnderEightBytesAReport) {
  const test::TemporaryFolder folder;
  const RunRecord run = sample::steady(1, 3600.0);
  write(folder.file("hour.sqlite"), run);
  const double bytes_per_report =
      static_cast<double>(std::filesystem::file_size(folder.file("hour.sqlite"))) /
      static_cast<double>(run.outlets[0].trace.tick.size());
  RecordProperty("bytes_per_report", std::to_string(bytes_per_report));
  EXPECT_LT(bytes_per_report, 8.0);
}

TEST(Store, ReadsAnUnfinishedRunAsErrorWithWhatItHas) {
  const test::TemporaryFolder folder;
  const RunRecord run = sample::loss_500mw(3);
  {
    Writer writer(folder.file("run.sqlite"));
    writer.begin(run);
    writer.add_outlet(run.outlets[0]);
  }
  const RunRecord read = read_run(folder.file("run.sqlite"));
  EXPECT_EQ(read.verdict, Verdict::kError);
  EXPECT_EQ(read.verdict_reason, "the run did not finish");
  EXPECT_EQ(read.profile, run.profile);
  ASSERT_EQ(read.outlets.size(), 1U);
  EXPECT_EQ(read.outlets[0].verdict, Verdict::kPass);
}

TEST(Store, ReadsARunThatWasNeverBegunAsError) {
  const test::TemporaryFolder folder;
  { const Writer writer(folder.file("run.sqlite")); }
  EXPECT_EQ(read_run(folder.file("run.sqlite")).verdict, Verdict::kError);
}

TEST(Store, CanBeReadWhileItIsWritten) {
  const test::TemporaryFolder folder;
  const RunRecord run = sample::loss_500mw(2);
  Writer writer(folder.file("run.sqlite"));
  writer.begin(run);
  writer.add_outlet(run.outlets[0]);
  EXPECT_EQ(read_run(folder.file("run.sqlite")).outlets.size(), 1U);
  writer.add_outlet(run.outlets[1]);
  writer.finish(run);
  EXPECT_EQ(read_run(folder.file("run.sqlite")).verdict, Verdict::kPass);
}

TEST(Store, RefusesAnExistingFileAndLeavesItAlone) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("run.sqlite");
  write(path, sample::loss_500mw(1));
  EXPECT_THAT(store_error([&] { Writer writer(path); }),
              AllOf(StartsWith(path), HasSubstr("File exists")));
  EXPECT_EQ(read_run(path).outlets.size(), 1U);
}

TEST(Store, NamesTheMissingFolder) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("no/such/run.sqlite");
  EXPECT_THAT(store_error([&] { Writer writer(path); }),
              AllOf(StartsWith(path), HasSubstr("No such file or directory")));
  EXPECT_THAT(store_error([&] { read_run(path); }),
              AllOf(StartsWith(path), HasSubstr("No such file or directory")));
}

TEST(Store, RefusesTwoOutletsOfOneName) {
  const test::TemporaryFolder folder;
  const RunRecord run = sample::loss_500mw(1);
  Writer writer(folder.file("run.sqlite"));
  writer.begin(run);
  writer.add_outlet(run.outlets[0]);
  EXPECT_THAT(store_error([&] { writer.add_outlet(run.outlets[0]); }), HasSubstr("outlet.id"));
  writer.finish(run);
  EXPECT_EQ(read_run(folder.file("run.sqlite")).outlets.size(), 1U);
}

TEST(Store, RefusesColumnsOfUnequalLengthAndStaysUsable) {
  const test::TemporaryFolder folder;
  const RunRecord run = sample::loss_500mw(1);
  Writer writer(folder.file("run.sqlite"));
  writer.begin(run);
  OutletRecord uneven = run.outlets[0];
  uneven.trace.rocof_hz_s.pop_back();
  EXPECT_THROW(writer.add_outlet(uneven), std::invalid_argument);
  writer.add_outlet(run.outlets[0]);
  writer.finish(run);
  EXPECT_EQ(read_run(folder.file("run.sqlite")).outlets.size(), 1U);
}

TEST(Store, RefusesCallsOutOfOrder) {
  const test::TemporaryFolder folder;
  const RunRecord run = sample::loss_500mw(1);
  Writer writer(folder.file("run.sqlite"));
  EXPECT_THROW(writer.add_outlet(run.outlets[0]), std::logic_error);
  EXPECT_THROW(writer.finish(run), std::logic_error);
  writer.begin(run);
  EXPECT_THROW(writer.begin(run), std::logic_error);
  writer.finish(run);
  EXPECT_THROW(writer.finish(run), std::logic_error);
}

TEST(Store, SaysThatTheDiskIsFullAndKeepsWhatWasThere) {
  const test::TemporaryFolder folder;
  const test::SmallDisk disk(folder.path(), "size=1m");
  if (!disk.mounted()) GTEST_SKIP() << "mounting a small tmpfs is not allowed here";
  const RunRecord small = sample::loss_500mw(1);
  const RunRecord large = sample::steady(1, 3600.0);
  const std::string path = folder.file("run.sqlite");
  {
    Writer writer(path);
    writer.begin(small);
    writer.add_outlet(small.outlets[0]);
    EXPECT_THAT(store_error([&] { writer.add_outlet(large.outlets[0]); }),
                AllOf(StartsWith(path), HasSubstr("o space left on")));
  }
  const RunRecord read = read_run(path);
  ASSERT_EQ(read.outlets.size(), 1U);
  EXPECT_EQ(read.outlets[0].id, small.outlets[0].id);
}

}  // namespace
}  // namespace gsbench::record
