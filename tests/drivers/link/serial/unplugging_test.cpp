// Silent is not unplugged, and unplugged is not lost.
#include "outlets_on_cables.hpp"

namespace {

using gs::wire::UplinkKind;
using gsbench::test::OutletsOnCables;
using testing::IsEmpty;

using Unplugging = OutletsOnCables;

TEST_F(Unplugging, AnOutletThatIsStoppedIsOnlySilent) {
  add("stopped");
  add("other");
  open();
  ASSERT_TRUE(answers(0, 1));
  ASSERT_EQ(::kill(outlets_[0].process->pid(), SIGSTOP), 0);
  messages_.clear();
  send(0, ping(2));
  ASSERT_TRUE(answers(1, 2));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));  // longer than any look at the ports
  poll();
  EXPECT_THAT(messages(0, UplinkKind::kEcho), IsEmpty());
  EXPECT_THAT(faults_, IsEmpty());
  ASSERT_EQ(::kill(outlets_[0].process->pid(), SIGCONT), 0);
  EXPECT_TRUE(until([&] { return !messages(0, UplinkKind::kEcho).empty(); }));
}

TEST_F(Unplugging, ACableThatIsPulledIsToldOnceAndTheOthersGoOn) {
  add("pulled");
  add("other");
  open();
  unplug(0);
  ASSERT_TRUE(until([&] { return told(0, "was unplugged from " + outlets_[0].bench_port()); }));
  ASSERT_TRUE(answers(1, 5));
  std::this_thread::sleep_for(std::chrono::milliseconds(600));  // two looks whether it is back
  poll();
  EXPECT_EQ(faults(0).size(), 1U);
  EXPECT_THAT(faults(1), IsEmpty());
}

TEST_F(Unplugging, WhatIsSentToAPortThatIsGoneIsAFaultOfThatOutletAlone) {
  add("pulled");
  add("other");
  open();
  unplug(0);
  ASSERT_TRUE(until([&] { return told(0, "was unplugged"); }));
  send(0, ping(1));
  EXPECT_TRUE(until([&] { return told(0, "does not take what is sent to it"); }));
  EXPECT_TRUE(answers(1, 1));
  EXPECT_THAT(faults(1), IsEmpty());
}

TEST_F(Unplugging, AnOutletIsSpokenToAgainWhenItsPortIsBack) {
  add("pulled");
  open();
  play(0, 10);
  ASSERT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() >= 10; }));
  unplug(0);
  ASSERT_TRUE(until([&] { return told(0, "was unplugged"); }));
  plug_in(0);
  ASSERT_TRUE(until([&] { return told(0, "is back on " + outlets_[0].bench_port()); }));
  // Both ends look for the port a few times a second; what is said in between is lost.
  bool answered = false;
  for (std::uint32_t token = 1; token < 20 && !answered; ++token) {
    send(0, ping(token));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    poll();
    answered = !messages(0, UplinkKind::kEcho).empty();
  }
  EXPECT_TRUE(answered);
  EXPECT_FALSE(told(0, "began anew")) << "it never stopped";
  const std::size_t before = messages(0, UplinkKind::kMeasurement).size();
  play(0, 10);
  EXPECT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() >= before + 10; }));
}

TEST_F(Unplugging, TheFarEndsProcessMayDieAndComeBackOnTheSamePort) {
  add("a");
  add("other");
  open();
  ASSERT_TRUE(answers(0, 1)) << "a hello with nothing before the next one counts as said twice";
  outlets_[0].process->kill();
  ASSERT_TRUE(answers(1, 1));
  poll();
  EXPECT_THAT(faults(0), IsEmpty()) << "the cable is there: it is only silent";
  messages_.clear();  // a slow start is asked twice who it is, and says it twice
  start(0);
  ASSERT_TRUE(until([&] { return !messages(0, UplinkKind::kHello).empty(); }));
  EXPECT_TRUE(answers(0, 2));
  EXPECT_THAT(faults(1), IsEmpty());
}

}  // namespace
