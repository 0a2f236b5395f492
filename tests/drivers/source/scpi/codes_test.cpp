// Voltages, codes and bytes.
#include "codes.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>

namespace gsbench::scpi {
namespace {

using testing::ElementsAre;

Instrument with(int bits, Codes codes, ByteOrder order = ByteOrder::kLittle) {
  Instrument instrument;
  instrument.format = {bits, codes, order, Block::kRaw};
  return instrument;
}

TEST(QuantisedVoltages, FillTheRangeOfSignedCodes) {
  EXPECT_THAT(quantised({-2.0F, 0.0F, 1.0F, 2.0F}, 2.0, with(16, Codes::kSigned)).codes,
              ElementsAre(-32767, 0, 16384, 32767));
}

TEST(QuantisedVoltages, UseOnlyTheLevelsOfTheDac) {
  const Instrument instrument = with(14, Codes::kSigned);
  std::vector<float> ramp;
  for (int i = -1000; i <= 1000; ++i) {
    ramp.push_back(static_cast<float>(i) / 1000.0F);
  }
  const std::vector<std::int32_t> codes = quantised(ramp, 1.0, instrument).codes;
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    EXPECT_EQ(codes[i] % 4, 0);
    // Half a step, and at the very top a part of one.
    EXPECT_NEAR(level_of(codes[i], instrument), static_cast<double>(ramp[i]), 3.1 / 32767.0);
  }
  EXPECT_EQ(codes.back(), 32764);
  EXPECT_EQ(codes.front(), -32764);
}

TEST(QuantisedVoltages, HaveUnsignedCodesWithTheMiddleBetweenTwo) {
  const Instrument instrument = with(14, Codes::kUnsigned);
  EXPECT_THAT(quantised({-1.0F, 1.0F}, 1.0, instrument).codes, ElementsAre(0, 16383));
  EXPECT_NEAR(level_of(quantised({0.0F}, 1.0, instrument).codes[0], instrument), 0.0,
              0.51 / 8191.5);
}

TEST(QuantisedVoltages, AvoidNewlinesAndStayNear) {
  for (const int bits : {16, 14}) {
    Instrument instrument = with(bits, Codes::kSigned);
    instrument.quirks = {Quirk::kAvoidNewline};
    std::vector<float> every;
    for (int code = -32767; code <= 32767; ++code) {
      every.push_back(static_cast<float>(code) / 32767.0F);
    }
    const Quantised result = quantised(every, 1.0, instrument);
    for (const std::uint8_t byte : bytes_of(result.codes.data(), result.codes.size(), instrument)) {
      ASSERT_NE(byte, 0x0A);
    }
    for (std::size_t i = 0; i < every.size(); ++i) {
      // 256 codes in a row have a high byte of 0x0A; the middle one moves by half of them.
      ASSERT_NEAR(result.codes[i], static_cast<double>(every[i]) * 32767.0, 134.0);
    }
    EXPECT_GE(result.largest_nudge, 124);
    EXPECT_LE(result.largest_nudge, 132);
    instrument.quirks.clear();
    EXPECT_EQ(quantised(every, 1.0, instrument).largest_nudge, 0);
  }
}

TEST(Bytes, AreInTheInstrumentsOrder) {
  const std::int32_t codes[] = {0x1234, -2};
  EXPECT_THAT(bytes_of(codes, 2, with(16, Codes::kSigned)), ElementsAre(0x34, 0x12, 0xFE, 0xFF));
  EXPECT_THAT(bytes_of(codes, 2, with(16, Codes::kSigned, ByteOrder::kBig)),
              ElementsAre(0x12, 0x34, 0xFF, 0xFE));
}

}  // namespace
}  // namespace gsbench::scpi
