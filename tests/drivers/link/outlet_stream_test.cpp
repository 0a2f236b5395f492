// How OutletStream handles messages in order, late and repeated messages, and restarts.
#include <wire_test/downlinks.hpp>
#include <wire_test/messages.hpp>

#include <gmock/gmock.h>

#include <link/outlet_stream.hpp>

namespace gsbench::link {
namespace {

using gs::wire::DownlinkKind;
using gs::wire::UplinkKind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint32_t kSession = 0x5E551011;

// A message, and whether take() returns it.
struct Coming {
  UplinkKind kind;
  std::uint32_t start;
  std::uint32_t sequence;
  std::uint64_t sample;
  bool taken = true;
  std::uint32_t next_number = 0;  // of a hello

  Coming dropped() const { return {kind, start, sequence, sample, false}; }
};

Coming hello(std::uint32_t start, std::uint32_t sequence = 0, std::uint32_t next_number = 0) {
  return {UplinkKind::kHello, start, sequence, 0, true, next_number};
}

Coming measurement(std::uint32_t start, std::uint32_t sequence) {
  return {UplinkKind::kMeasurement, start, sequence, 128 * (std::uint64_t{sequence} + 1)};
}

gs::wire::Uplink message_of(const Coming& coming, const char* id = "a") {
  gs::wire::Uplink uplink;
  uplink.kind = coming.kind;
  uplink.start_number = coming.start;
  uplink.sample = coming.sample;
  if (coming.kind == UplinkKind::kHello) {
    std::snprintf(uplink.hello.id, sizeof uplink.hello.id, "%s", id);
    uplink.hello.sample_rate_hz = 8000;
    uplink.hello.nominal_hz = 50;
    uplink.hello.next_number = coming.next_number;
  }
  return uplink;
}

bool takes(OutletStream& stream, const std::vector<std::uint8_t>& bytes) {
  return stream.take(bytes.data(), bytes.size()).has_value();
}

bool takes(OutletStream& stream, const Coming& coming, const char* id = "a") {
  return takes(stream, gs::wire::test::encoded(message_of(coming, id), coming.sequence));
}

// Passes all messages to a stream and returns the faults that it noted.
std::vector<std::string> faults_of(Delivery delivery, const std::vector<Coming>& all) {
  OutletStream stream(delivery, kSession);
  for (const Coming& coming : all) {
    EXPECT_EQ(takes(stream, coming), coming.taken)
        << to_string(coming.kind) << " " << coming.start << "/" << coming.sequence;
  }
  return stream.take_faults();
}

class EachDelivery : public testing::TestWithParam<Delivery> {};
INSTANTIATE_TEST_SUITE_P(OutletStream, EachDelivery,
                         testing::Values(Delivery::kByCable, Delivery::kByBroker));

TEST_P(EachDelivery, DropsRepeatedAndLateMessages) {
  EXPECT_THAT(
      faults_of(GetParam(), {hello(1), hello(1).dropped(), measurement(1, 0), measurement(1, 1),
                             measurement(1, 1).dropped(), hello(1).dropped(),
                             measurement(1, 0).dropped(), measurement(1, 2), hello(1, 1)}),
      IsEmpty());
}

TEST_P(EachDelivery, ReportsLostMessagesButNotLostHellos) {
  EXPECT_THAT(faults_of(GetParam(), {hello(1), measurement(1, 0), hello(1, 7), measurement(1, 3)}),
              ElementsAre("2 of its messages were lost before its sample 512"));
}

// Before its first connection, an outlet drops messages.
TEST_P(EachDelivery, DoesNotReportWhatWasSentBeforeTheNewestHello) {
  EXPECT_THAT(faults_of(GetParam(), {hello(1), hello(1, 3, 400), measurement(1, 400)}), IsEmpty());
}

TEST(OutletStream, ByBrokerDoesNotReportWhatWasDroppedBeforeTheConnection) {
  EXPECT_THAT(faults_of(Delivery::kByBroker, {hello(1), measurement(1, 5)}), IsEmpty());
}

TEST(OutletStream, OnACableTheFirstMessagesAfterAHelloCountAsLost) {
  constexpr Delivery kDelivery = Delivery::kByCable;
  EXPECT_THAT(faults_of(kDelivery, {hello(1, 3, 400), measurement(1, 402)}),
              ElementsAre("2 of its messages were lost before its sample 51584"));
  EXPECT_THAT(
      faults_of(kDelivery, {hello(1), measurement(1, 0), hello(1, 1, 3), measurement(1, 3)}),
      ElementsAre("2 of its messages were lost before its sample 512"));
}

TEST_P(EachDelivery, OtherStartNumbersAreRestartsWhateverTheNumbers) {
  EXPECT_THAT(faults_of(GetParam(), {hello(1, 0, 100), measurement(1, 100), hello(2, 0, 101),
                                     measurement(2, 101), hello(9, 5), measurement(9, 0)}),
              ElementsAre("restarted after its sample 12928", "restarted after its sample 13056"));
}

TEST_P(EachDelivery, MessagesOfAnEarlierStartAreLate) {
  EXPECT_THAT(faults_of(GetParam(), {hello(1), measurement(1, 0), hello(2), measurement(2, 0),
                                     hello(1).dropped(), hello(1, 1).dropped(),
                                     measurement(1, 1).dropped(), measurement(2, 1)}),
              ElementsAre("restarted after its sample 128"));
}

// An event may be stamped before the measurement that was sent ahead of it.
TEST_P(EachDelivery, ASampleThatGoesBackIsNoRestart) {
  const Coming event = {UplinkKind::kEvent, 1, 2, 200};
  const Coming aborted = {UplinkKind::kAborted, 1, 3, 0};
  EXPECT_THAT(faults_of(GetParam(), {hello(1), measurement(1, 0), measurement(1, 1), event, aborted,
                                     measurement(1, 4)}),
              IsEmpty());
}

TEST(OutletStream, ByBrokerTheFirstMessageOfAStartShowsTheRestart) {
  OutletStream stream(Delivery::kByBroker, kSession);
  EXPECT_TRUE(takes(stream, hello(1)));
  stream.take_wants_identify();
  EXPECT_TRUE(takes(stream, measurement(2, 0)));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("restarted")));
  EXPECT_TRUE(stream.take_wants_identify());
  EXPECT_TRUE(takes(stream, hello(2))) << "its hello came later, on another topic";
  EXPECT_THAT(stream.take_faults(), IsEmpty());
}

