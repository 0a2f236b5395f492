// What a link must do with outlets that start, fall silent, restart and are lost.
#include "rigs.hpp"
#include <link_test/hears_a_link.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using namespace std::chrono_literals;
using gs::wire::UplinkKind;
using std::chrono::steady_clock;
using testing::IsEmpty;
using testing::SizeIs;

std::int64_t now_ns() {
  return std::chrono::nanoseconds(steady_clock::now().time_since_epoch()).count();
}

class OutletProcesses : public HearsALink, public testing::WithParamInterface<LinkUnderTest> {
 protected:
  void open() { HearsALink::open(rig_.make_link()); }

  // What is sent before both ends have found each other again is lost.
  bool answers_in_the_end(const std::string& outlet) {
    std::uint32_t token = 100;
    auto next = steady_clock::now();
    return until([&] {
      if (steady_clock::now() >= next) {
        send(outlet, ping(++token));
        next += 100ms;
      }
      return !messages(outlet, UplinkKind::kEcho).empty();
    });
  }

  std::unique_ptr<LinkRig> owned_ = GetParam().make();
  ProcessRig& rig_ = dynamic_cast<ProcessRig&>(*owned_);
};

INSTANTIATE_TEST_SUITE_P(Links, OutletProcesses, testing::ValuesIn(kToProcesses), name_of);

TEST_P(OutletProcesses, AreFoundAgainAfterClosing) {
  open();
  link_->close();
  HearsALink::open(link_);
  EXPECT_EQ(present(kA).fault, "");
  EXPECT_TRUE(answers(kA));
}

TEST_P(OutletProcesses, OneThatIsNotThereIsAtFaultAndTheOtherIsSpokenTo) {
  open();  // so that it was there, and is not merely late
  link_->close();
  rig_.outlets.kill(kA);
  open();
  EXPECT_EQ(present(kA).fault, rig_.words().absent);
  EXPECT_EQ(present(kB).fault, "");
  EXPECT_TRUE(answers(kB));
}

TEST_P(OutletProcesses, OneThatIsStillStartingIsWaitedFor) {
  open();
  link_->close();
  rig_.outlets.signal(kA, SIGSTOP);
  std::thread waking([this] {
    std::this_thread::sleep_for(700ms);
    rig_.outlets.signal(kA, SIGCONT);
  });
  open();
  waking.join();
  EXPECT_EQ(present(kA).fault, "");
}

TEST_P(OutletProcesses, TheirMessagesAreStampedWhenTheyComeAndNotWhenTheyAreFetched) {
  open();
  const std::int64_t before = now_ns();
  send(kA, ping(1));
  std::this_thread::sleep_for(300ms);
  const std::int64_t fetched = now_ns();
  ASSERT_TRUE(comes(kA, UplinkKind::kEcho));
  const std::int64_t arrival = messages(kA, UplinkKind::kEcho).front().arrival_ns;
  EXPECT_GE(arrival, before);
  // An echo takes a millisecond; a machine that is busy for a quarter of a second would have to be
  // at fault.
  EXPECT_LT(arrival, fetched - 50'000'000);
}

TEST_P(OutletProcesses, OneThatIsStoppedIsOnlySilent) {
  open();
  ASSERT_TRUE(answers(kA, 1));
  rig_.outlets.signal(kA, SIGSTOP);
  messages_.clear();
  send(kA, ping(2));
  ASSERT_TRUE(answers(kB, 2));
  std::this_thread::sleep_for(400ms);  // longer than any look at the ports
  poll();
  EXPECT_THAT(messages(kA, UplinkKind::kEcho), IsEmpty());
  EXPECT_THAT(faults_, IsEmpty());
  rig_.outlets.signal(kA, SIGCONT);
  EXPECT_TRUE(comes(kA, UplinkKind::kEcho));
}

TEST_P(OutletProcesses, OneThatIsLostIsReportedOnceAndTheOtherGoesOn) {
  open();
  rig_.unplug();
  ASSERT_TRUE(is_reported(kA, rig_.words().lost));
  ASSERT_TRUE(answers(kB, 5));
  std::this_thread::sleep_for(600ms);  // two looks whether it is back
  poll();
  EXPECT_THAT(faults(kA), SizeIs(1));
  EXPECT_THAT(faults(kB), IsEmpty());
}

TEST_P(OutletProcesses, WhatIsSentToALostOneIsAFaultOfItAlone) {
  open();
  rig_.unplug();
  ASSERT_TRUE(is_reported(kA, rig_.words().lost));
  send(kA, ping(1));
  EXPECT_TRUE(is_reported(kA, rig_.words().undeliverable));
  EXPECT_TRUE(answers(kB));
  EXPECT_THAT(faults(kB), IsEmpty());
}

TEST_P(OutletProcesses, OneThatIsBackIsSpokenToAgain) {
  open();
  rig_.play(10);
  ASSERT_TRUE(comes(kA, UplinkKind::kMeasurement, 10));
  rig_.unplug();
  ASSERT_TRUE(is_reported(kA, rig_.words().lost));
  rig_.plug_in();
  ASSERT_TRUE(is_reported(kA, rig_.words().back));
  ASSERT_TRUE(answers_in_the_end(kA));
  const std::size_t before = messages(kA, UplinkKind::kMeasurement).size();
  rig_.play(10);
  EXPECT_TRUE(comes(kA, UplinkKind::kMeasurement, before + 10));
  EXPECT_THAT(faults(kB), IsEmpty());
}

TEST_P(OutletProcesses, OneThatRestartedIsReportedAndHeard) {
  open();
  rig_.play(10);
  ASSERT_TRUE(comes(kA, UplinkKind::kMeasurement, 10));
  rig_.outlets.kill(kA);
  rig_.outlets.start(kA);
  ASSERT_TRUE(is_reported(kA, "restarted after its sample "));
  messages_.clear();
  ASSERT_TRUE(answers_in_the_end(kA));
  rig_.play(10);
  EXPECT_TRUE(comes(kA, UplinkKind::kMeasurement, 10));
  EXPECT_THAT(faults(kB), IsEmpty());
}

}  // namespace
}  // namespace gsbench::test
