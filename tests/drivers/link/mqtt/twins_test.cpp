// Two units with the same id on a broker: of different instances, or of one.
#include "arrivals.hpp"
#include "outlets_on_a_broker.hpp"

#include <optional>
#include <utility>

namespace gsbench::test {
namespace {

using gs::wire::UplinkKind;

using TwinsOnABroker = OutletsOnABroker;

TEST_F(TwinsOnABroker, ALaterOutletWithTheSameIdIsAFault) {
  MqttOutlet one(broker_, "a", 1);
  open({"a"});
  MqttOutlet two(broker_, "a", 2);
  EXPECT_TRUE(
      is_reported(kA, "has the same id as another outlet: instances 0x00000001 and 0x00000002"));
}

TEST_F(TwinsOnABroker, AnOutletMayTakeThePlaceOfTwoWithTheSameIdOnceTheyHaveLeft) {
  {
    MqttOutlet one(broker_, "a", 1);
    open({"a"});
    MqttOutlet two(broker_, "a", 2);
    ASSERT_TRUE(is_reported(kA, "instances 0x00000001 and 0x00000002"));
  }
  MqttOutlet three(broker_, "a", 3);
  expect_joins(3);
}

// They have the same client id: the broker lets only one of them be connected.
TEST_F(TwinsOnABroker, TwoOutletsThatEndEachOthersConnectionAreAFaultAndExcluded) {
  MqttOutlet one(broker_, "a", 1);
  open({"a"});
  MqttOutlet two(broker_, "a", 1);
  EXPECT_TRUE(
      is_reported(kA,
                  "has the same id as another outlet: both have instance 0x00000001, and each "
                  "ends the other's connection to the broker"));
  const std::size_t reports = faults(kA).size();
  EXPECT_LE(reports, 10U) << testing::PrintToString(faults(kA));
  MqttOutlet b(broker_, "b");
  std::this_thread::sleep_for(std::chrono::seconds(2));  // they go on
  poll();
  EXPECT_EQ(faults(kA).size(), reports) << testing::PrintToString(faults(kA));
}

TEST_F(TwinsOnABroker, AnOutletThatRestartsAndConnectsAgainOftenIsNoTwin) {
  for (int i = 0; i < 6; ++i) {
    std::optional<MqttOutlet> a(std::in_place, broker_, "a", 1U);
    if (i == 0) {
      open({"a"});
    }
    ASSERT_TRUE(until([&] { return joined_.size() >= static_cast<std::size_t>(i); }));
    a->restart();
    a->report_status();
    ASSERT_TRUE(arrives(kA, UplinkKind::kStatus, static_cast<std::size_t>(i) + 1));
    a.reset();
    ASSERT_TRUE(until([&] {
      const std::vector<std::string> all = faults(kA);
      return std::count(all.begin(), all.end(), "left the broker") == i + 1;
    }));
  }
  EXPECT_FALSE(reported(kA, "has the same id"));
}

TEST_F(TwinsOnABroker, AnOutletWhoseHellosOvertakeThoseOfTheStartBeforeIsNoTwin) {
  MqttOutlet a(broker_, "a", 1);
  open({"a"});
  gs::host::MqttCarrier carrier;  // of the same unit, after its restarts
  std::string why;
  ASSERT_TRUE(carrier.start(options_of(broker_, "a", 9), why)) << why;
  gs::wire::Uplink hello;
  hello.kind = UplinkKind::kHello;
  hello.hello = present(kA).hello;
  const auto say = [&](std::uint32_t start, std::uint32_t sequence) {
    hello.start_number = start;
    std::uint8_t bytes[gs::wire::kLongestMessage];
    EXPECT_TRUE(carrier.send(bytes, gs::wire::encode(hello, sequence, bytes, sizeof bytes)));
  };
  for (const std::uint32_t sequence : {0U, 1U, 2U, 3U}) {
    say(77, sequence);
    say(78, sequence);
  }
  say(79, 0);
  EXPECT_TRUE(until([&] {
    carrier.serve();
    const auto hellos = messages(kA, UplinkKind::kHello);
    return !hellos.empty() && hellos.back().message.start_number == 79;
  }));
  EXPECT_FALSE(reported(kA, "has the same id"));
}

// The last message of the one that is removed takes the hello of both from the broker.
TEST_F(TwinsOnABroker, TheOneThatStaysJoinsAgain) {
  MqttOutlet one(broker_, "a", 1);
  open({"a"});
  std::optional<MqttOutlet> two(std::in_place, broker_, "a", 2U);
  ASSERT_TRUE(is_reported(kA, "instances 0x00000001 and 0x00000002"));
  one.take_samples(1280);
  two.reset();
  expect_joins(1);
  one.take_samples(1280);
  EXPECT_TRUE(arrives(kA, UplinkKind::kMeasurement, 10));
  EXPECT_FALSE(reported(kA, "were lost")) << "what was not taken is not lost";
  EXPECT_FALSE(reported(kA, "restarted"));
}

TEST_F(TwinsOnABroker, ALaterLinkFindsTheOneThatStaysByItsName) {
  const MqttOutlet one(broker_, "a", 1);
  std::optional<MqttOutlet> two(std::in_place, broker_, "a", 2U);
  two.reset();
  open({"a"});
  EXPECT_EQ(present(kA).fault, "");
  EXPECT_EQ(present(kA).hello.instance, 1U);
  EXPECT_TRUE(answers(kA));
}

TEST_F(TwinsOnABroker, ALaterLinkFindsTheOneThatStaysByItsMeasurements) {
  MqttOutlet one(broker_, "a", 1);
  std::optional<MqttOutlet> two(std::in_place, broker_, "a", 2U);
  two.reset();
  LinkFixture::open(std::make_shared<link::MqttLink>(options({})), {},
                    std::chrono::milliseconds(0));
  ASSERT_TRUE(until([&] {
    one.take_samples(128);
    return !joined_.empty();
  }));
  EXPECT_EQ(joined_[0].hello.instance, 1U);
  EXPECT_TRUE(answers(kA));
}

TEST(UnitsOfOneId, ThatTakeEachOthersPlaceAgainAndAgainAreNoTwins) {
  link::Arrivals arrivals;
  const auto take = [&](const std::vector<std::uint8_t>& bytes) {
    arrivals.take("gs/a/hello", bytes.data(), bytes.size(), false);
  };
  gs::wire::Uplink hello;
  hello.kind = UplinkKind::kHello;
  gs::app::set_text(hello.hello.id, "a");
  hello.hello.sample_rate_hz = 8000;
  hello.hello.nominal_hz = 50;
  for (const std::uint32_t sequence : {0U, 1U, 2U, 3U}) {
    for (const std::uint32_t unit : {1U, 2U}) {
      hello.hello.instance = unit;
      hello.start_number = 100 * unit;
      std::vector<std::uint8_t> bytes(gs::wire::kLongestMessage);
      bytes.resize(gs::wire::encode(hello, sequence, bytes.data(), bytes.size()));
      take(bytes);
      take({});
    }
  }
  link::Happenings happenings;
  arrivals.hand_over(happenings);
  EXPECT_THAT(happenings.faults, testing::IsEmpty());
  ASSERT_EQ(happenings.changes.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(std::holds_alternative<link::OutletPresence>(happenings.changes[i]), i % 2 == 0) << i;
  }
}

}  // namespace
}  // namespace gsbench::test
