// The contract suite of links to outlets that start, fall silent, restart and are lost.
#include "rigs.hpp"
#include <link_test/link_fixture.hpp>

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

class OutletProcesses : public LinkFixture, public testing::WithParamInterface<LinkUnderTest> {
 protected:
  void open() { LinkFixture::open(rig_.make_link()); }

  // Repeats the ping: it is lost while the ends are not connected.
  bool answers_eventually(const std::string& outlet) {
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

TEST_P(OutletProcesses, AreFoundAgainAfterReopening) {
  open();
  link_->close();
  LinkFixture::open(link_);
  EXPECT_EQ(present(kA).fault, "");
  EXPECT_TRUE(answers(kA));
}

TEST_P(OutletProcesses, AnAbsentOutletIsFaultyAndTheOtherAnswers) {
  open();  // makes sure that the outlet has started before
  link_->close();
  rig_.outlets.kill(kA);
  open();
  EXPECT_EQ(present(kA).fault, rig_.fault_texts().absent);
  EXPECT_EQ(present(kB).fault, "");
  EXPECT_TRUE(answers(kB));
}

TEST_P(OutletProcesses, AStartingOutletIsWaitedFor) {
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

TEST_P(OutletProcesses, MessagesAreStampedOnArrivalNotOnPolling) {
  open();
  const std::int64_t before = now_ns();
  send(kA, ping(1));
  std::this_thread::sleep_for(300ms);
  const std::int64_t fetched = now_ns();
  ASSERT_TRUE(arrives(kA, UplinkKind::kEcho));
  const std::int64_t arrival = messages(kA, UplinkKind::kEcho).front().arrival_ns;
  EXPECT_GE(arrival, before);
  // An echo takes about 1 ms; the limit allows a machine that stalls for 0.25 s.
  EXPECT_LT(arrival, fetched - 50'000'000);
}

TEST_P(OutletProcesses, AStoppedOutletIsSilentButNotFaulty) {
  open();
  ASSERT_TRUE(answers(kA, 1));
  rig_.outlets.signal(kA, SIGSTOP);
  messages_.clear();
  send(kA, ping(2));
  ASSERT_TRUE(answers(kB, 2));
  std::this_thread::sleep_for(400ms);  // longer than the interval of reopening ports
  poll();
  EXPECT_THAT(messages(kA, UplinkKind::kEcho), IsEmpty());
  EXPECT_THAT(faults_, IsEmpty());
  rig_.outlets.signal(kA, SIGCONT);
  EXPECT_TRUE(arrives(kA, UplinkKind::kEcho));
}

TEST_P(OutletProcesses, ALostOutletIsReportedOnceAndTheOtherContinues) {
  open();
  rig_.unplug();
  ASSERT_TRUE(is_reported(kA, rig_.fault_texts().lost));
  ASSERT_TRUE(answers(kB, 5));
  std::this_thread::sleep_for(600ms);  // two attempts to reopen the port
  poll();
  EXPECT_THAT(faults(kA), SizeIs(1));
  EXPECT_THAT(faults(kB), IsEmpty());
}

TEST_P(OutletProcesses, SendingToALostOutletIsAFaultOfThatOutletOnly) {
  open();
  rig_.unplug();
  ASSERT_TRUE(is_reported(kA, rig_.fault_texts().lost));
  send(kA, ping(1));
  EXPECT_TRUE(is_reported(kA, rig_.fault_texts().undeliverable));
  EXPECT_TRUE(answers(kB));
  EXPECT_THAT(faults(kB), IsEmpty());
}

TEST_P(OutletProcesses, AReconnectedOutletAnswersAgain) {
  open();
  rig_.play(10);
  ASSERT_TRUE(arrives(kA, UplinkKind::kMeasurement, 10));
  rig_.unplug();
  ASSERT_TRUE(is_reported(kA, rig_.fault_texts().lost));
  rig_.plug_in();
  ASSERT_TRUE(until([&] { return !joined_.empty(); }));
  ASSERT_TRUE(answers_eventually(kA));
  const std::size_t before = messages(kA, UplinkKind::kMeasurement).size();
  rig_.play(10);
  EXPECT_TRUE(arrives(kA, UplinkKind::kMeasurement, before + 10));
  EXPECT_THAT(faults(kB), IsEmpty());
}

TEST_P(OutletProcesses, ARestartedOutletIsReportedAndAnswers) {
  open();
  rig_.play(10);
  ASSERT_TRUE(arrives(kA, UplinkKind::kMeasurement, 10));
  rig_.outlets.kill(kA);
  rig_.outlets.start(kA);
  ASSERT_TRUE(is_reported(kA, "restarted after its sample "));
  messages_.clear();
  ASSERT_TRUE(answers_eventually(kA));
  rig_.play(10);
  EXPECT_TRUE(arrives(kA, UplinkKind::kMeasurement, 10));
  EXPECT_THAT(faults(kB), IsEmpty());
}

}  // namespace
}  // namespace gsbench::test
