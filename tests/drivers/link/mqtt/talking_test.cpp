// Messages both ways over a broker that works.
#include "outlets_on_a_broker.hpp"

#include <csignal>

namespace {

using gs::wire::Downlink;
using gs::wire::DownlinkKind;
using gs::wire::UplinkKind;
using gsbench::test::MqttOutlet;
using gsbench::test::OutletsOnABroker;
using testing::ElementsAre;
using testing::IsEmpty;

class TalkingToOutlets : public OutletsOnABroker {
 protected:
  // The broker reads its access list anew when told to.
  void forbid_commands() const {
    folder_.write("broker/access", "user bench\ntopic read gs/#\npattern readwrite gs/%u/#\n");
    ASSERT_EQ(kill(broker_->pid(), SIGHUP), 0);
  }
};

TEST_F(TalkingToOutlets, MeasurementsArriveOnceEachAndInOrder) {
  constexpr std::size_t kMeasurements = 500;
  MqttOutlet a(*broker_, "a");
  MqttOutlet b(*broker_, "b");
  open({"a", "b"});
  for (std::size_t i = 0; i < kMeasurements; ++i) {
    a.take_samples(128);
    b.take_samples(128);
  }
  ASSERT_TRUE(until([&] {
    return messages(0, UplinkKind::kMeasurement).size() >= kMeasurements &&
           messages(1, UplinkKind::kMeasurement).size() >= kMeasurements;
  }));
  for (const std::size_t outlet : {0U, 1U}) {
    const auto measurements = messages(outlet, UplinkKind::kMeasurement);
    ASSERT_EQ(measurements.size(), kMeasurements);
    for (std::size_t i = 1; i < kMeasurements; ++i) {
      EXPECT_EQ(measurements[i].message.sample, measurements[i - 1].message.sample + 128);
      EXPECT_GE(measurements[i].arrival_ns, measurements[i - 1].arrival_ns);
    }
    EXPECT_GT(measurements.front().arrival_ns, 0);
  }
  EXPECT_THAT(faults_, IsEmpty());
}

// What must arrive and what may be lost go by different rules of MQTT, and yet stay in order.
TEST_F(TalkingToOutlets, StatusesAndMeasurementsKeepTheirOrder) {
  constexpr std::size_t kRounds = 300;
  MqttOutlet a(*broker_, "a");
  open({"a"});
  for (std::size_t i = 0; i < kRounds; ++i) {
    a.tell_status();
    a.take_samples(127);
  }
  ASSERT_TRUE(until([&] { return messages(0, UplinkKind::kStatus).size() >= kRounds; }));
  ASSERT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() >= kRounds; }));
  EXPECT_TRUE(std::is_sorted(messages_.begin(), messages_.end(), [](const auto& x, const auto& y) {
    return x.message.sample < y.message.sample;
  }));
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_F(TalkingToOutlets, ACommandIsObeyedAndAnswered) {
  MqttOutlet a(*broker_, "a");
  MqttOutlet b(*broker_, "b");
  open({"a", "b"});
  Downlink command;
  command.kind = DownlinkKind::kCommand;
  command.close_relay = false;
  command.request = 4711;
  ASSERT_TRUE(link_->send(1, command).ok());
  ASSERT_TRUE(until([&] { return !messages(1, UplinkKind::kCommandAnswer).empty(); }));
  const auto answer = messages(1, UplinkKind::kCommandAnswer).front().message.command_answer;
  EXPECT_EQ(answer.request, 4711U);
  EXPECT_FALSE(answer.closed);
  EXPECT_FALSE(b.relay_closed());
  EXPECT_TRUE(a.relay_closed());
  EXPECT_THAT(messages(0, UplinkKind::kCommandAnswer), IsEmpty());
}

TEST_F(TalkingToOutlets, AnOutletThatIsThereNoMoreIsToldOnce) {
  MqttOutlet a(*broker_, "a");
  MqttOutlet b(*broker_, "b");
  open({"a", "b"});
  a.lose_power();
  ASSERT_TRUE(until([&] { return !faults(0).empty(); }));
  EXPECT_THAT(faults(0), ElementsAre("left the broker"));
  EXPECT_THAT(faults(1), IsEmpty());
}

TEST_F(TalkingToOutlets, AMessageToAnOutletThatLeftIsAFault) {
  MqttOutlet a(*broker_, "a");
  open({"a"});
  a.lose_power();
  ASSERT_TRUE(until([&] { return told(0, "left the broker"); }));
  ASSERT_TRUE(link_->send(0, Downlink{}).ok());
  EXPECT_TRUE(until([&] { return told(0, "was not sent a message: it is not on the broker"); }));
}

TEST_F(TalkingToOutlets, AMessageThatTheBrokerForbidsIsAFault) {
  MqttOutlet a(*broker_, "a");
  open({"a"});
  Downlink ping;
  ping.kind = DownlinkKind::kPing;
  ASSERT_TRUE(link_->send(0, ping).ok());
  ASSERT_TRUE(until([&] { return !messages(0, UplinkKind::kEcho).empty(); }));
  EXPECT_THAT(faults_, IsEmpty());
  forbid_commands();
  // Again and again: the broker follows the signal when it gets to it.
  EXPECT_TRUE(until([&] {
    EXPECT_TRUE(link_->send(0, ping).ok());
    return told(0, "does not allow");
  }));
}

TEST_F(TalkingToOutlets, AnOutletThatBeginsAnewIsToldAndHeard) {
  MqttOutlet a(*broker_, "a");
  open({"a"});
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() == 10; }));
  a.restart();
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() == 20; }));
  EXPECT_THAT(faults(0), ElementsAre("began anew after its sample 1280"));
}

TEST_F(TalkingToOutlets, ASecondOutletOfOneIdThatTurnsUpLaterIsAFault) {
  MqttOutlet one(*broker_, "a", 1);
  open({"a"});
  MqttOutlet two(*broker_, "a", 2);
  EXPECT_TRUE(until([&] { return told(0, "is there twice: 0x00000001 and 0x00000002"); }));
}

TEST_F(TalkingToOutlets, WhatAnOutletSaysInAnothersNameDoesNotReachTheBench) {
  MqttOutlet a(*broker_, "a");
  open({"a"});
  // Outlet b, with its own login, on the topics of a.
  auto options = gsbench::test::options_of(*broker_, "b", 9);
  options.id = "a";
  gs::host::MqttCarrier impostor;
  std::string why;
  ASSERT_TRUE(impostor.start(options, why)) << why;
  gs::wire::Uplink hello;
  gs::app::set_text(hello.hello.id, "a");
  std::uint8_t bytes[gs::wire::kLongestMessage];
  const std::size_t size = gs::wire::encode(hello, 0, bytes, sizeof bytes);
  ASSERT_TRUE(impostor.send(bytes, size));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (impostor.refused() == 0 && std::chrono::steady_clock::now() < end) {
    impostor.wait(std::chrono::milliseconds(1));
    impostor.serve();
  }
  EXPECT_EQ(impostor.refused(), 1U);
  // What came after it has come, so it would have, too.
  a.tell_status();
  ASSERT_TRUE(until([&] { return !messages(0, UplinkKind::kStatus).empty(); }));
  EXPECT_THAT(messages(0, UplinkKind::kHello), IsEmpty());
  EXPECT_THAT(faults_, IsEmpty());
}

}  // namespace
