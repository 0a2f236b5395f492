// What a serial link finds on its ports.
#include "outlets_on_cables.hpp"

namespace {

using gsbench::link::SerialLink;
using gsbench::link::SerialOptions;
using gsbench::test::OutletsOnCables;
using testing::HasSubstr;
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

TEST_F(FindingOutlets, RefusesTwoThatSayTheyAreTheSameAndNamesBothPorts) {
  add("twin");
  add("single");
  add("twin");
  EXPECT_EQ(refusal(options()), "two outlets say they are twin: on " + outlets_[0].bench_port() +
                                    " and on " + outlets_[2].bench_port());
}

TEST_F(FindingOutlets, RefusesAPortWithoutAnOutletAndNamesIt) {
  add("a");
  lay_cable("nobody");
  SerialOptions short_wait = options();
  short_wait.answer_s = 0.7;
  EXPECT_EQ(refusal(short_wait), outlets_[1].bench_port() + ": no outlet answers");
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
