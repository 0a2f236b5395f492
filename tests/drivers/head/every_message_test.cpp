// A line that is unplugged at any message of a run: the run ends with an error that names the port,
// the state of the output is unknown, and the head can be switched off when it is plugged in again.
// Faults before each call, and lost connections that can be opened again, are in the suite of all
// instruments (tests/contracts/source/conformance_test.cpp).
#include <head_driver_test/head_rig.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

// Makes the calls of a run. Returns the first error.
std::string run(HeadRig& rig, const source::Stimulus& stimulus) {
  source::Source& source = rig.source();
  if (const auto prepared = source.prepare(stimulus); !prepared.ok()) {
    return prepared.error();
  }
  if (const drivers::Status done = source.energise(); !done.ok()) {
    return done.error();
  }
  for (int i = 0; i < 20; ++i) {
    if (const drivers::Status held = source.hold(); !held.ok()) {
      return held.error();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (const drivers::Status done = source.start(); !done.ok()) {
    return done.error();
  }
  if (const auto played = source.advance(stimulus.total_ticks()); !played.ok()) {
    return played.error();
  }
  const drivers::Status stopped = source.stop();
  return stopped.ok() ? "" : stopped.error();
}

TEST(HeadAtEveryMessage, UnpluggedLineEndsTheRunAndThenItIsSwitchedOff) {
  Mains mains;
  mains.duration_s = 0.3;
  int ended = 0;
  for (int frames = 1; frames <= 40; ++frames) {
    HeadRig rig;
    rig.head->unplug_after(frames);
    const std::string error = run(rig, mains);
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
