// A store that is written while a run proceeds: in a file and in memory.
#include "sample_run.hpp"
#include <test_support/temporary_folder.hpp>

#include <memory>

#include <gmock/gmock.h>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

using ::testing::ElementsAre;

// The reports of an outlet in pieces of `count` and what is left.
std::vector<Reports> in_pieces(const OutletRecord& outlet, std::size_t count) {
  std::vector<Reports> pieces;
  const MeasurementTrace& trace = outlet.reports.trace;
  for (std::size_t from = 0; from < trace.tick.size(); from += count) {
    const std::size_t to = std::min(from + count, trace.tick.size());
    Reports& piece = pieces.emplace_back();
    for (std::size_t i = from; i < to; ++i) {
      append(trace, i, piece.trace);
    }
    pieces.emplace_back();  // an append in which nothing has come
  }
  pieces.back().marks = outlet.reports.marks;
  pieces.back().estimates = outlet.reports.estimates;
  pieces.front().sent = outlet.reports.sent;
  return pieces;
}

OutletRecord without_reports(OutletRecord outlet) {
  outlet.reports = {};
  return outlet;
}

OutletRecord whole(Store& store, std::size_t i) {
  OutletRecord outlet = store.outlet(i);
  outlet.reports = {};
  store.read_reports(i, [&](const Reports& piece) { outlet.reports.append(piece); });
  return outlet;
}

class ProceedingStore : public ::testing::TestWithParam<bool> {
 protected:
  ProceedingStore() {
    if (GetParam()) {
      store_ = std::make_unique<Writer>(path_);
    } else {
      store_ = std::make_unique<MemoryStore>();
    }
  }

  const test::TemporaryFolder folder_;
  const std::string path_ = folder_.file("run.sqlite");
  std::unique_ptr<Store> store_;
};

TEST_P(ProceedingStore, HasAllThatWasAppendedInOrder) {
  RunRecord run = sample::loss_500mw(2);
  store_->begin(run);
  for (const OutletRecord& outlet : run.outlets) {
    store_->add_outlet(without_reports(outlet));
  }
  const std::vector<Reports> first = in_pieces(run.outlets[0], 50);
  const std::vector<Reports> second = in_pieces(run.outlets[1], 50);
  for (std::size_t i = 0; i < first.size(); ++i) {
    store_->append({first[i], second[i]});
  }
  RunRecord stored = run;
  stored.outlets = {whole(*store_, 0), whole(*store_, 1)};
  EXPECT_EQ(content_digest(stored), content_digest(run));
  store_->finish(run);
}

TEST_P(ProceedingStore, ReplacesResultsAndKeepsReports) {
  const RunRecord run = sample::loss_500mw(1);
  store_->begin(run);
  store_->add_outlet(run.outlets[0]);
  OutletRecord changed = without_reports(run.outlets[0]);
  changed.fault = "stopped reporting";
  changed.measurements.resize(2);
  store_->update_outlet(0, changed);
  const OutletRecord stored = whole(*store_, 0);
  EXPECT_EQ(stored.fault, "stopped reporting");
  EXPECT_EQ(stored.measurements.size(), 2U);
  EXPECT_EQ(stored.reports.trace.tick, run.outlets[0].reports.trace.tick);
  EXPECT_EQ(stored.reports.sent.size(), run.outlets[0].reports.sent.size());
}

INSTANTIATE_TEST_SUITE_P(FileAndMemory, ProceedingStore, ::testing::Bool());

class ProceedingFile : public ::testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const std::string path_ = folder_.file("run.sqlite");
};

TEST_F(ProceedingFile, PlacesWhatAnOutletStampedOnTheTimeOfTheRunOnceItsClockIsKnown) {
  RunRecord run = sample::loss_500mw(1);
  OutletRecord outlet = without_reports(run.outlets[0]);
  outlet.clock.samples_per_tick = 0.0;
  // Samples 1000 … 1400 of a clock that is twice as fast; the run starts at sample 1100.
  Reports reports;
  reports.marks = {{1300, "event", 50.0, "", true}, {90, "command", 0.0, "", false}};
  reports.trace.tick = {1000, 1100, 1200, 1400};
  reports.trace.frequency_hz = {49.0F, 50.0F, 51.0F, 52.0F};
  reports.trace.rocof_hz_s = reports.trace.voltage_pu = reports.trace.frequency_hz;
  reports.trace.validity = {1, 1, 1, 1};
  Writer writer(path_);
  writer.begin(run);
  writer.add_outlet(outlet);
  writer.append({reports});
  const auto read = [&] { return read_run(path_).outlets.at(0).reports; };
  EXPECT_TRUE(read().trace.tick.empty());
  ASSERT_EQ(read().marks.size(), 1U);
  EXPECT_EQ(read().marks[0].kind, "command");
  outlet.clock.samples_per_tick = 2.0;
  outlet.clock.sample_at_zero = 1100.0;
  writer.update_outlet(0, outlet);
  EXPECT_THAT(read().trace.tick, ElementsAre(0, 50, 150));
  EXPECT_THAT(read().trace.frequency_hz, ElementsAre(50.0F, 51.0F, 52.0F));
  ASSERT_EQ(read().marks.size(), 2U);
  EXPECT_EQ(read().marks[1].tick, 100);
  // What the outlet stamped after the run is not of the run.
  outlet.clock.sample_at_zero = 1300.0 - 2.0 * static_cast<double>(run.duration_ticks);
  writer.update_outlet(0, outlet);
  EXPECT_THAT(read().trace.frequency_hz, ElementsAre(49.0F, 50.0F, 51.0F));
}

TEST_F(ProceedingFile, WithoutItsRunIsInterrupted) {
  const Writer writer(path_);
  const RunRecord head = Reader(path_).head();
  EXPECT_TRUE(head.interrupted);
  EXPECT_EQ(head.verdict, Verdict::kError);
  EXPECT_THAT(head.verdict_reason, testing::HasSubstr("holds no run"));
}

// The disk may be full when some outlets have been judged.
TEST_F(ProceedingFile, OfARunThatWasNotJudgedHasNoMeasurements) {
  RunRecord run = sample::loss_500mw(2);
  Writer writer(path_);
  writer.begin(run);
  writer.add_outlet(run.outlets[0]);
  writer.add_outlet(without_reports(run.outlets[1]));
  ASSERT_FALSE(run.outlets[0].measurements.empty());
  run.fault = "no space left on the device";
  run.verdict = Verdict::kError;
  writer.abandon(run);
  for (const OutletRecord& outlet : read_run(path_).outlets) {
    EXPECT_TRUE(outlet.measurements.empty());
    EXPECT_EQ(outlet.verdict, Verdict::kError);
  }
}

TEST_F(ProceedingFile, IsReadWithoutReportsOutletByOutlet) {
  const RunRecord run = sample::loss_500mw(3);
  sample::write(path_, run);
  Reader reader(path_);
  EXPECT_EQ(reader.head().run_id, run.run_id);
  ASSERT_EQ(reader.outlets(), 3U);
  const OutletRecord results = reader.results(1);
  EXPECT_EQ(results.id, run.outlets[1].id);
  EXPECT_EQ(results.measurements.size(), run.outlets[1].measurements.size());
  EXPECT_TRUE(results.reports.empty());
  EXPECT_EQ(reader.outlet(1).reports.trace.tick, run.outlets[1].reports.trace.tick);
}

}  // namespace
}  // namespace gsbench::record