// It may be another outlet, which only its hello says.
TEST(OutletStream, OnACableMessagesWaitForTheHelloOfTheirStart) {
  OutletStream stream(Delivery::kByCable, kSession);
  EXPECT_TRUE(takes(stream, hello(1)));
  stream.take_wants_identify();
  EXPECT_FALSE(takes(stream, measurement(2, 0)));
  EXPECT_TRUE(stream.take_wants_identify());
  EXPECT_THAT(stream.take_faults(), IsEmpty());
  EXPECT_TRUE(takes(stream, hello(2, 1, 1)));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("restarted")));
  EXPECT_TRUE(takes(stream, measurement(2, 1)));
}

TEST(OutletStream, AnotherOutletOnTheCableHasNotRestarted) {
  OutletStream stream(Delivery::kByCable, kSession);
  EXPECT_TRUE(takes(stream, hello(1), "a"));
  EXPECT_TRUE(takes(stream, hello(2), "b"));
  EXPECT_TRUE(takes(stream, hello(1, 1), "a")) << "it was plugged in again";
  EXPECT_THAT(stream.take_faults(), IsEmpty());
}

TEST_P(EachDelivery, AUnitThatTakesThePlaceOfAnotherHasNotRestarted) {
  OutletStream stream(GetParam(), kSession);
  EXPECT_TRUE(takes(stream, hello(1)));
  EXPECT_TRUE(takes(stream, measurement(1, 0)));
  gs::wire::Uplink other = message_of(hello(2));
  other.hello.instance = 77;
  EXPECT_TRUE(takes(stream, gs::wire::test::encoded(other, 0)));
  EXPECT_THAT(stream.take_faults(), IsEmpty());
  EXPECT_TRUE(takes(stream, hello(1, 1))) << "the first is back";
  EXPECT_THAT(stream.take_faults(), IsEmpty());
  EXPECT_TRUE(takes(stream, hello(3)));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("restarted")));
}

TEST(OutletStream, ReportsUnreadableMessages) {
  OutletStream stream(Delivery::kByBroker, kSession);
  EXPECT_FALSE(takes(stream, {0xFF, 0x00}));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("cannot be read")));
  // Kind 99, number 0, sample 1, start 1.
  EXPECT_TRUE(takes(stream, hello(1)));
  EXPECT_FALSE(takes(stream, {0x84, 0x18, 0x63, 0x00, 0x01, 0x01}));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("unknown kind")));
  EXPECT_TRUE(takes(stream, measurement(1, 1)));
  EXPECT_THAT(stream.take_faults(), IsEmpty()) << "the unknown kind used up its number";
}

