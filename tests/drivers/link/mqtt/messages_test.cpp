// Messages over a broker: forbidden ones, restarts, and outlets that leave, return or use another's
// id.
#include "outlets_on_a_broker.hpp"

#include <csignal>
#include <optional>
#include <utility>

namespace gsbench::test {
namespace {

using gs::wire::UplinkKind;
using testing::ElementsAre;
using testing::IsEmpty;

class Broker : public OutletsOnABroker {
 protected:
  // SIGHUP makes the broker reload its access list.
  void forbid_commands() const {
    folder_.write("broker/access", "user bench\ntopic read gs/#\npattern readwrite gs/%u/#\n");
    ASSERT_EQ(kill(broker_.pid(), SIGHUP), 0);
  }
};

TEST_F(Broker, AForbiddenMessageIsAFault) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  ASSERT_TRUE(answers(kA));
  EXPECT_THAT(faults_, IsEmpty());
  forbid_commands();
  // Repeated, because the broker handles the signal later.
  EXPECT_TRUE(until([&] {
    send(kA, ping(2));
    return reported(kA, "does not allow");
  }));
}

TEST_F(Broker, ARestartOnTheSameConnectionIsReported) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(kA, UplinkKind::kMeasurement).size() == 10; }));
  a.restart();
  a.take_samples(1280);
  ASSERT_TRUE(until([&] { return messages(kA, UplinkKind::kMeasurement).size() == 20; }));
  EXPECT_THAT(faults(kA), ElementsAre("restarted after its sample 1280"));
}

// As a broker or a reconnecting centre may do with messages of QoS 1.
TEST_F(Broker, MessagesThatArriveAgainHaveNoEffect) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  for (const bool close : {false, true}) {
    send(kA, command(close));
  }
  ASSERT_TRUE(answers(kA));
  a.receive_all_again();
  ASSERT_TRUE(answers(kA, 2));
  EXPECT_EQ(messages(kA, UplinkKind::kRelay).size(), 2U);
  EXPECT_EQ(messages(kA, UplinkKind::kCommandAnswer).size(), 2U);
  EXPECT_TRUE(a.relay_closed());
  EXPECT_THAT(faults_, IsEmpty());
}

// The same to an outlet that has restarted: its relay is closed, and stays so.
TEST_F(Broker, CommandsToAnEarlierStartHaveNoEffect) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  send(kA, command(false));
  ASSERT_TRUE(answers(kA));
  ASSERT_FALSE(a.relay_closed());
  a.restart();
  a.receive_all_again();
  ASSERT_TRUE(answers(kA, 2));
  EXPECT_TRUE(a.relay_closed());
  send(kA, command(false));
  ASSERT_TRUE(answers(kA, 3));
  EXPECT_FALSE(a.relay_closed());
}

TEST_F(Broker, TwoCentresServeOneOutlet) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  for (std::uint32_t token = 1; token <= 5; ++token) {
    ASSERT_TRUE(answers(kA, token));
  }
  std::shared_ptr<link::Link> other = link_;
  open({"a"});
  send(kA, command(false, 1));
  ASSERT_TRUE(answers(kA, 6));
  EXPECT_FALSE(a.relay_closed());
  std::swap(link_, other);
  send(kA, command(true, 1));
  ASSERT_TRUE(answers(kA, 7));
  EXPECT_TRUE(a.relay_closed()) << "the request of another session";
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_F(Broker, AnOutletMayTakeThePlaceOfOneThatHasLeft) {
  std::optional<MqttOutlet> one(std::in_place, broker_, "a", 1U);
  open({"a"});
  one.reset();
  ASSERT_TRUE(is_reported(kA, "left the broker"));
  MqttOutlet two(broker_, "a", 2);
  expect_joins(2);
  EXPECT_THAT(faults(kA), ElementsAre("left the broker")) << "no restart";
}

TEST_F(Broker, AnOutletThatLeavesAndReturnsAtOnceJoinsLast) {
  std::optional<MqttOutlet> one(std::in_place, broker_, "a", 1U);
  open({"a"});
  one.reset();
  MqttOutlet two(broker_, "a", 1);
  // Both are on the broker's way before the bench looks.
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  ASSERT_TRUE(until([&] { return changes_.size() == 2; }));
  EXPECT_TRUE(std::holds_alternative<link::Fault>(changes_[0]));
  EXPECT_TRUE(std::holds_alternative<link::OutletPresence>(changes_[1]));
}

