// The page of several profiles says how many of them are done.
#include <test_support/ieee24.hpp>

#include <atomic>
#include <string>

#include <gmock/gmock.h>

#include <fleet/closed_loop.hpp>
#include <fleet/page.hpp>

namespace gsbench::fleet {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::SizeIs;

// Two losses, stopped when more than `part` of the work is done.
record::Page page_stopped_after(double part) {
  Study study;
  study.scenario.duration_s = 1.0;
  study.fleet.groups = 10;
  study.fleet.per_group = 1;
  study.fleet.least_w = 1e6;
  study.fleet.most_w = 1.8e7;
  std::atomic<bool> stop{part <= 0.0};
  campaign::Execution execution;
  execution.threads = 2;
  execution.stop = &stop;
  execution.progress = [&](double done) { stop = stop || done > part; };
  return make_scenarios_page({plan_of_loss(test::ieee24(), 100.0, 0.1, 1.0, 1),
                              plan_of_loss(test::ieee24(), 120.0, 0.1, 1.0, 1)},
                             study, execution);
}

TEST(ScenariosPage, AStoppedOneSaysHowManyProfilesAreDone) {
  const record::Page early = page_stopped_after(0.0);
  EXPECT_FALSE(early.judgement.value().passed.has_value());
  EXPECT_THAT(early.judgement.value().reasons, ElementsAre("stopped after 0 of 2 profiles"));
  EXPECT_THAT(early.facts, Contains(Pair("stopped", HasSubstr("after 0 of 2 profiles"))));
  EXPECT_THAT(early.sections.at(0).tables.at(0).rows, SizeIs(0));
  EXPECT_THAT(early.sections.at(0).paragraphs, Contains("By gsbench, no profile is judged."));

  const record::Page late = page_stopped_after(0.6);
  EXPECT_THAT(late.judgement.value().reasons, ElementsAre("stopped after 1 of 2 profiles"));
  EXPECT_THAT(late.sections.at(0).tables.at(0).rows, SizeIs(1));
  EXPECT_THAT(late.sections.at(0).paragraphs, Contains("By gsbench, 1 of 1 profiles pass."));
}

}  // namespace
}  // namespace gsbench::fleet
