// Opening an MQTT link: the outlets found, and refused connections.
#include "outlets_on_a_broker.hpp"
#include "parrot.hpp"

namespace gsbench::test {
namespace {

using link::MqttLink;
using link::MqttOptions;
using testing::AllOf;
using testing::HasSubstr;

class FindingOutlets : public OutletsOnABroker {
 protected:
  std::string fault_of_a() {
    open({kA});
    return present_.empty() ? "not found" : present_.front().fault;
  }
};

TEST_F(FindingOutlets, FindsAllOutletsIfNoneIsNamedAndReportsSilentOnes) {
  const MqttOutlet b(broker_, kB);
  const MqttOutlet a(broker_, kA);
  MqttOutlet c(broker_, "c");
  open({"c"});  // makes sure that the broker has its hello
  c.stop_answering();
  LinkFixture::open(std::make_shared<MqttLink>(options({})), {}, {}, std::chrono::seconds(1));
  ASSERT_THAT(present_, testing::SizeIs(3));
  EXPECT_EQ(present(kA).fault, "");
  EXPECT_EQ(present(kB).fault, "");
  EXPECT_EQ(present("c").fault, "does not answer");
}

TEST_F(FindingOutlets, ALateOutletJoinsAndAnswers) {
  const MqttOutlet a(broker_, kA);
  open({kB, kA});
  EXPECT_EQ(present(kB).fault, "is not on the broker");
  MqttOutlet b(broker_, kB);
  ASSERT_TRUE(until([&] { return !joined_.empty(); }));
  EXPECT_EQ(joined_[0].id, kB);
  EXPECT_EQ(joined_[0].where, broker_.url());
  b.take_samples(1280);
  EXPECT_TRUE(arrives(kB, gs::wire::UplinkKind::kMeasurement, 10));
  EXPECT_TRUE(answers(kA));
  EXPECT_THAT(faults_, testing::IsEmpty());
}

TEST_F(FindingOutlets, OutletsWithTheSameIdAreFaultyAndOthersAnswer) {
  const MqttOutlet one(broker_, kA, 0x1111);
  const MqttOutlet two(broker_, kA, 0x2222);
  const MqttOutlet b(broker_, kB);
  open({kB, kA});
  EXPECT_EQ(present(kB).fault, "");
  EXPECT_THAT(present(kA).fault, AllOf(HasSubstr("has the same id as another outlet"),
                                       HasSubstr("0x00001111"), HasSubstr("0x00002222")));
  EXPECT_TRUE(answers(kB));
}

TEST_F(FindingOutlets, AnOutletOfAnotherProtocolVersionIsFaulty) {
  gs::wire::Uplink hello;
  hello.hello.protocol_version = 77;
  gs::app::set_text(hello.hello.id, "a");
  const Parrot a(broker_, "a", hello);
  EXPECT_EQ(fault_of_a(), "uses protocol version 77, not 3");
}

TEST_F(FindingOutlets, RefusesAnOutletOnTheTopicOfAnother) {
  gs::wire::Uplink hello;
  gs::app::set_text(hello.hello.id, "b");
  hello.hello.sample_rate_hz = 8000;
  hello.hello.nominal_hz = 50;
  const Parrot a(broker_, "a", hello);
  EXPECT_EQ(fault_of_a(), "reports another id there: \"b\"");
  EXPECT_EQ(present_.front().id, "a");
}

TEST_F(FindingOutlets, AHelloThatCannotBeReadIsReportedWithTheReason) {
  gs::wire::Uplink hello;
  gs::app::set_text(hello.hello.id, "a");
  hello.hello.sample_rate_hz = 8000;
  hello.hello.nominal_hz = 55;
  const std::string fault = "its hello cannot be read: nominal_hz is 55, not 50 or 60";
  Parrot a(broker_, "a", hello);
  EXPECT_EQ(fault_of_a(), fault);
  a.stop_answering();  // the broker still has the hello
  EXPECT_EQ(fault_of_a(), fault);
}

TEST_F(FindingOutlets, ReportsThatTheBrokerRefusesThePassword) {
  MqttOptions wrong = options({"a"});
  wrong.password = "guessed";
  EXPECT_THAT(refusal(wrong), AllOf(HasSubstr(broker_.url()), HasSubstr("refuses the user name"),
                                    HasSubstr("\"bench\"")));
}

TEST_F(FindingOutlets, FindsNoOutletWithAnOutletsLogin) {
  const MqttOutlet a(broker_, "a");
  MqttOptions wrong = options({"a"});
  wrong.user = broker_.outlet("b").user;
  wrong.password = broker_.outlet("b").password;
  LinkFixture::open(std::make_shared<MqttLink>(wrong), {kA});
  EXPECT_EQ(present(kA).fault, "is not on the broker");
  EXPECT_EQ(fault_of_a(), "");
}

}  // namespace
}  // namespace gsbench::test
