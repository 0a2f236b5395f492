// What opening a link finds, and what it refuses.
#include "outlets_on_a_broker.hpp"

#include <wire/codec.hpp>

namespace {

using gsbench::link::MqttLink;
using gsbench::link::MqttOptions;
using gsbench::test::MqttOutlet;
using gsbench::test::OutletsOnABroker;
using testing::AllOf;
using testing::HasSubstr;

class FindingOutlets : public OutletsOnABroker {
 protected:
  std::string fault_of_a() {
    MqttLink link(options({"a"}));
    const auto opened = link.open();
    return opened.ok() ? opened.value().front().fault : opened.error();
  }
};

TEST_F(FindingOutlets, FindsAllWhereNoneIsNamed) {
  const MqttOutlet b(*broker_, "b");
  const MqttOutlet a(*broker_, "a");
  open({});
  ASSERT_EQ(present_.size(), 2U);
  EXPECT_EQ(present_[0].id, "a");
  EXPECT_EQ(present_[1].id, "b");
}

TEST_F(FindingOutlets, OneThatComesTooLateIsNotListenedTo) {
  const MqttOutlet a(*broker_, "a");
  open({"b", "a"});
  MqttOutlet b(*broker_, "b");
  b.take_samples(1280);
  EXPECT_TRUE(answers(1));
  EXPECT_TRUE(faults(0).empty());
  EXPECT_TRUE(messages(0, gs::wire::UplinkKind::kMeasurement).empty());
}

TEST_F(FindingOutlets, TwoOfOneIdAreAtFaultAndTheOthersAreSpokenTo) {
  const MqttOutlet one(*broker_, "a", 0x1111);
  const MqttOutlet two(*broker_, "a", 0x2222);
  const MqttOutlet b(*broker_, "b");
  open({"b", "a"});
  ASSERT_EQ(present_.size(), 2U);
  EXPECT_EQ(present_[0].fault, "");
  EXPECT_THAT(present_[1].fault,
              AllOf(HasSubstr("is there twice"), HasSubstr("0x00001111"), HasSubstr("0x00002222")));
  EXPECT_TRUE(answers(0));
}

// Says one hello, and whatever is sent to it again.
class Parrot {
 public:
  Parrot(const gsbench::emulation::PrivateBroker& broker, const std::string& id,
         const gs::wire::Uplink& hello) {
    std::string why;
    EXPECT_TRUE(carrier_.start(gsbench::test::options_of(broker, id, 1), why)) << why;
    size_ = gs::wire::encode(hello, 0, bytes_, sizeof bytes_);
    carrier_.send(bytes_, size_);
    thread_ = std::thread([this] { run(); });
  }
  ~Parrot() {
    ending_ = true;
    thread_.join();
  }

 private:
  void run() {
    std::vector<std::uint8_t> message;
    while (!ending_) {
      carrier_.wait(std::chrono::milliseconds(1));
      carrier_.serve();
      while (carrier_.take(message)) {
        carrier_.send(bytes_, size_);
      }
    }
  }

  gs::host::MqttCarrier carrier_;
  std::uint8_t bytes_[gs::wire::kLongestMessage] = {};
  std::size_t size_ = 0;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

TEST_F(FindingOutlets, OneThatSpeaksAnotherProtocolIsAtFault) {
  gs::wire::Uplink hello;
  hello.hello.protocol_version = 77;
  gs::app::set_text(hello.hello.id, "a");
  const Parrot a(*broker_, "a", hello);
  EXPECT_EQ(fault_of_a(), "speaks protocol 77, not 2");
}

TEST_F(FindingOutlets, RefusesAnOutletOnTheTopicOfAnother) {
  gs::wire::Uplink hello;
  gs::app::set_text(hello.hello.id, "b");
  const Parrot a(*broker_, "a", hello);
  EXPECT_EQ(fault_of_a(), "says there that it is \"b\"");
}

TEST_F(FindingOutlets, NamesTheOneThatDoesNotAnswer) {
  MqttOutlet a(*broker_, "a");
  open({"a"});
  a.stop_answering();
  EXPECT_EQ(fault_of_a(), "does not answer");
}

TEST_F(FindingOutlets, SaysWhichBrokerRefusesItsPassword) {
  MqttOptions wrong = options({"a"});
  wrong.password = "guessed";
  EXPECT_THAT(refusal(wrong), AllOf(HasSubstr(broker_->url()), HasSubstr("refuses the user name"),
                                    HasSubstr("\"bench\"")));
}

TEST_F(FindingOutlets, TrustsNoBrokerWithoutItsOwnAuthorityNorUnderAnotherName) {
  auto other = gsbench::emulation::PrivateBroker::start({folder_.file("other"), {}});
  ASSERT_TRUE(other.ok()) << other.error();
  for (const std::string& ca_file : {other.value().ca_file(), std::string()}) {
    MqttOptions wrong = options({"a"});
    wrong.ca_file = ca_file;
    EXPECT_THAT(refusal(wrong), AllOf(HasSubstr(broker_->url()), HasSubstr("cannot be trusted")));
  }
  // The certificate is for 127.0.0.1 alone.
  MqttOptions wrong = options({"a"});
  wrong.url = "mqtts://localhost:" + std::to_string(broker_->port());
  EXPECT_THAT(refusal(wrong), AllOf(HasSubstr("localhost"), HasSubstr("certificate")));
}

TEST_F(FindingOutlets, SaysWhichBrokerCannotBeReached) {
  broker_->kill();
  EXPECT_THAT(refusal(options({"a"})), AllOf(HasSubstr(broker_->url()), HasSubstr("reached")));
}

TEST_F(FindingOutlets, AnOutletsLoginOpensNoLink) {
  const MqttOutlet a(*broker_, "a");
  MqttOptions wrong = options({"a"});
  wrong.user = broker_->outlet("b").user;
  wrong.password = broker_->outlet("b").password;
  MqttLink link(wrong);
  const auto opened = link.open();
  ASSERT_TRUE(opened.ok()) << opened.error();
  EXPECT_EQ(opened.value().front().fault, "is not on the broker");
  EXPECT_EQ(fault_of_a(), "");
}

}  // namespace
