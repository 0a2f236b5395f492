// The conformance suite of drivers of instruments (any_instrument.hpp): faults and interruptions at
// each command, after which the output is off.
#include "any_instrument.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <set>
#include <thread>

namespace gsbench::test {
namespace {

class AtEveryCommand : public AnyInstrument {
 protected:
  ~AtEveryCommand() override {
    source_.reset();
    rig_.reset();  // its thread may set stop_
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
    EXPECT_TRUE(commands > 0 || !abilities_.stop_asks_and_switches_off);
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

  std::atomic<bool> stop_{false};
};

INSTANTIATE_TEST_SUITE_P(Of, AtEveryCommand,
                         testing::Values(RigCase{"Sdg1032x", &sdg1032x},
                                         RigCase{"Sdg2042x", &sdg2042x},
                                         RigCase{"Dg1062z", &dg1062z}, RigCase{"K33522b", &k33522b},
                                         RigCase{"DacHead", &dac_head}),
                         &name_of);

TEST_P(AtEveryCommand, OfPrepareTheConnectionMayBeLost) {
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

TEST_P(AtEveryCommand, OfEnergiseTheConnectionMayBeLost) {
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

TEST_P(AtEveryCommand, FromHoldToStopTheConnectionMayBeLost) {
  const std::size_t commands = commands_of({"hold", "start", "advance", "stop"});
  EXPECT_GE(commands, 10U);
  for (std::size_t command = 1; command <= commands; ++command) {
    new_rig();
    const std::string error =
        run_with([&] { rig_->lose_connection_at(static_cast<int>(command)); }, "hold");
    // If the driver reconnects, it does so once, and the waveform went on. What was sent ahead may
    // arrive after the last call.
    if (abilities_.reconnects) {
      EXPECT_EQ(error, "") << command;
      EXPECT_FALSE(rig_->output_is_on()) << command;
    } else {
      EXPECT_TRUE(!error.empty() || command + abilities_.most_ahead > commands) << command;
    }
    expect_reachable();
  }
}

TEST_P(AtEveryCommand, OfPrepareTheRunMayBeInterrupted) {
  interrupt_at_each_command_of("prepare");
}
TEST_P(AtEveryCommand, OfEnergiseTheRunMayBeInterrupted) {
  interrupt_at_each_command_of("energise");
}
TEST_P(AtEveryCommand, OfStartTheRunMayBeInterrupted) {
  interrupt_at_each_command_of("start");
}
TEST_P(AtEveryCommand, OfAdvanceTheRunMayBeInterrupted) {
  interrupt_at_each_command_of("advance");
}
TEST_P(AtEveryCommand, OfStopTheRunMayBeInterrupted) {
  interrupt_at_each_command_of("stop");
}

TEST_P(AtEveryCommand, OfPrepareItMayBeUnplugged) {
  EXPECT_TRUE(source_->prepare(mains_).ok());
  const std::size_t commands = rig_->commands();
  for (std::size_t command = 1; command <= commands; ++command) {
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
    if (command % 8 == 1) {
      EXPECT_FALSE(make_safe(*source_)) << command;
    }
    rig_->plug_in();
    EXPECT_TRUE(make_safe(*source_)) << command;
  }
}

}  // namespace
}  // namespace gsbench::test