// ---- sessions

gs::wire::Downlink read(const std::vector<std::uint8_t>& bytes, std::uint32_t& sequence) {
  gs::wire::Downlink message;
  EXPECT_EQ(gs::wire::decode(bytes.data(), bytes.size(), message, sequence),
            gs::wire::Decoded::kOk);
  return message;
}

TEST(OutletStream, SendsItsSessionAndCountsOnThroughIdentify) {
  OutletStream stream(Delivery::kByBroker, kSession);
  for (std::uint32_t i = 0; i < 3; ++i) {
    std::uint32_t sequence = 99;
    EXPECT_EQ(read(stream.encode(gs::wire::identify()), sequence).session, kSession);
    EXPECT_EQ(sequence, i);
  }
  EXPECT_NE(new_session(), gs::wire::kNoSession);
  EXPECT_NE(new_session(), new_session());
}

TEST(OutletStream, ACommandIsForTheNewestStart) {
  OutletStream stream(Delivery::kByBroker, kSession);
  for (const std::uint32_t start : {7U, 8U}) {
    EXPECT_TRUE(takes(stream, hello(start)));
    std::uint32_t sequence = 0;
    const auto command = read(stream.encode(gs::wire::test::command(false, 5)), sequence);
    EXPECT_EQ(command.start_number, start);
    EXPECT_EQ(command.request, 5U);
  }
}

TEST(OutletStream, AsksForIdentifyUntilAHelloAnswersIt) {
  OutletStream stream(Delivery::kByCable, kSession);
  EXPECT_TRUE(takes(stream, hello(1)));
  EXPECT_FALSE(stream.is_open());
  EXPECT_TRUE(stream.take_wants_identify());
  EXPECT_FALSE(stream.take_wants_identify()) << "once";
  gs::wire::Uplink answer = message_of(hello(1));
  answer.hello.session = kSession + 1;
  EXPECT_TRUE(takes(stream, gs::wire::test::encoded(answer, 1)));
  EXPECT_FALSE(stream.is_open()) << "another centre's";
  answer.hello.session = kSession;
  EXPECT_TRUE(takes(stream, gs::wire::test::encoded(answer, 2)));
  EXPECT_TRUE(stream.is_open());
  EXPECT_FALSE(stream.take_wants_identify());
  EXPECT_TRUE(takes(stream, hello(2)));
  EXPECT_FALSE(stream.is_open()) << "it has restarted";
  EXPECT_TRUE(stream.take_wants_identify());
}

TEST(OutletStream, OnACableAsksForIdentifyOnceForEachStart) {
  OutletStream stream(Delivery::kByCable, kSession);
  for (const std::uint32_t start : {1U, 2U}) {
    gs::wire::Uplink answer = message_of(hello(start));
    for (std::uint32_t i = 0; i < 3; ++i) {
      EXPECT_FALSE(takes(stream, measurement(start, i)));
      EXPECT_EQ(stream.take_wants_identify(), i == 0) << start << "/" << i;
      EXPECT_FALSE(stream.is_open());
    }
    EXPECT_TRUE(takes(stream, gs::wire::test::encoded(answer, 0)));
    EXPECT_FALSE(stream.take_wants_identify()) << "the link repeats it";
    EXPECT_FALSE(stream.is_open());
    answer.hello.session = kSession;
    EXPECT_TRUE(takes(stream, gs::wire::test::encoded(answer, 1)));
    EXPECT_TRUE(stream.is_open());
  }
}

TEST(OutletStream, BeginsItsSessionAgainWhenTheOutletDoesNotKnowIt) {
  OutletStream stream(Delivery::kByBroker, kSession);
  EXPECT_TRUE(takes(stream, hello(1)));
  stream.take_wants_identify();
  gs::wire::Uplink error = message_of({UplinkKind::kError, 1, 0, 0});
  error.error = {gs::wire::ErrorCode::kUnknownSession, kSession + 1};
  EXPECT_TRUE(takes(stream, gs::wire::test::encoded(error, 0)));
  EXPECT_FALSE(stream.take_wants_identify()) << "it concerns another centre";
  EXPECT_THAT(stream.take_faults(), IsEmpty());
  error.error.detail = kSession;
  EXPECT_TRUE(takes(stream, gs::wire::test::encoded(error, 1)));
  EXPECT_TRUE(stream.take_wants_identify());
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("did not take a message")));
}

}  // namespace
}  // namespace gsbench::link
