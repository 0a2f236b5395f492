// A broker that is killed and restarted.
#include "outlets_on_a_broker.hpp"

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace gsbench::test {
namespace {

using gs::wire::UplinkKind;
using link::MqttLink;

class BrokerOutage : public OutletsOnABroker {
 protected:
  // Waits until the broker has saved the bench's session.
  bool session_saved() {
    const auto opened = std::filesystem::file_time_type::clock::now();
    return until([&] {
      std::error_code missing;
      return std::filesystem::last_write_time(broker_.memory_file(), missing) > opened;
    });
  }

  // From the next start of the broker. Its access list cannot do that; a plugin of it can.
  void forbid_subscriptions() const {
    const std::string plugin = "mosquitto_dynamic_security.so";
    std::string path;
    for (const auto& folder : std::filesystem::directory_iterator("/usr/lib")) {
      const std::string candidate = folder.path() / plugin;
      path = std::filesystem::exists(candidate) ? candidate : path;
    }
    ASSERT_NE(path, "") << plugin << " belongs to Mosquitto";
    const std::string rights = folder_.write(
        "rights.json",
        R"({"defaultACLAccess": {"publishClientSend": true, "publishClientReceive": true,
                                 "subscribe": false, "unsubscribe": true}})");
    std::istringstream before(folder_.read("broker/mosquitto.conf"));
    std::string after = "plugin " + path + "\nplugin_opt_config_file " + rights + '\n';
    for (std::string line; std::getline(before, line);) {
      after += line.rfind("acl_file", 0) == 0 ? "" : line + '\n';
    }
    folder_.write("broker/mosquitto.conf", after);
  }

  // The most bytes of one connection that the broker has received and not read.
  std::uint32_t most_unread() const {
    std::ostringstream port;
    port << std::hex << std::uppercase << ':' << broker_.port();
    std::ifstream connections("/proc/net/tcp");
    std::uint32_t most = 0;
    for (std::string line; std::getline(connections, line);) {
      std::istringstream row(line);
      std::string number;
      std::string local;
      std::string remote;
      std::string state;
      std::string queues;  // to send and received, hexadecimal
      row >> number >> local >> remote >> state >> queues;
      if (local.size() > 8 && local.substr(8) == port.str() && state == "01") {
        most = std::max(most, static_cast<std::uint32_t>(
                                  std::stoul(queues.substr(queues.find(':') + 1), nullptr, 16)));
      }
    }
    return most;
  }

  static std::ptrdiff_t times(const std::vector<std::string>& faults, const std::string& words) {
    return std::count_if(faults.begin(), faults.end(), [&](const std::string& fault) {
      return fault.find(words) != std::string::npos;
    });
  }
};

TEST_F(BrokerOutage, StatusMessagesAreNeitherLostNorRepeated) {
  constexpr std::size_t kStatuses = 600;
  MqttOutlet a(broker_, "a");
  MqttOutlet b(broker_, "b");
  open({"a", "b"});
  ASSERT_TRUE(session_saved());
  for (std::size_t i = 0; i < kStatuses; ++i) {
    if (i == kStatuses / 3) {
      // A killed broker loses messages that it has acknowledged but not delivered; MQTT does not
      // prevent that. So wait until all have arrived.
      ASSERT_TRUE(until([&] {
        return messages(kA, UplinkKind::kStatus).size() == i &&
               messages(kB, UplinkKind::kStatus).size() == i;
      }));
      broker_.kill();
    }
    if (i == kStatuses / 2) {  // the rest is sent while outlets and bench reconnect, in any order
      demand(broker_.restart());
    }
    a.report_status();
    b.report_status();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(until([&] {
    return messages(kA, UplinkKind::kStatus).size() >= kStatuses &&
           messages(kB, UplinkKind::kStatus).size() >= kStatuses;
  }));
  // Stored messages arrive before the broker confirms the subscription.
  EXPECT_TRUE(is_reported(kA, "is connected to its broker again"));
  for (const char* const outlet : {kA, kB}) {
    const auto statuses = messages(outlet, UplinkKind::kStatus);
    ASSERT_EQ(statuses.size(), kStatuses) << testing::PrintToString(faults(outlet));
    for (std::size_t i = 1; i < kStatuses; ++i) {
      ASSERT_EQ(statuses[i].message.sample, statuses[i - 1].message.sample + 1);
    }
    EXPECT_EQ(times(faults(outlet), "lost its broker"), 1);
    EXPECT_EQ(times(faults(outlet), "is connected to its broker again"), 1);
    EXPECT_EQ(times(faults(outlet), "restarted"), 0);
    // Measurements (one each 128 samples) may be lost, but each loss is reported.
    const auto measurements = messages(outlet, UplinkKind::kMeasurement).size();
    EXPECT_EQ(times(faults(outlet), "1 of its messages were lost"),
              static_cast<std::ptrdiff_t>(kStatuses / 128 - measurements));
  }
}

TEST_F(BrokerOutage, OutletsObeyCommandsAfterwards) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  broker_.kill();
  ASSERT_TRUE(is_reported(kA, "lost its broker"));
  demand(broker_.restart());
  // Both ends are connected again once the outlet's new hello has arrived.
  ASSERT_TRUE(until([&] {
    return reported(kA, "is connected to its broker again") &&
           !messages(kA, UplinkKind::kHello).empty();
  }));
  send(kA, command(false));
  EXPECT_TRUE(until([&] { return !messages(kA, UplinkKind::kCommandAnswer).empty(); }));
  EXPECT_FALSE(a.relay_closed());
}