// One unit that says hellos of its own making.
class ExcludedForItsHello : public Broker {
 protected:
  void SetUp() override {
    std::string why;
    ASSERT_TRUE(carrier_.start(options_of(broker_, "a", 9), why)) << why;
    gs::app::set_text(hello_.hello.id, "a");
    hello_.kind = UplinkKind::kHello;
    hello_.hello.instance = 9;
    hello_.hello.sample_rate_hz = 8000;
    hello_.hello.nominal_hz = 50;
    ASSERT_TRUE(test::until([&] {
      carrier_.serve();
      return carrier_.connected();
    }));
    LinkFixture::open(std::make_shared<link::MqttLink>(options({"a"})), {},
                      std::chrono::milliseconds(0));
  }

  void say(std::uint16_t version, std::uint32_t start, std::uint32_t sequence) {
    hello_.hello.protocol_version = version;
    hello_.start_number = start;
    std::uint8_t bytes[gs::wire::kLongestMessage];
    EXPECT_TRUE(carrier_.send(bytes, gs::wire::encode(hello_, sequence, bytes, sizeof bytes)));
  }
  bool changes(std::size_t count) {
    return until([&] {
      carrier_.serve();
      return changes_.size() >= count;
    });
  }

  gs::host::MqttCarrier carrier_;
  gs::wire::Uplink hello_;
};

TEST_F(ExcludedForItsHello, ItJoinsAgainWithTheRightVersion) {
  say(2, 5, 0);
  say(2, 5, 1);
  say(2, 6, 0);
  say(3, 7, 0);
  say(2, 8, 0);
  say(2, 8, 1);
  ASSERT_TRUE(changes(3));
  ASSERT_EQ(joined_.size(), 3U) << "once with each version";
  EXPECT_EQ(joined_[0].fault, "uses protocol version 2, not 3");
  EXPECT_EQ(joined_[1].fault, "");
  EXPECT_EQ(joined_[2].fault, "uses protocol version 2, not 3");
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_F(ExcludedForItsHello, ItJoinsAgainWithTheRightId) {
  gs::app::set_text(hello_.hello.id, "b");
  say(3, 5, 0);
  say(3, 5, 1);
  gs::app::set_text(hello_.hello.id, "a");
  say(3, 5, 2);
  say(3, 6, 0);
  ASSERT_TRUE(changes(2));
  ASSERT_EQ(joined_.size(), 2U) << "not with a hello of the same start";
  EXPECT_EQ(joined_[0].fault, "reports another id there: \"b\"");
  EXPECT_EQ(joined_[1].fault, "");
  EXPECT_EQ(joined_[1].start_number, 6U);
}

TEST_F(Broker, AnOutletCannotSendUnderAnotherId) {
  MqttOutlet a(broker_, "a");
  open({"a"});
  // Outlet b, with its own login, on the topics of a.
  auto options = options_of(broker_, "b", 9);
  options.id = "a";
  gs::host::MqttCarrier impostor;
  std::string why;
  ASSERT_TRUE(impostor.start(options, why)) << why;
  gs::wire::Uplink hello;
  gs::app::set_text(hello.hello.id, "a");
  std::uint8_t bytes[gs::wire::kLongestMessage];
  const std::size_t size = gs::wire::encode(hello, 0, bytes, sizeof bytes);
  ASSERT_TRUE(impostor.send(bytes, size));
  std::uint32_t refused = 0;
  ASSERT_TRUE(test::until([&] {
    impostor.serve();
    refused += impostor.take_unsent();
    return refused > 0;
  }));
  EXPECT_EQ(refused, 1U);
  // A later message has arrived, so the impostor's would have arrived too.
  a.report_status();
  ASSERT_TRUE(until([&] { return !messages(kA, UplinkKind::kStatus).empty(); }));
  EXPECT_THAT(messages(kA, UplinkKind::kHello), IsEmpty());
  EXPECT_THAT(faults_, IsEmpty());
}

}  // namespace
}  // namespace gsbench::test
