// Reports that are read in pieces: what is rendered is that of the whole.
#include "sample_run.hpp"
#include "thinning.hpp"

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::MeasurementTrace;
using record::RunRecord;
using ::testing::Contains;

// Estimates come one piece after the reports of their ticks, as over a link they may.
View in_pieces(const RunRecord& run, std::size_t length) {
  View view = run;
  view.read_reports = [&run, length](std::size_t index, const record::TakeReports& take) {
    const record::OutletRecord& outlet = run.outlets[index];
    const MeasurementTrace& trace = outlet.reports.trace;
    std::size_t estimate = 0;
    std::int64_t before_tick = -1;
    for (std::size_t from = 0; from < trace.tick.size() + length; from += length) {
      record::Reports piece;
      for (std::size_t i = from; i < std::min(from + length, trace.tick.size()); ++i) {
        record::append(trace, i, piece.trace);
      }
      while (estimate < outlet.reports.estimates.tick.size() &&
             outlet.reports.estimates.tick[estimate] <= before_tick) {
        record::append(outlet.reports.estimates, estimate++, piece.estimates);
      }
      before_tick = piece.trace.tick.empty() ? before_tick : piece.trace.tick.back();
      take(piece);
    }
    EXPECT_EQ(estimate, outlet.reports.estimates.tick.size());
  };
  return view;
}

TEST(InPieces, EachFormatIsThatOfTheWhole) {
  RunRecord run = sample::loss_500mw(2);
  for (const bool interrupted : {false, true}) {
    run.interrupted = interrupted;
    for (const std::size_t length : {1U, 7U, 100U}) {
      const View view = in_pieces(run, length);
      EXPECT_EQ(csv(view), csv(run));
      EXPECT_EQ(json(view), json(run));
      EXPECT_EQ(html(view), html(run));
      EXPECT_EQ(terminal(view), terminal(run));
    }
  }
}

class ThinnedInPieces : public ::testing::Test {
 protected:
  static constexpr std::int64_t kReport_ticks = 128;

  MeasurementTrace thinned_trace(std::size_t reports) const {
    const std::vector<Stretch> whole = {{kReport_ticks * 500, kReport_ticks * 900}};
    TraceThinning<MeasurementTrace> thinning(kReport_ticks * static_cast<std::int64_t>(reports),
                                             whole, &MeasurementTrace::frequency_hz,
                                             &MeasurementTrace::rocof_hz_s);
    for (std::size_t from = 0; from < reports; from += 500) {
      MeasurementTrace piece;
      for (std::size_t i = from; i < from + 500; ++i) {
        const bool spike = i % 60'000 == 7'777;
        sample::add_report(piece, kReport_ticks * static_cast<std::int64_t>(i),
                           spike ? 47.5 + 1e-6 * static_cast<double>(i) : 50.0,
                           i == 70'000 ? -3.0 : 0.0, 1.0, i != 222'222);
        if (i == 222'222) {
          piece.frequency_hz.back() = std::numeric_limits<float>::quiet_NaN();
        }
      }
      thinning.add(piece);
    }
    EXPECT_EQ(thinning.entries(), reports);
    return thinning.take();
  }
};

TEST_F(ThinnedInPieces, KeepsAllOfHalfAnHour) {
  EXPECT_EQ(thinned_trace(112'500).tick.size(), 112'500U);
}

TEST_F(ThinnedInPieces, KeepsSpikesGapsEndsAndMarksOfAnyLengthInBoundedMemory) {
  for (const std::size_t reports : {std::size_t{240'000}, std::size_t{1'200'000}}) {
    const MeasurementTrace kept = thinned_trace(reports);
    EXPECT_LE(kept.tick.size(), 120'000U);
    EXPECT_GE(kept.tick.size(), 200U);
    EXPECT_TRUE(std::is_sorted(kept.tick.begin(), kept.tick.end()));
    for (std::size_t i = 7'777; i < reports; i += 60'000) {
      EXPECT_THAT(kept.tick, Contains(kReport_ticks * static_cast<std::int64_t>(i)));
    }
    EXPECT_THAT(kept.rocof_hz_s, Contains(-3.0F));
    EXPECT_THAT(kept.tick, Contains(kReport_ticks * 222'222));
    EXPECT_EQ(kept.tick.front(), 0);
    EXPECT_EQ(kept.tick.back(), kReport_ticks * static_cast<std::int64_t>(reports - 1));
    for (std::int64_t i = 500; i <= 900; ++i) {
      EXPECT_THAT(kept.tick, Contains(kReport_ticks * i));
    }
  }
}

}  // namespace
}  // namespace gsbench::render
