// Which outlets a report shows if it cannot show all.
#include "sample_run.hpp"

#include <gmock/gmock.h>

#include <render/view.hpp>

namespace gsbench::render {
namespace {

using record::RunRecord;
using record::Verdict;
using ::testing::ElementsAre;

RunRecord bare_outlets(std::size_t count) {
  RunRecord run;
  run.outlets.resize(count);
  return run;
}

void miss(record::OutletRecord& outlet, std::size_t measurements) {
  outlet.verdict = Verdict::kFail;
  outlet.measurements.resize(measurements);
  for (record::MeasurementResult& result : outlet.measurements) {
    result.judged = true;
    result.verdict = Verdict::kFail;
  }
}

TEST(WorstFirst, KeepsTheOrderIfAllAreShown) {
  RunRecord run = bare_outlets(3);
  run.outlets[2].verdict = Verdict::kError;
  EXPECT_THAT(worst_first(run, 3), ElementsAre(0, 1, 2));
  EXPECT_THAT(worst_first(run, 2), ElementsAre(2, 0));
  EXPECT_THAT(worst_first(run, 0), ElementsAre());
}

TEST(WorstFirst, OrdersByVerdictThenByWhatDidNotPass) {
  RunRecord run = bare_outlets(7);
  miss(run.outlets[1], 1);
  miss(run.outlets[2], 3);
  run.outlets[3].verdict = Verdict::kInconclusive;
  run.outlets[4].verdict = Verdict::kError;
  miss(run.outlets[5], 3);
  EXPECT_THAT(worst_first(run, 6), ElementsAre(4, 2, 5, 1, 3, 0));
}

TEST(WorstFirst, IgnoresMeasurementsWithoutALimit) {
  RunRecord run = bare_outlets(2);
  miss(run.outlets[0], 1);
  miss(run.outlets[1], 2);
  run.outlets[1].measurements[0].judged = run.outlets[1].measurements[1].judged = false;
  EXPECT_THAT(worst_first(run, 1), ElementsAre(0));
}

TEST(WorstFirst, ChoosesAmongTheFailingOnesIfAllFail) {
  RunRecord run = bare_outlets(30);
  for (record::OutletRecord& outlet : run.outlets) {
    miss(outlet, 1);
  }
  miss(run.outlets[25], 2);
  EXPECT_THAT(worst_first(run, 3), ElementsAre(25, 0, 1));
}

TEST(WorstFirst, TakesEquallyBadOutletsFromEachGroupInTurn) {
  RunRecord run = bare_outlets(6);
  for (std::size_t i = 0; i < 6; ++i) {
    run.outlets[i].group = i < 4 ? "stays" : "sheds";
  }
  EXPECT_THAT(worst_first(run, 5), ElementsAre(0, 4, 1, 5, 2));
}

TEST(WorstFirst, TakesOnlyOutletsThatAreShown) {
  RunRecord run = bare_outlets(4);
  run.outlets[0].verdict = Verdict::kError;
  View view = run;
  view.outlets = {3, 2, 1};
  EXPECT_THAT(worst_first(view, 2), ElementsAre(3, 2));
  run.outlets[1].verdict = Verdict::kFail;
  EXPECT_THAT(worst_first(view, 2), ElementsAre(1, 3));
}

}  // namespace
}  // namespace gsbench::render
