// Faults before each call of a run, and an unplugged line at each message: the run ends with an
// error, and the output is off wherever the bench can reach the head; else its state is unknown.
#include <head_driver_test/head_rig.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

const char* const kCalls[] = {"prepare", "energise", "hold", "start", "advance", "stop"};

// Makes the calls of a run, with `before` in front of each. Returns the first error.
std::string run(source::Source& source, const source::Stimulus& stimulus,
                const std::function<void(const std::string& call)>& before) {
  const std::function<drivers::Status()> calls[] = {
      [&]() -> drivers::Status {
        const auto prepared = source.prepare(stimulus);
        return prepared.ok() ? drivers::Status(drivers::Done{}) : drivers::Error{prepared.error()};
      },
      [&] { return source.energise(); },
      [&]() -> drivers::Status {
        for (int i = 0; i < 20; ++i) {
          if (drivers::Status held = source.hold(); !held.ok()) {
            return held;
          }
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return drivers::Done{};
      },
      [&] { return source.start(); },
      [&]() -> drivers::Status {
        const auto played = source.advance(stimulus.total_ticks());
        return played.ok() ? drivers::Status(drivers::Done{}) : drivers::Error{played.error()};
      },
      [&] { return source.stop(); },
  };
  for (std::size_t i = 0; i < std::size(calls); ++i) {
    before(kCalls[i]);
    if (const drivers::Status done = calls[i](); !done.ok()) {
      return done.error();
    }
  }
  return "";
}

class HeadAtEveryCall : public testing::TestWithParam<const char*> {
 protected:
  HeadAtEveryCall() { mains_.duration_s = 1.0; }

  std::string run_with(const std::function<void()>& fault) {
    return run(rig_.source(), mains_, [&](const std::string& call) {
      if (call == GetParam()) {
        fault();
      }
    });
  }
  // A fault just before stop() may come too late to be noticed.
  bool must_fail() const { return std::string(GetParam()) != "stop"; }
  std::string make_safe() {
    const drivers::Status safe = rig_.source().make_safe();
    return safe.ok() ? "" : safe.error();
  }
  void expect_off() { EXPECT_EQ(rig_.head->observe().state, gs::head::State::kOff); }

  HeadRig rig_;
  Mains mains_;
};

INSTANTIATE_TEST_SUITE_P(Before, HeadAtEveryCall, testing::ValuesIn(kCalls),
                         [](const auto& call) { return std::string(call.param); });

TEST_P(HeadAtEveryCall, UnpluggedLineLeavesTheStateUnknown) {
  const std::string error = run_with([&] { rig_.head->unplug(); });
  EXPECT_TRUE(!must_fail() || !error.empty());
  EXPECT_THAT(make_safe(), HasSubstr("output state unknown"));
  ASSERT_TRUE(rig_.head->plug_in().ok());
  EXPECT_EQ(make_safe(), "");
  expect_off();
}

TEST_P(HeadAtEveryCall, SilentHeadLeavesTheStateUnknown) {
  const std::string error = run_with([&] { rig_.head->be_silent(true); });
  EXPECT_TRUE(!error.empty() || std::string(GetParam()) == "stop");
  EXPECT_THAT(make_safe(), HasSubstr("output state unknown"));
  rig_.head->be_silent(false);
  EXPECT_EQ(make_safe(), "");
  expect_off();
}

TEST_P(HeadAtEveryCall, GarbageInPlaceOfAnswersLeavesTheStateUnknown) {
  const std::string error = run_with([&] {
    rig_.head->spoil_to_bench([](Bytes& frame) { frame.assign({'?', '!', 0, '\n', 0xFF}); });
  });
  EXPECT_TRUE(!error.empty() || std::string(GetParam()) == "stop");
  EXPECT_THAT(make_safe(), HasSubstr("output state unknown"));
  expect_off();  // it has obeyed
  rig_.head->spoil_to_bench({});
  EXPECT_EQ(make_safe(), "");
}

TEST_P(HeadAtEveryCall, RestartEndsTheRun) {
  const std::string error = run_with([&] { rig_.head->restart(); });
  // Before prepare() there is no session to lose.
  EXPECT_TRUE(!must_fail() || error.empty() == (std::string(GetParam()) == "prepare")) << error;
  EXPECT_EQ(make_safe(), "");
  expect_off();
  // The next run begins a session of its own.
  EXPECT_EQ(run_with([] {}), "");
}

TEST_P(HeadAtEveryCall, AnotherBenchCanSwitchOffAfterTheFirstWasKilled) {
  struct Killed {};
  try {
    run_with([] { throw Killed(); });
  } catch (const Killed&) {
  }
  const auto other = head::Head::create(rig_.options).take();
  EXPECT_TRUE(other->source().make_safe().ok());
  expect_off();
  EXPECT_TRUE(other->source().make_safe().ok());
}

TEST(HeadAtEveryMessage, UnpluggedLineEndsTheRunAndThenItIsSwitchedOff) {
  Mains mains;
  mains.duration_s = 0.3;
  int ended = 0;
  for (int frames = 1; frames <= 40; ++frames) {
    HeadRig rig;
    rig.head->unplug_after(frames);
    const std::string error = run(rig.source(), mains, [](const std::string&) {});
    ended += error.empty() ? 0 : 1;
    EXPECT_TRUE(error.empty() || error.find(rig.head->port()) != std::string::npos) << error;
    EXPECT_EQ(rig.source().make_safe().ok(), error.empty()) << frames;
    ASSERT_TRUE(rig.head->plug_in().ok());
    EXPECT_TRUE(rig.source().make_safe().ok()) << frames;
    EXPECT_EQ(rig.head->observe().state, gs::head::State::kOff) << frames;
  }
  EXPECT_GE(ended, 30);
}

}  // namespace
}  // namespace gsbench::test
