// The conformance suite of drivers of instruments: whatever happens to the instrument or to the
// connection, the output is off afterwards wherever the bench can reach it. Otherwise the error
// says that its state is unknown.
#include "instrument_rig.hpp"
#include <test_support/mains.hpp>

#include <atomic>
#include <optional>
#include <set>
#include <thread>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

struct Rig {
  const char* name;
  std::unique_ptr<InstrumentRig> (*make)();
};

class AnyInstrument : public testing::TestWithParam<Rig> {
 protected:
  AnyInstrument() { mains_.duration_s = 0.3; }

  void new_rig() {
    source_.reset();
    rig_ = GetParam().make();
    source_ = rig_->make_source();
  }

  // The run fails if `fault` happens before `call`. Returns the error.
  std::string run_with(const std::function<void()>& fault, const std::string& call) {
    bool happened = false;
    std::string error = first_error_of_run(*source_, mains_, [&](const std::string& next) {
      if (next == call && !happened) {
        happened = true;
        fault();
      }
    });
    EXPECT_TRUE(happened) << call << ": " << error;
    return error;
  }

  // Whether it could be made safe. Either way, what the source says is so.
  bool make_safe(source::Source& source) {
    const drivers::Status safe = source.make_safe();
    if (safe.ok()) {
      EXPECT_FALSE(rig_->output_is_on());
    } else {
      EXPECT_THAT(safe.error(), AllOf(HasSubstr("output state unknown"), HasSubstr("by itself")));
    }
    return safe.ok();
  }

  void expect_off_after_run() {
    if (abilities_.stop_asks_and_switches_off) {
      EXPECT_FALSE(rig_->output_is_on());
    }
    EXPECT_TRUE(make_safe(*source_));
  }
  bool must_fail(const std::string& call) const {
    return call != "stop" || abilities_.stop_asks_and_switches_off;
  }

  // As `gsbench safe`: without having prepared anything.
  void expect_reachable() {
    source_.reset();
    EXPECT_TRUE(make_safe(*rig_->make_source()));
    EXPECT_FALSE(rig_->output_is_on());
  }

  // Received in a run from the first call of a name in `calls` to the next one of another name.
  std::size_t commands_of(const std::set<std::string>& calls) {
    std::optional<std::size_t> before;
    std::optional<std::size_t> after;
    EXPECT_EQ(first_error_of_run(*source_, mains_,
                                 [&](const std::string& next) {
                                   if (calls.count(next) > 0) {
                                     before = before.value_or(rig_->commands());
                                   } else if (before) {
                                     after = after.value_or(rig_->commands());
                                   }
                                 }),
              "");
    return after.value_or(rig_->commands()) - before.value_or(0);
  }

  // As by Ctrl-C, when the n-th command of `call` arrives, for each n.
  void interrupt_at_each_command_of(const std::string& call) {
    const std::size_t commands = commands_of({call});
    std::size_t interrupted = 0;
    for (std::size_t command = 1; command <= commands; ++command) {
      stop_ = false;
      new_rig();
      source_->end_calls_if(&stop_);
      std::size_t before = 0;
      const std::string error = run_with(
          [&] {
            before = rig_->commands();
            rig_->at_command(static_cast<int>(command), [this] { stop_ = true; });
          },
          call);
      EXPECT_LE(rig_->commands() - before, command + abilities_.most_ahead) << command;
      EXPECT_EQ(source_->was_interrupted(), !error.empty()) << command << ": " << error;
      interrupted += error.empty() ? 0 : 1;
      EXPECT_TRUE(make_safe(*source_)) << command;
    }
    // The flag has no effect on the commands that switch off, nor after the last call: what was
    // sent ahead may arrive later.
    const std::size_t fewest = !abilities_.stop_asks_and_switches_off
                                   ? commands - std::min(commands, abilities_.most_ahead)
                               : call == "stop" ? 1
                                                : (commands + 1) / 2;
    EXPECT_GE(interrupted, fewest) << "of " << commands;
    // The same source can begin again. A head may receive nothing in start() and stop().
    rig_->at_command(0, {});
    stop_ = false;
    EXPECT_TRUE(make_safe(*source_));
    EXPECT_TRUE(source_->prepare(mains_).ok());
  }

