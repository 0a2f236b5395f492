// Discovery on the ports of a framed link.
#include "outlets_on_cables.hpp"
#include "spoilers.hpp"

#include <atomic>
#include <cstring>
#include <utility>

namespace gsbench::test {
namespace {

using emulation::NullModem;
using link::FramedLink;
using link::FramedOptions;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class Ports : public OutletsOnCables {
 protected:
  std::unique_ptr<NullModem> unconnected_ = NullModem::create().take();
};

TEST_F(Ports, OutletsWithTheSameIdAreFaultyAndExcluded) {
  cable(kB).spoil(change_hello([](gs::wire::Hello& hello) { std::strcpy(hello.id, kA); }));
  open();
  ASSERT_THAT(present_, SizeIs(2));
  for (const auto& [one, other] : {std::pair(port(kA), port(kB)), {port(kB), port(kA)}}) {
    EXPECT_EQ(present(one).id, "a on " + one);
    EXPECT_EQ(present(one).fault, "has the same id as another outlet: the one on " + other);
  }
  send(kA, ping(1));
  outlets_.play(10);
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  poll();
  EXPECT_THAT(messages_, IsEmpty());
  EXPECT_THAT(changes_, IsEmpty());
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_F(Ports, OfTwoOutletsWithTheSameIdOneJoinsAgainWhenTheOtherHasLeft) {
  cable(kB).spoil(change_hello([](gs::wire::Hello& hello) { std::strcpy(hello.id, kA); }));
  open();
  cable(kB).unplug();
  ASSERT_TRUE(until([&] { return !joined_.empty(); }));
  EXPECT_EQ(joined_[0].where, port(kA));
  EXPECT_EQ(joined_[0].fault, "");
  EXPECT_THAT(faults(kA), testing::ElementsAre("was unplugged from " + port(kB)));
  EXPECT_TRUE(answers(kA));
  ASSERT_TRUE(cable(kB).plug_in().ok());
  ASSERT_TRUE(until([&] { return joined_.size() == 2; }));
  EXPECT_EQ(joined_[1].where, port(kB));
  messages_.clear();
  send(kA, ping(2));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  poll();
  EXPECT_THAT(messages_, IsEmpty()) << "they are two again";
}

TEST_F(Ports, AnOutletWithAnotherProtocolVersionJoinsAgainWithOtherFirmware) {
  std::atomic<int> hellos{0};
  cable(kA).spoil(change_hello([&](gs::wire::Hello& hello) {
    hello.protocol_version = 2;
    ++hellos;
  }));
  open();
  EXPECT_EQ(present(kA).fault, "uses protocol version 2, not 3");
  const auto restart = [&] {
    outlets_.kill(kA);
    outlets_.start(kA);
  };
  const int before = hellos;
  outlets_.play(1);
  restart();
  ASSERT_TRUE(until([&] {
    outlets_.play(1);  // it starts with what is played
    return hellos > before;
  }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  poll();
  EXPECT_THAT(joined_, IsEmpty()) << "its firmware is as it was";
  cable(kA).spoil({});
  restart();
  ASSERT_TRUE(until([&] {
    outlets_.play(1);
    return !joined_.empty();
  }));
  EXPECT_EQ(joined_[0].fault, "");
  EXPECT_TRUE(answers(kA));
}

TEST_F(Ports, AnOutletThatIsStartedElsewhereLeavesAndJoinsAndHasRestarted) {
  open();
  outlets_.play(5);
  ASSERT_TRUE(arrives(kA, gs::wire::UplinkKind::kMeasurement, 5));
  cable(kA).unplug();
  ASSERT_TRUE(is_reported(kA, "was unplugged"));
  outlets_.kill(kA);
  ASSERT_TRUE(cable(kA).plug_in().ok());
  outlets_.start(kA);
  ASSERT_TRUE(until([&] { return !joined_.empty(); }));
  EXPECT_TRUE(answers(kA));
  EXPECT_THAT(joined_, SizeIs(1));
  EXPECT_THAT(faults(kA), testing::ElementsAre("was unplugged from " + port(kA),
                                               HasSubstr("restarted after its sample ")));
}

TEST_F(Ports, ASilentPortIsFaultyUntilItsOutletAnswers) {
  cable(kA).spoil([](Bytes& bytes) { bytes.clear(); });
  open();
  ASSERT_THAT(present_, SizeIs(2));
  EXPECT_EQ(present(port(kA)).fault, "does not answer");
  EXPECT_EQ(present(kB).where, port(kB));
  EXPECT_TRUE(answers(kB));
  EXPECT_THAT(joined_, IsEmpty());
  cable(kA).spoil({});
  ASSERT_TRUE(until([&] { return !joined_.empty(); }));
  EXPECT_EQ(joined_[0].id, kA);
  EXPECT_TRUE(answers(kA));
}

TEST_F(Ports, APortThatCannotBeOpenedIsFaultyAndTheOthersAreNotAffected) {
  FramedOptions some = options();
  some.ports.insert(some.ports.begin(),
                    {unconnected_->bench_end(), "/dev/no-such-port", "/dev/null"});
  open(some);
  ASSERT_THAT(present_, SizeIs(5));
  EXPECT_EQ(present("/dev/null").fault, "cannot be opened: is not a serial port");
  EXPECT_EQ(present(unconnected_->bench_end()).fault, "does not answer");
  EXPECT_EQ(present("/dev/no-such-port").where, "");
  EXPECT_THAT(present("/dev/no-such-port").fault, testing::StartsWith("cannot be found: "));
  EXPECT_EQ(present(kA).fault, "");
  EXPECT_TRUE(answers(kA));
}

TEST_F(Ports, AnOutletJoinsOnceItsPortCanBeOpened) {
  open();  // the outlet runs and is connected
  cable(kA).unplug();
  open();
  EXPECT_THAT(present(port(kA)).fault, HasSubstr("Connection refused"));
  EXPECT_THAT(link_->unreachable(), SizeIs(1));
  ASSERT_TRUE(cable(kA).plug_in().ok());
  ASSERT_TRUE(until([&] { return !joined_.empty(); }));
  EXPECT_EQ(joined_[0].id, kA);
  EXPECT_TRUE(answers(kA));
  EXPECT_THAT(link_->unreachable(), IsEmpty());
}

}  // namespace
}  // namespace gsbench::test
