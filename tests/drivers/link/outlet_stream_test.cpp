// What one outlet's messages are taken for as they come: in order, twice, or from a new beginning.
#include <wire_test/messages.hpp>

#include <gmock/gmock.h>

#include <link/outlet_stream.hpp>

namespace gsbench::link {
namespace {

using gs::wire::UplinkKind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// What comes, and whether it is taken.
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

// The faults that are told in the end.
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

TEST(OutletStream, TakesAFirstHelloThatComesTwiceOnce) {
  const Coming again = {UplinkKind::kHello, 0, 0, false};
  EXPECT_THAT(faults_of(Delivery::kByBroker, {kHello, again, measurement(1)}), IsEmpty());
}

TEST(OutletStream, TellsOfAnOutletThatSaysTheSameHelloAfterMore) {
  EXPECT_THAT(faults_of(Delivery::kByBroker, {kHello, measurement(1), kHello, measurement(1)}),
              ElementsAre("restarted after its sample 128"));
}

TEST(OutletStream, TellsOfMessagesThatWereLost) {
  EXPECT_THAT(faults_of(Delivery::kByBroker, {kHello, measurement(3)}),
              ElementsAre(HasSubstr("2 of its messages were lost")));
}

TEST(OutletStream, TellsOfWhatCannotBeRead) {
  OutletStream stream(Delivery::kByBroker);
  EXPECT_FALSE(takes(stream, {0xFF, 0x00}));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("cannot be read")));
}

// What has a number from long ago is new, and the hello that should have come before it was lost.
TEST(OutletStream, TellsOfANewBeginningWhoseHelloWasLost) {
  EXPECT_THAT(
      faults_of(Delivery::kByCable, {kHello, measurement(100), measurement(3), measurement(4)}),
      ElementsAre(HasSubstr("99 of its messages were lost"), "restarted after its sample 12800"));
}

TEST(OutletStream, TellsOfANewBeginningWhoseNumbersFit) {
  const Coming late = {UplinkKind::kMeasurement, 128000, 1};
  EXPECT_THAT(faults_of(Delivery::kByCable, {kHello, late, measurement(2)}),
              ElementsAre("restarted after its sample 128000"));
}

TEST(OutletStream, DropsWhatACableRepeatsOrSwaps) {
  EXPECT_THAT(faults_of(Delivery::kByCable, {kHello, measurement(1), measurement(2),
                                             measurement(2, false), measurement(1, false)}),
              IsEmpty());
}

TEST(OutletStream, DropsWhatABrokerBringsAgain) {
  EXPECT_THAT(faults_of(Delivery::kByBroker,
                        {kHello, measurement(1), measurement(2), measurement(1, false)}),
              IsEmpty());
}

}  // namespace
}  // namespace gsbench::link
