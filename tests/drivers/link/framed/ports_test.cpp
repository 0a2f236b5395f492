// What a framed link finds on its ports.
#include "outlets_on_cables.hpp"
#include "spoilers.hpp"

#include <cstring>

namespace {

using gsbench::emulation::NullModem;
using gsbench::link::FramedLink;
using gsbench::link::FramedOptions;
using gsbench::test::change_hello;
using gsbench::test::OutletsOnCables;
using gsbench::test::ping;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class Ports : public OutletsOnCables {
 protected:
  NullModem nobodys_ = NullModem::create().take();
};

TEST_F(Ports, TwoWithOutletsThatSayTheyAreTheSameAreBothAtFaultAndNotSpokenTo) {
  cable(1).spoil(change_hello([](gs::wire::Hello& hello) { std::strcpy(hello.id, "a"); }));
  open();
  ASSERT_THAT(present_, SizeIs(2));
  for (const std::size_t twin : {0U, 1U}) {
    EXPECT_EQ(present_[twin].id, "a on " + port(twin));
    EXPECT_EQ(present_[twin].fault,
              "is there twice: the one on " + port(1 - twin) + " says that it is it");
    send(twin, ping(1));
  }
  outlets_.play(10);
  cable(1).unplug();
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  poll();
  EXPECT_THAT(messages_, IsEmpty());
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_F(Ports, OneWithoutAnAnswerIsAtFaultByItsName) {
  FramedOptions three = options();
  three.ports.insert(three.ports.begin(), nobodys_.bench_end());
  three.answer_s = 0.7;
  open(three);
  ASSERT_THAT(present_, SizeIs(3));
  EXPECT_EQ(present_[0].id, nobodys_.bench_end());
  EXPECT_EQ(present_[0].fault, "does not answer");
  EXPECT_EQ(present_[1].where, port(0));
  EXPECT_TRUE(answers(1));
}

TEST_F(Ports, ThoseWithoutAnOutletAreLeftOutWhereItIsLooking) {
  FramedOptions looking = options();
  looking.ports.insert(looking.ports.begin(), {nobodys_.bench_end(), "/dev/no-such-port"});
  looking.answer_s = 0.7;
  looking.skip_silent = true;
  open(looking);
  ASSERT_THAT(present_, SizeIs(2));
  EXPECT_EQ(present_[0].id, "a");
  EXPECT_TRUE(answers(0));
}

TEST_F(Ports, OneThatCannotBeOpenedIsRefused) {
  FramedOptions wrong = options();
  wrong.ports.emplace_back("/dev/no-such-port");
  EXPECT_THAT(refusal(FramedLink(wrong)), HasSubstr("/dev/no-such-port: cannot be found"));
}

}  // namespace
