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
  OutletStream stream;
  const Bytes hello = message(UplinkKind::kHello, 0, 0);
  EXPECT_TRUE(takes(stream, hello));
  EXPECT_FALSE(takes(stream, hello));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_THAT(stream.take_faults(), IsEmpty());
}

TEST(OutletStream, TellsOfAnOutletThatSaysTheSameHelloAfterMore) {
  OutletStream stream;
  const Bytes hello = message(UplinkKind::kHello, 0, 0);
  EXPECT_TRUE(takes(stream, hello));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_TRUE(takes(stream, hello));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 128, 1)));
  EXPECT_THAT(stream.take_faults(), ElementsAre("began anew after its sample 128"));
}

TEST(OutletStream, TellsOfMessagesThatWereLost) {
  OutletStream stream;
  EXPECT_TRUE(takes(stream, message(UplinkKind::kHello, 0, 0)));
  EXPECT_TRUE(takes(stream, message(UplinkKind::kMeasurement, 384, 3)));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("2 of its messages were lost")));
}

TEST(OutletStream, TellsOfWhatCannotBeRead) {
  OutletStream stream;
  EXPECT_FALSE(takes(stream, {0xFF, 0x00}));
  EXPECT_THAT(stream.take_faults(), ElementsAre(HasSubstr("cannot be read")));
}

}  // namespace
}  // namespace gsbench::link
