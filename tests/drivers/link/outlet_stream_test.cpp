// How OutletStream handles messages in order, repeated messages and restarts of the outlet.
#include <wire_test/messages.hpp>

#include <gmock/gmock.h>

#include <link/outlet_stream.hpp>

namespace gsbench::link {
namespace {

using gs::wire::UplinkKind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A message, and whether take() returns it.
struct Coming {
  UplinkKind kind;
  std::uint64_t sample;
  std::uint32_t sequence;
  bool taken = true;
};

constexpr Coming kHello = {UplinkKind::kHello, 0, 0};

Coming measurement(std::uint32_t sequence, bool taken = true) {
  return {UplinkKind::kMeasurement, 128 * sequence, sequence, taken};
}

bool takes(OutletStream& stream, const std::vector<std::uint8_t>& bytes) {
  return stream.take(bytes.data(), bytes.size()).has_value();
}

// Passes all messages to a stream and returns the faults that it noted.
std::vector<std::string> faults_of(Delivery delivery, const std::vector<Coming>& all) {
  OutletStream stream(delivery);
  for (const Coming& coming : all) {
    gs::wire::Uplink uplink;
    uplink.kind = coming.kind;
    uplink.sample = coming.sample;
    EXPECT_EQ(takes(stream, gs::wire::test::encoded(uplink, coming.sequence)), coming.taken)
        << "message " << coming.sequence;
  }
  return stream.take_faults();
}

TEST(OutletStream, DropsARepeatedFirstHello) {
  const Coming again = {UplinkKind::kHello, 0, 0, false};
  EXPECT_THAT(faults_of(Delivery::kByBroker, {kHello, again, measurement(1)}), IsEmpty());
}

TEST(OutletStream, ReportsARestartIfTheHelloRepeatsAfterOtherMessages) {
  EXPECT_THAT(faults_of(Delivery::kByBroker, {kHello, measurement(1), kHello, measurement(1)}),
              ElementsAre("restarted after its sample 128"));
}

TEST(OutletStream, ReportsLostMessages) {
  EXPECT_THAT(faults_of(Delivery::kByBroker, {kHello, measurement(3)}),
              ElementsAre(HasSubstr("2 of its messages were lost")));
}

TEST(OutletStream, DoesNotReportWhatAnOutletSentBeforeItWasConnected) {
  const Coming connected = {UplinkKind::kHello, 1211, 10};
  EXPECT_THAT(faults_of(Delivery::kByBroker, {kHello, connected, measurement(11)}), IsEmpty());
  EXPECT_THAT(faults_of(Delivery::kByBroker, {kHello, measurement(1), connected}),
              ElementsAre(HasSubstr("8 of its messages were lost")));
}

TEST(OutletStream, ReportsUnreadableMessages) {
  OutletStream stream(Delivery::kByBroker);
  EXPECT_FALSE(takes(stream, {0xFF, 0x00}));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("cannot be read")));
}

// A sequence number far below the last one is a new message; the hello before it was lost.
TEST(OutletStream, ReportsARestartWhoseHelloWasLost) {
  EXPECT_THAT(
      faults_of(Delivery::kByCable, {kHello, measurement(100), measurement(3), measurement(4)}),
      ElementsAre(HasSubstr("99 of its messages were lost"), "restarted after its sample 12800"));
}

TEST(OutletStream, ReportsARestartWhoseSequenceNumbersContinue) {
  const Coming late = {UplinkKind::kMeasurement, 128000, 1};
  EXPECT_THAT(faults_of(Delivery::kByCable, {kHello, late, measurement(2)}),
              ElementsAre("restarted after its sample 128000"));
}

TEST(OutletStream, DropsRepeatedAndLateMessagesOnACable) {
  EXPECT_THAT(faults_of(Delivery::kByCable, {kHello, measurement(1), measurement(2),
                                             measurement(2, false), measurement(1, false)}),
              IsEmpty());
}

TEST(OutletStream, DropsMessagesThatABrokerRepeats) {
  EXPECT_THAT(faults_of(Delivery::kByBroker,
                        {kHello, measurement(1), measurement(2), measurement(1, false)}),
              IsEmpty());
}

}  // namespace
}  // namespace gsbench::link