// A bench that keeps no session sends nothing again. A message that has not left waits for the next
// connection, so the broker is killed when it has received some of them.
TEST_F(BrokerOutage, AMessageThatTheBrokerDidNotConfirmIsAFaultWithTheReason) {
  const MqttOutlet a(broker_, "a");
  link::MqttOptions forgetful = options({"a"});
  forgetful.keeps_session = false;
  LinkFixture::open(std::make_shared<MqttLink>(forgetful), {"a"});
  ASSERT_EQ(::kill(broker_.pid(), SIGSTOP), 0);
  for (std::uint32_t token = 1; token <= 50; ++token) {
    send(kA, ping(token));
  }
  ASSERT_TRUE(test::until([&] { return most_unread() > 1000; }));  // more than acknowledgements
  broker_.kill();
  EXPECT_TRUE(is_reported(kA,
                          "was not sent a message: the connection to the broker broke before "
                          "the broker confirmed it"));
}

TEST_F(BrokerOutage, ASubscriptionThatIsRefusedAfterwardsIsAFault) {
  const MqttOutlet a(broker_, "a");
  open({"a"});
  broker_.kill();
  forbid_subscriptions();
  demand(broker_.restart());
  ASSERT_TRUE(is_reported(kA,
                          "is not heard any more: the broker does not allow the user \"bench\" "
                          "to subscribe to its messages"));
  EXPECT_FALSE(reported(kA, "is connected to its broker again"));
  broker_.kill();
  EXPECT_TRUE(until([&] { return times(faults(kA), "lost its broker") == 2; }));
  EXPECT_EQ(times(faults(kA), "is not heard"), 1);
}

// The outlet expects the previous bench's sequence numbers until the next bench sends `identify`.
TEST_F(BrokerOutage, AReturningOutletAnswersTheNextBench) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  ASSERT_TRUE(answers(kA, 1));
  ASSERT_TRUE(answers(kA, 2));
  link_.reset();
  broker_.kill();
  std::filesystem::remove(broker_.memory_file());
  ASSERT_TRUE(test::until([&] { return !a.connected(); }));
  demand(broker_.restart());
  LinkFixture::open(std::make_shared<MqttLink>(options({"a"})), {"a"},
                    std::chrono::milliseconds(1));
  ASSERT_TRUE(until([&] { return present(kA).fault.empty() || !joined_.empty(); }));
  EXPECT_TRUE(answers(kA, 3));
}

TEST_F(BrokerOutage, LostMeasurementsAreCounted) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(kA, UplinkKind::kMeasurement).size() == 10; }));
  broker_.kill();
  ASSERT_TRUE(until([&] { return !a.connected(); }));
  a.take_samples(2560);
  demand(broker_.restart());
  ASSERT_TRUE(
      until([&] { return a.connected() && reported(kA, "is connected to its broker again"); }));
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(kA, UplinkKind::kMeasurement).size() == 20; }));
  EXPECT_TRUE(reported(kA, "20 of its messages were lost"));
}

}  // namespace
}  // namespace gsbench::test
