// Reader and writer item by item, with the examples of RFC 8949, appendix A.
#include <wire_test/messages.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <wire/cbor.hpp>

namespace gs::wire::cbor {
namespace {

using test::Bytes;
using test::hex;

template <class Write>
std::string written(Write write) {
  Bytes bytes(64);
  Writer writer(bytes.data(), bytes.size());
  write(writer);
  EXPECT_TRUE(writer.ok());
  bytes.resize(writer.size());
  return hex(bytes);
}

TEST(CborWriter, WritesTheExamplesOfTheStandard) {
  const auto integer = [](std::int64_t value) {
    return written([value](Writer& writer) { writer.integer(value); });
  };
  EXPECT_EQ(integer(0), "00");
  EXPECT_EQ(integer(23), "17");
  EXPECT_EQ(integer(24), "18 18");
  EXPECT_EQ(integer(100), "18 64");
  EXPECT_EQ(integer(1000), "19 03 e8");
  EXPECT_EQ(integer(1000000), "1a 00 0f 42 40");
  EXPECT_EQ(integer(1000000000000), "1b 00 00 00 e8 d4 a5 10 00");
  EXPECT_EQ(integer(-1), "20");
  EXPECT_EQ(integer(-10), "29");
  EXPECT_EQ(integer(-100), "38 63");
  EXPECT_EQ(integer(-1000), "39 03 e7");
  EXPECT_EQ(integer(std::numeric_limits<std::int64_t>::min()), "3b 7f ff ff ff ff ff ff ff");
  EXPECT_EQ(written([](Writer& w) { w.unsigned_integer(18446744073709551615ULL); }),
            "1b ff ff ff ff ff ff ff ff");
  EXPECT_EQ(written([](Writer& w) { w.single(100000.0F); }), "fa 47 c3 50 00");
  EXPECT_EQ(written([](Writer& w) { w.single(3.4028234663852886e+38F); }), "fa 7f 7f ff ff");
  EXPECT_EQ(written([](Writer& w) { w.single(std::numeric_limits<float>::infinity()); }),
            "fa 7f 80 00 00");
  EXPECT_EQ(written([](Writer& w) { w.single(-std::numeric_limits<float>::quiet_NaN()); }),
            "fa 7f c0 00 00");
  EXPECT_EQ(written([](Writer& w) { w.boolean(false); }), "f4");
  EXPECT_EQ(written([](Writer& w) { w.boolean(true); }), "f5");
  EXPECT_EQ(written([](Writer& w) { w.text("", 0); }), "60");
  EXPECT_EQ(written([](Writer& w) { w.text("IETF", 4); }), "64 49 45 54 46");
  EXPECT_EQ(written([](Writer& w) { w.array(3); }), "83");
  EXPECT_EQ(written([](Writer& w) { w.array(25); }), "98 19");
}

TEST(CborReader, ReadsIntegersOfAnyWidth) {
  for (const Bytes& ten : {Bytes{0x0A}, Bytes{0x18, 0x0A}, Bytes{0x19, 0, 0x0A},
                           Bytes{0x1A, 0, 0, 0, 0x0A}, Bytes{0x1B, 0, 0, 0, 0, 0, 0, 0, 0x0A}}) {
    Reader reader(ten.data(), ten.size());
    std::uint64_t value = 0;
    EXPECT_TRUE(reader.unsigned_integer(value));
    EXPECT_EQ(value, 10U);
    EXPECT_EQ(reader.left(), 0U);
  }
}

TEST(CborReader, ReadsSignedIntegersUpToSixtyFourBits) {
  const auto integer = [](const Bytes& bytes, std::int64_t& value) {
    return Reader(bytes.data(), bytes.size()).integer(value);
  };
  std::int64_t value = 1;
  EXPECT_TRUE(integer({0x3B, 0x7F, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, value));
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::min());
  EXPECT_TRUE(integer({0x1B, 0x7F, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, value));
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::max());
  EXPECT_FALSE(integer({0x3B, 0x80, 0, 0, 0, 0, 0, 0, 0}, value));
  EXPECT_FALSE(integer({0x1B, 0x80, 0, 0, 0, 0, 0, 0, 0}, value));
}

// One item of each type that a reader may have to skip.
const std::vector<Bytes> kWellFormed = {
    {0x00},
    {0x3B, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF},
    {0x40},
    {0x44, 1, 2, 3, 4},
    {0x62, 0xC3, 0xBC},
    {0x80},
    {0x82, 0x01, 0x81, 0x02},
    {0xA0},
    {0xA1, 0x61, 'a', 0x82, 0x01, 0x02},
    {0xC0, 0x61, '1'},
    {0xD8, 0x20, 0x40},
    {0xF4},
    {0xF6},
    {0xF7},
    {0xE0},
    {0xF8, 0xFF},
    {0xF9, 0x3C, 0x00},
    {0xFA, 0x47, 0xC3, 0x50, 0x00},
    {0xFB, 0x3F, 0xF1, 0x99, 0x99, 0x99, 0x99, 0x99, 0x9A},
};

// RFC 8949, appendix F.1, and indefinite lengths, which this protocol does not allow.
const std::vector<Bytes> kIllFormed = {
    {},
    {0x1C},
    {0xFC},
    {0xFF},
    {0x5F, 0x40, 0xFF},
    {0x7F, 0x60, 0xFF},
    {0x9F, 0x01, 0xFF},
    {0xBF, 0xFF},
    {0xF8, 0x00},
    {0xF8, 0x18},
    {0xF8, 0x1F},
    {0x58},
    {0x41},
    {0x81},
    {0x82, 0x00},
    {0xA1, 0x00},
    {0xC0},
    {0x5B, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 1, 2, 3},
    {0x7B, 0x7F, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 1, 2, 3},
    {0x9B, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 1, 2, 3},
    {0xBB, 0x80, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x01, 1, 2, 3},
};

TEST(CborReader, SkipsOneItemOfAnyType) {
  for (const Bytes& item : kWellFormed) {
    Bytes bytes = item;
    bytes.push_back(0x05);
    Reader reader(bytes.data(), bytes.size());
    EXPECT_TRUE(reader.skip()) << hex(item);
    EXPECT_EQ(reader.left(), 1U) << hex(item);
  }
}

TEST(CborReader, DoesNotAdvanceAtAnIllFormedItem) {
  for (const Bytes& bytes : kIllFormed) {
    Reader reader(bytes.data(), bytes.size());
    EXPECT_FALSE(reader.skip()) << hex(bytes);
    EXPECT_EQ(reader.left(), bytes.size());
  }
}

TEST(CborReader, ReadsEachItemOnlyAsItsOwnType) {
  for (const Bytes& item : kWellFormed) {
    Reader reader(item.data(), item.size());
    std::size_t items = 0;
    std::uint64_t number = 0;
    float single = 0.0F;
    bool boolean = false;
    char text[3] = {};
    const auto major = item[0] >> 5;
    const bool fits_text = major == 3 && (item.size() == 1 || item[1] < 0x80);
    EXPECT_EQ(Reader(reader).array(items), major == 4) << hex(item);
    EXPECT_EQ(Reader(reader).unsigned_integer(number), major == 0) << hex(item);
    EXPECT_EQ(Reader(reader).single(single), item[0] == 0xFA) << hex(item);
    EXPECT_EQ(Reader(reader).boolean(boolean), item[0] == 0xF4 || item[0] == 0xF5) << hex(item);
    EXPECT_EQ(Reader(reader).text(text, 2), fits_text) << hex(item);
  }
}

TEST(CborReader, RefusesTextThatIsTooLongOrNotPrintableAscii) {
  const auto text = [](const Bytes& bytes) {
    char out[4] = {};
    return Reader(bytes.data(), bytes.size()).text(out, 3);
  };
  EXPECT_TRUE(text({0x63, 'a', ' ', '~'}));
  EXPECT_FALSE(text({0x64, 'a', 'b', 'c', 'd'}));
  EXPECT_FALSE(text({0x63, 'a', 'b'}));
  EXPECT_FALSE(text({0x62, 'a', 0x00}));
  EXPECT_FALSE(text({0x62, 'a', 0x1B}));
  EXPECT_FALSE(text({0x62, 'a', 0x7F}));
  EXPECT_FALSE(text({0x62, 0xC3, 0xBC}));
  EXPECT_FALSE(text({0x43, 'a', 'b', 'c'}));  // bytes, not text
}

// A million levels of nesting in a megabyte, and counts beyond the end: must cause neither
// recursion nor long run times.
TEST(CborReader, RefusesDeepNestingWithoutRecursion) {
  constexpr std::size_t kLength = 1'000'000;
  for (const std::uint8_t head : Bytes{0x81, 0xA1, 0xC0, 0x82}) {
    const Bytes bomb(kLength, head);
    EXPECT_FALSE(Reader(bomb.data(), bomb.size()).skip());
  }
  Bytes deep(kLength, 0x81);
  deep.back() = 0x80;
  Reader reader(deep.data(), deep.size());
  EXPECT_TRUE(reader.skip());
  EXPECT_EQ(reader.left(), 0U);
}

}  // namespace
}  // namespace gs::wire::cbor
