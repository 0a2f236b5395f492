// What a serial link finds on its ports.
#include "outlets_on_cables.hpp"

namespace {

using gsbench::link::SerialLink;
using gsbench::link::SerialOptions;
using gsbench::test::OutletsOnCables;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using FindingOutlets = OutletsOnCables;

TEST_F(FindingOutlets, InTheOrderOfTheirPorts) {
  add("second-by-name");
  add("first-by-name");
  add("a");
  open();
  ASSERT_THAT(present_, SizeIs(3));
  EXPECT_EQ(present_[0].id, "second-by-name");
  EXPECT_EQ(present_[1].id, "first-by-name");
  EXPECT_EQ(present_[2].id, "a");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(present_[i].where, outlets_[i].bench_port());
    EXPECT_STREQ(present_[i].hello.board, "host");
    EXPECT_EQ(present_[i].hello.sample_rate_hz, 8000);
  }
}

TEST_F(FindingOutlets, AgainAfterClosing) {
  add("a");
  open();
  link_->close();
  const auto again = link_->open();
  ASSERT_TRUE(again.ok()) << again.error();
  EXPECT_EQ(again.value().front().id, "a");
  EXPECT_TRUE(answers(0, 7));
}

TEST_F(FindingOutlets, TwoThatSayTheyAreTheSameAreBothAtFaultAndNobodySpeaksWithThem) {
  add("twin");
  add("single");
  add("twin");
  open();
  ASSERT_THAT(present_, SizeIs(3));
  EXPECT_EQ(present_[0].id, "twin on " + outlets_[0].bench_port());
  EXPECT_EQ(present_[0].fault,
            "is there twice: the one on " + outlets_[2].bench_port() + " says that it is it");
  EXPECT_EQ(present_[1].fault, "");
  EXPECT_EQ(present_[2].id, "twin on " + outlets_[2].bench_port());
  EXPECT_EQ(present_[2].fault,
            "is there twice: the one on " + outlets_[0].bench_port() + " says that it is it");
  send(0, ping(1));
  send(2, ping(1));
  play(0, 10);
  unplug(2);
  ASSERT_TRUE(answers(1, 2));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  poll();
  for (const std::size_t twin : {0U, 2U}) {
    EXPECT_THAT(messages(twin, gs::wire::UplinkKind::kEcho), IsEmpty());
    EXPECT_THAT(messages(twin, gs::wire::UplinkKind::kMeasurement), IsEmpty());
    EXPECT_THAT(faults(twin), IsEmpty());
  }
}

TEST_F(FindingOutlets, OneThatDoesNotAnswerIsAtFaultByTheNameOfItsPort) {
  lay_cable("nobody");
  add("a");
  SerialOptions short_wait = options();
  short_wait.answer_s = 0.7;
  link_ = std::make_unique<SerialLink>(short_wait);
  const auto opened = link_->open();
  ASSERT_TRUE(opened.ok()) << opened.error();
  ASSERT_THAT(opened.value(), SizeIs(2));
  EXPECT_EQ(opened.value()[0].id, outlets_[0].bench_port());
  EXPECT_EQ(opened.value()[0].fault, "does not answer");
  EXPECT_EQ(opened.value()[1].fault, "");
  EXPECT_TRUE(answers(1, 1));
}

TEST_F(FindingOutlets, LeavesOutPortsWithoutAnOutletWhereItIsLooking) {
  lay_cable("nobody");
  add("a");
  SerialOptions looking = options();
  looking.answer_s = 0.7;
  looking.skip_silent = true;
  looking.ports.emplace_back("/dev/no-such-port");
  link_ = std::make_unique<SerialLink>(looking);
  const auto opened = link_->open();
  ASSERT_TRUE(opened.ok()) << opened.error();
  ASSERT_THAT(opened.value(), SizeIs(1));
  EXPECT_EQ(opened.value().front().id, "a");
  EXPECT_TRUE(answers(0, 1));
}

TEST_F(FindingOutlets, RefusesAPortThatDoesNotExistAndNamesIt) {
  SerialOptions missing;
  missing.ports = {"/dev/no-such-port"};
  EXPECT_THAT(refusal(missing), HasSubstr("/dev/no-such-port: cannot be found"));
}

TEST_F(FindingOutlets, RefusesAPortThatIsNoSerialPort) {
  SerialOptions wrong;
  wrong.ports = {folder_.write("file", "text")};
  EXPECT_THAT(refusal(wrong), HasSubstr(wrong.ports.front() + ": cannot be found"));
}

TEST_F(FindingOutlets, WaitsForOneThatIsStillStarting) {
  add("late");
  const pid_t pid = outlets_[0].process->pid();
  ::kill(pid, SIGSTOP);
  std::thread waking([pid] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    ::kill(pid, SIGCONT);
  });
  link_ = std::make_unique<SerialLink>(options());
  const auto opened = link_->open();
  waking.join();
  ASSERT_TRUE(opened.ok()) << opened.error();
  EXPECT_EQ(opened.value().front().id, "late");
}

}  // namespace
