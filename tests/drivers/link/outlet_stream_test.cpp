// What one outlet's messages are taken for as they come: in order, twice, or from a new beginning.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <link/outlet_stream.hpp>

namespace gsbench::link {
namespace {

using gs::wire::UplinkKind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Bytes = std::vector<std::uint8_t>;

Bytes message(UplinkKind kind, std::uint64_t sample, std::uint32_t sequence) {
  gs::wire::Uplink uplink;
  uplink.kind = kind;
  uplink.sample = sample;
  Bytes bytes(gs::wire::kLongestMessage);
  bytes.resize(gs::wire::encode(uplink, sequence, bytes.data(), bytes.size()));
  return bytes;
}

bool takes(OutletStream& stream, const Bytes& bytes) {
  return stream.take(bytes.data(), bytes.size()).has_value();
}

TEST(OutletStream, TakesAFirstHelloThatComesTwiceOnce) {
  OutletStream stream(Delivery::kByBroker);
  const Bytes hello = message(UplinkKind::kHello, 0, 0);
  EXPECT_TRUE(takes(stream, hello));
  EXPECT_FALSE(takes(stream, hello));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_THAT(stream.take_faults(), IsEmpty());
}

TEST(OutletStream, TellsOfAnOutletThatSaysTheSameHelloAfterMore) {
  OutletStream stream(Delivery::kByBroker);
  const Bytes hello = message(UplinkKind::kHello, 0, 0);
  EXPECT_TRUE(takes(stream, hello));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_TRUE(takes(stream, hello));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_THAT(stream.take_faults(), ElementsAre("restarted after its sample 128"));
}

TEST(OutletStream, TellsOfMessagesThatWereLost) {
  OutletStream stream(Delivery::kByBroker);
  EXPECT_TRUE(takes(stream, message(UplinkKind::kHello, 0, 0)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 384, 3)));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("2 of its messages were lost")));
}

TEST(OutletStream, TellsOfWhatCannotBeRead) {
  OutletStream stream(Delivery::kByBroker);
  EXPECT_FALSE(takes(stream, {0xFF, 0x00}));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("cannot be read")));
}

// What has a number from long ago is new, and the hello that should have come before it was lost.
TEST(OutletStream, TellsOfANewBeginningWhoseHelloWasLost) {
  OutletStream stream(Delivery::kByCable);
  EXPECT_TRUE(takes(stream, message(UplinkKind::kHello, 0, 0)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 12800, 100)));
  stream.take_faults();
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 384, 3)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 512, 4)));
  EXPECT_THAT(stream.take_faults(), ElementsAre("restarted after its sample 12800"));
}

TEST(OutletStream, TellsOfANewBeginningWhoseNumbersFit) {
  OutletStream stream(Delivery::kByCable);
  EXPECT_TRUE(takes(stream, message(UplinkKind::kHello, 0, 0)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128000, 1)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 256, 2)));
  EXPECT_THAT(stream.take_faults(), ElementsAre("restarted after its sample 128000"));
}

TEST(OutletStream, DropsWhatACableRepeatsOrSwaps) {
  OutletStream stream(Delivery::kByCable);
  EXPECT_TRUE(takes(stream, message(UplinkKind::kHello, 0, 0)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 256, 2)));
  EXPECT_FALSE(takes(stream, message(UplinkKind::kMeasurement, 256, 2)));
  EXPECT_FALSE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_THAT(stream.take_faults(), IsEmpty());
}

TEST(OutletStream, DropsWhatABrokerBringsAgain) {
  OutletStream stream(Delivery::kByBroker);
  EXPECT_TRUE(takes(stream, message(UplinkKind::kHello, 0, 0)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 256, 2)));
  EXPECT_FALSE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_THAT(stream.take_faults(), IsEmpty());
}

}  // namespace
}  // namespace gsbench::link
