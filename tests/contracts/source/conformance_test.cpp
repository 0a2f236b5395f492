// The conformance suite of drivers of instruments (any_instrument.hpp): faults before each call.
#include "any_instrument.hpp"

namespace gsbench::test {
namespace {

using testing::HasSubstr;

INSTANTIATE_TEST_SUITE_P(Of, AnyInstrument,
                         testing::Values(RigCase{"Sdg1032x", &sdg1032x},
                                         RigCase{"Sdg2042x", &sdg2042x},
                                         RigCase{"Dg1062z", &dg1062z}, RigCase{"K33522b", &k33522b},
                                         RigCase{"DacHead", &dac_head},
                                         RigCase{"Sdg2042xOnASerialLine", &serial_sdg2042x}),
                         &name_of);

const char* const kCalls[] = {"prepare", "energise", "hold", "start", "advance", "stop"};

TEST_P(AnyInstrument, PlaysAWholeRunWithTheOutputOnOnlyFromEnergiseToStop) {
  const std::set<std::string> on = {"hold", "start", "advance", "stop"};
  EXPECT_EQ(first_error_of_run(*source_, mains_,
                               [&](const std::string& call) {
                                 EXPECT_EQ(rig_->output_is_on(), on.count(call) > 0) << call;
                               }),
            "");
  expect_off_after_run();
}

TEST_P(AnyInstrument, IsNotUsedIfItIsOfAnotherModel) {
  rig_->become_another_model();
  EXPECT_THAT(first_error_of_run(*source_, mains_), HasSubstr(abilities_.other_model));
  EXPECT_FALSE(make_safe(*source_));
}

TEST_P(AnyInstrument, IsOfUnknownStateWhileUnplugged) {
  for (const char* const call : kCalls) {
    new_rig();
    const std::string error = run_with([&] { rig_->unplug(); }, call);
    EXPECT_TRUE(!error.empty() || !must_fail(call)) << call;
    EXPECT_FALSE(make_safe(*source_)) << call;
    rig_->plug_in();
    EXPECT_TRUE(make_safe(*source_)) << call;
    expect_reachable();
  }
}

TEST_P(AnyInstrument, IsOffOrOfUnknownStateIfAnswersAreMissingOrWrong) {
  for (const Answers answers : {Answers::kNone, Answers::kHalf, Answers::kGarbage}) {
    for (const char* const call : kCalls) {
      new_rig();
      const std::string error = run_with([&] { rig_->set_answers(answers); }, call);
      EXPECT_TRUE(!error.empty() || !must_fail(call))
          << static_cast<int>(answers) << " before " << call;
      make_safe(*source_);
      rig_->set_answers(Answers::kNormal);
      EXPECT_TRUE(make_safe(*source_)) << static_cast<int>(answers) << " before " << call;
      expect_reachable();
    }
  }
}

TEST_P(AnyInstrument, ThatDoesNotAnswerStillObeysToSwitchOff) {
  run_with([&] { rig_->set_answers(Answers::kNone); }, "start");
  EXPECT_FALSE(make_safe(*source_));
  EXPECT_FALSE(rig_->output_is_on());
}

TEST_P(AnyInstrument, MayAnswerSlowly) {
  rig_->set_answers(Answers::kSlow);
  EXPECT_EQ(first_error_of_run(*source_, mains_), "");
  expect_off_after_run();
}

TEST_P(AnyInstrument, ThatAnswersTooLateIsUsableAfterwards) {
  EXPECT_THAT(run_with([&] { rig_->set_answers(Answers::kTooSlow); }, "energise"),
              HasSubstr(abilities_.too_late));
  rig_->set_answers(Answers::kNormal);
  EXPECT_TRUE(make_safe(*source_));
  EXPECT_EQ(first_error_of_run(*source_, mains_), "");
  expect_off_after_run();
}

TEST_P(AnyInstrument, ThatIsResetEndsTheRun) {
  for (const char* const call : {"energise", "hold", "start", "advance"}) {
    new_rig();
    EXPECT_NE(run_with([&] { rig_->reset(std::chrono::milliseconds(0)); }, call), "") << call;
    EXPECT_TRUE(make_safe(*source_)) << call;
    EXPECT_FALSE(rig_->output_is_on()) << call;
    // The next run loads everything again.
    EXPECT_TRUE(source_->prepare(mains_).ok()) << call;
  }
}

TEST_P(AnyInstrument, CanBeMadeSafeWithoutAnyRunTwiceAndWhileItReboots) {
  EXPECT_TRUE(make_safe(*source_));
  EXPECT_TRUE(make_safe(*source_));
  rig_->reset(abilities_.starting_up);
  EXPECT_TRUE(make_safe(*source_));
  rig_->reset(abilities_.starting_up);
  expect_reachable();
}

TEST_P(AnyInstrument, IsOffIfTheBenchStopsTheRunAfterAnyCall) {
  struct Stopped {};
  int calls = 0;
  first_error_of_run(*source_, mains_, [&](const std::string&) { ++calls; });
  EXPECT_GE(calls, 6);
  for (int last = 1; last <= calls; ++last) {
    new_rig();
    int made = 0;
    try {
      first_error_of_run(*source_, mains_, [&](const std::string&) {
        if (made++ == last) {
          throw Stopped();
        }
      });
    } catch (const Stopped&) {
    }
    EXPECT_TRUE(make_safe(*source_)) << last;
    // The same source can begin again.
    EXPECT_TRUE(source_->prepare(mains_).ok()) << last;
  }
}

TEST_P(AnyInstrument, CanBeMadeSafeByAnotherBenchIfTheFirstWasKilled) {
  for (const char* const call : kCalls) {
    new_rig();
    struct Killed {};
    try {
      first_error_of_run(*source_, mains_, [&](const std::string& next) {
        if (next == call) {
          throw Killed();
        }
      });
    } catch (const Killed&) {
    }
    expect_reachable();
  }
}

}  // namespace
}  // namespace gsbench::test
