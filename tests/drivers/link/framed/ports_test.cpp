// Discovery on the ports of a framed link.
#include "outlets_on_cables.hpp"
#include "spoilers.hpp"

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
  cable(kB).unplug();
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  poll();
  EXPECT_THAT(messages_, IsEmpty());
  EXPECT_THAT(faults_, IsEmpty());
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
