// A broker that dies and comes back.
#include "outlets_on_a_broker.hpp"

#include <filesystem>

namespace gsbench::test {
namespace {

using gs::wire::UplinkKind;
using link::MqttLink;

class BrokerOutage : public OutletsOnABroker {
 protected:
  // Until the broker has written down that there is a bench.
  bool remembered() {
    const auto opened = std::filesystem::file_time_type::clock::now();
    return until([&] {
      std::error_code missing;
      return std::filesystem::last_write_time(broker_.memory_file(), missing) > opened;
    });
  }

  static std::ptrdiff_t times(const std::vector<std::string>& faults, const std::string& words) {
    return std::count_if(faults.begin(), faults.end(), [&](const std::string& fault) {
      return fault.find(words) != std::string::npos;
    });
  }
};

TEST_F(BrokerOutage, LosesNoneOfWhatMustArriveAndRepeatsNone) {
  constexpr std::size_t kStatuses = 600;
  MqttOutlet a(broker_, "a");
  MqttOutlet b(broker_, "b");
  open({"a", "b"});
  ASSERT_TRUE(remembered());
  for (std::size_t i = 0; i < kStatuses; ++i) {
    if (i == kStatuses / 3) {
      // A broker takes with it what it has acknowledged and not passed on yet; MQTT promises no
      // more. All of that has come.
      ASSERT_TRUE(until([&] {
        return messages(kA, UplinkKind::kStatus).size() == i &&
               messages(kB, UplinkKind::kStatus).size() == i;
      }));
      broker_.kill();
    }
    if (i == kStatuses / 2) {  // the rest is said while outlets and bench come back, in any order
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
  // What waits for the bench comes before the broker's answer to its subscription.
  EXPECT_TRUE(is_reported(kA, "has its broker back"));
  for (const char* const outlet : {kA, kB}) {
    const auto statuses = messages(outlet, UplinkKind::kStatus);
    ASSERT_EQ(statuses.size(), kStatuses) << testing::PrintToString(faults(outlet));
    for (std::size_t i = 1; i < kStatuses; ++i) {
      ASSERT_EQ(statuses[i].message.sample, statuses[i - 1].message.sample + 1);
    }
    EXPECT_EQ(times(faults(outlet), "has lost its broker"), 1);
    EXPECT_EQ(times(faults(outlet), "has its broker back"), 1);
    EXPECT_EQ(times(faults(outlet), "restarted"), 0);
    // Measurements may be lost, one in 128 samples, but not without a word.
    const auto measurements = messages(outlet, UplinkKind::kMeasurement).size();
    EXPECT_EQ(times(faults(outlet), "1 of its messages were lost"),
              static_cast<std::ptrdiff_t>(kStatuses / 128 - measurements));
  }
}

TEST_F(BrokerOutage, CommandsAreObeyedAgainAfterwards) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  broker_.kill();
  ASSERT_TRUE(is_reported(kA, "has lost its broker"));
  demand(broker_.restart());
  // Both ends are back once the outlet's new hello has come.
  ASSERT_TRUE(until([&] {
    return reported(kA, "has its broker back") && !messages(kA, UplinkKind::kHello).empty();
  }));
  send(kA, command(false));
  EXPECT_TRUE(until([&] { return !messages(kA, UplinkKind::kCommandAnswer).empty(); }));
  EXPECT_FALSE(a.relay_closed());
}

// It still counts the messages of the bench before, until the next one identifies it.
TEST_F(BrokerOutage, AnOutletThatComesBackLateListensToTheNextBench) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  ASSERT_TRUE(answers(kA, 1));
  ASSERT_TRUE(answers(kA, 2));
  link_.reset();
  broker_.kill();
  std::filesystem::remove(broker_.memory_file());
  ASSERT_TRUE(test::until([&] { return !a.connected(); }));
  demand(broker_.restart());
  HearsALink::open(std::make_shared<MqttLink>(options({"a"})), {"a"}, std::chrono::milliseconds(1));
  ASSERT_TRUE(until([&] { return present(kA).fault.empty() || !joined_.empty(); }));
  EXPECT_TRUE(answers(kA, 3));
}

TEST_F(BrokerOutage, MeasurementsThatWereLostAreCounted) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(kA, UplinkKind::kMeasurement).size() == 10; }));
  broker_.kill();
  ASSERT_TRUE(until([&] { return !a.connected(); }));
  a.take_samples(2560);
  demand(broker_.restart());
  ASSERT_TRUE(until([&] { return a.connected() && reported(kA, "has its broker back"); }));
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(kA, UplinkKind::kMeasurement).size() == 20; }));
  EXPECT_TRUE(reported(kA, "20 of its messages were lost"));
}

}  // namespace
}  // namespace gsbench::test