  Mains mains_;
  std::atomic<bool> stop_{false};  // the rig's thread may set it
  std::unique_ptr<InstrumentRig> rig_ = GetParam().make();
  std::shared_ptr<source::Source> source_ = rig_->make_source();
  const Abilities abilities_ = rig_->abilities();
};

INSTANTIATE_TEST_SUITE_P(Of, AnyInstrument,
                         testing::Values(Rig{"Sdg1032x", &sdg1032x}, Rig{"Sdg2042x", &sdg2042x},
                                         Rig{"Dg1062z", &dg1062z}, Rig{"K33522b", &k33522b},
                                         Rig{"DacHead", &dac_head}),
                         [](const auto& rig) { return std::string(rig.param.name); });

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

TEST_P(AnyInstrument, IsOffIfTheConnectionIsLostAtAnyCommandOfPrepare) {
  EXPECT_TRUE(source_->prepare(mains_).ok());
  const auto commands = static_cast<int>(rig_->commands());
  EXPECT_GE(rig_->commands(), abilities_.prepare_sends);
  for (int command = 1; command <= commands; ++command) {
    new_rig();
    rig_->lose_connection_at(command);
    // If the driver reconnects, it does so once and starts again.
    const auto prepared = source_->prepare(mains_);
    EXPECT_EQ(prepared.ok(), abilities_.reconnects)
        << command << ": " << (prepared.ok() ? "" : prepared.error());
    EXPECT_FALSE(rig_->output_is_on()) << command;
    EXPECT_TRUE(make_safe(*source_)) << command;
  }
}

TEST_P(AnyInstrument, IsOffIfTheConnectionIsLostAtAnyCommandOfEnergise) {
  EXPECT_TRUE(source_->prepare(mains_).ok());
  const auto before = rig_->commands();
  EXPECT_TRUE(source_->energise().ok());
  const auto commands = static_cast<int>(rig_->commands() - before);
  EXPECT_GT(commands, 5);
  for (int command = 1; command <= commands; ++command) {
    new_rig();
    EXPECT_TRUE(source_->prepare(mains_).ok());
    rig_->lose_connection_at(command);
    static_cast<void>(source_->energise().ok());
    if (command % 2 == 0) {
      EXPECT_TRUE(make_safe(*source_)) << command;
    }
    expect_reachable();
  }
}

TEST_P(AnyInstrument, IsOffIfTheConnectionIsLostAtCommandsWhilePlaying) {
  for (int command = 1; command <= 9; command += 2) {
    new_rig();
    const std::string error = run_with([&] { rig_->lose_connection_at(command); }, "hold");
    // If the driver reconnects, it does so once, and the waveform went on.
    EXPECT_EQ(error.empty(), abilities_.reconnects) << command << ": " << error;
    if (error.empty()) {
      EXPECT_FALSE(rig_->output_is_on()) << command;
    }
    expect_reachable();
  }
}

TEST_P(AnyInstrument, IsOffIfPrepareIsInterruptedAtAnyCommand) {
  interrupt_at_each_command_of("prepare");
}
TEST_P(AnyInstrument, IsOffIfEnergiseIsInterruptedAtAnyCommand) {
  interrupt_at_each_command_of("energise");
}
TEST_P(AnyInstrument, IsOffIfStartIsInterruptedAtAnyCommand) {
  interrupt_at_each_command_of("start");
}
TEST_P(AnyInstrument, IsOffIfAdvanceIsInterruptedAtAnyCommand) {
  interrupt_at_each_command_of("advance");
}
TEST_P(AnyInstrument, IsOffIfStopIsInterruptedAtAnyCommand) {
  interrupt_at_each_command_of("stop");
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

TEST_P(AnyInstrument, IsOffIfItIsUnpluggedAtAboutAnyCommand) {
  EXPECT_TRUE(source_->prepare(mains_).ok());
  const std::size_t commands = rig_->commands();
  for (std::size_t command = 1; command <= commands; command += 4) {
    new_rig();
    std::atomic<bool> ended = false;
    std::thread cable([&] {
      while (!ended && rig_->commands() < command) {
        std::this_thread::yield();
      }
      rig_->unplug();
    });
    static_cast<void>(source_->prepare(mains_).ok());
    ended = true;
    cable.join();
    EXPECT_FALSE(rig_->output_is_on()) << command;
    EXPECT_FALSE(make_safe(*source_)) << command;
    rig_->plug_in();
    EXPECT_TRUE(make_safe(*source_)) << command;
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
