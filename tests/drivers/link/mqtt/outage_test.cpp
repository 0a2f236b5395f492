// A broker that dies and comes back.
#include "outlets_on_a_broker.hpp"

namespace {

using gs::wire::Downlink;
using gs::wire::DownlinkKind;
using gs::wire::UplinkKind;
using gsbench::test::MqttOutlet;
using gsbench::test::OutletsOnABroker;
using testing::IsEmpty;

class BrokerOutage : public OutletsOnABroker {
 protected:
  static std::ptrdiff_t times(const std::vector<std::string>& faults, const std::string& words) {
    return std::count_if(faults.begin(), faults.end(), [&](const std::string& fault) {
      return fault.find(words) != std::string::npos;
    });
  }
};

TEST_F(BrokerOutage, LosesNoneOfWhatMustArriveAndRepeatsNone) {
  constexpr std::size_t kStatuses = 600;
  MqttOutlet a(*broker_, "a");
  MqttOutlet b(*broker_, "b");
  open({"a", "b"});
  for (std::size_t i = 0; i < kStatuses; ++i) {
    a.tell_status();
    b.tell_status();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (i == kStatuses / 3) {
      broker_->kill();
    }
    if (i == kStatuses / 2) {
      const auto restarted = broker_->restart();
      ASSERT_TRUE(restarted.ok()) << restarted.error();
    }
  }
  EXPECT_TRUE(until([&] {
    return messages(0, UplinkKind::kStatus).size() >= kStatuses &&
           messages(1, UplinkKind::kStatus).size() >= kStatuses;
  }));
  for (const std::size_t outlet : {0U, 1U}) {
    const auto statuses = messages(outlet, UplinkKind::kStatus);
    ASSERT_EQ(statuses.size(), kStatuses) << testing::PrintToString(faults(outlet));
    for (std::size_t i = 1; i < kStatuses; ++i) {
      ASSERT_EQ(statuses[i].message.sample, statuses[i - 1].message.sample + 1);
    }
    EXPECT_EQ(times(faults(outlet), "has lost its broker"), 1);
    EXPECT_EQ(times(faults(outlet), "has its broker back"), 1);
    EXPECT_EQ(times(faults(outlet), "began anew"), 0);
    EXPECT_EQ(times(faults(outlet), "were lost"), 0);
  }
}

TEST_F(BrokerOutage, CommandsAreObeyedAgainAfterwards) {
  MqttOutlet a(*broker_, "a");
  open({"a"});
  broker_->kill();
  ASSERT_TRUE(until([&] { return told(0, "has lost its broker"); }));
  ASSERT_TRUE(broker_->restart().ok());
  // Both ends are back once the outlet's new hello has come.
  ASSERT_TRUE(until(
      [&] { return told(0, "has its broker back") && !messages(0, UplinkKind::kHello).empty(); }));
  Downlink command;
  command.kind = DownlinkKind::kCommand;
  command.close_relay = false;
  command.request = 1;
  ASSERT_TRUE(link_->send(0, command).ok());
  EXPECT_TRUE(until([&] { return !messages(0, UplinkKind::kCommandAnswer).empty(); }));
  EXPECT_FALSE(a.relay_closed());
}

TEST_F(BrokerOutage, MeasurementsThatWereLostAreCounted) {
  MqttOutlet a(*broker_, "a");
  open({"a"});
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() == 10; }));
  broker_->kill();
  ASSERT_TRUE(until([&] { return !a.connected(); }));
  a.take_samples(2560);
  ASSERT_TRUE(broker_->restart().ok());
  ASSERT_TRUE(until([&] { return a.connected() && told(0, "has its broker back"); }));
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() == 20; }));
  EXPECT_TRUE(told(0, "20 of its messages were lost"));
}

}  // namespace
