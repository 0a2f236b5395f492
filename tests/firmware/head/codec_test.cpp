#include <head_test/rig.hpp>

#include <random>

#include <gtest/gtest.h>

#include <head/fields.hpp>
#include <wire/frame.hpp>

namespace gs::head::test {
namespace {

// Random values within the range of each field.
class Randomiser {
 public:
  explicit Randomiser(unsigned seed) : random_(seed) {}

  template <class Integer>
  void operator()(Integer& value) {
    value = static_cast<Integer>(random_());
  }
  void operator()(bool& value) { value = random_() % 2 == 1; }
  void operator()(char (&text)[kBoardBytes + 1]) {
    const std::size_t length = random_() % (kBoardBytes + 1);
    for (std::size_t i = 0; i < length; ++i) {
      text[i] = static_cast<char>(' ' + random_() % 95);
    }
  }
  void operator()(std::uint8_t (&bytes)[kUniqueIdBytes]) {
    for (std::uint8_t& byte : bytes) {
      byte = static_cast<std::uint8_t>(random_());
    }
  }
  template <class Enum>
  void choice(Enum& value, Enum last, Enum first = Enum{}) {
    const auto low = static_cast<unsigned>(first);
    value = static_cast<Enum>(low + random_() % (static_cast<unsigned>(last) - low + 1));
  }
  void samples(std::int16_t (&samples)[kLongestSamples], std::uint16_t& count) {
    count = static_cast<std::uint16_t>(1 + random_() % kLongestSamples);
    for (std::size_t i = 0; i < count; ++i) {
      samples[i] = static_cast<std::int16_t>(random_());
    }
  }

 private:
  std::mt19937_64 random_;
};

template <class Message>
class Codec : public testing::Test {
 protected:
  static Message random_message(unsigned seed) {
    Randomiser randomiser(seed);
    Message message;
    fields(message, randomiser);
    if constexpr (Message::kKind == Kind::kIdentify || Message::kKind == Kind::kHello) {
      message.protocol_version = kProtocolVersion;
      fields(message, randomiser);
      message.protocol_version = kProtocolVersion;
    }
    return message;
  }
};

using Messages = testing::Types<Identify, Arm, Samples, Play, Stop, Ping, ResendEdges, Hello,
                                Status, Edge, Refused>;
TYPED_TEST_SUITE(Codec, Messages);

TYPED_TEST(Codec, DecodesWhatItEncodes) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const auto message = this->random_message(seed);
    const Bytes bytes = encoded(message, seed);
    ASSERT_GE(bytes.size(), kHeadLength);
    TypeParam decoded;
    ASSERT_TRUE(decode(bytes.data(), bytes.size(), decoded));
    Header header;
    ASSERT_TRUE(decode_header(bytes.data(), bytes.size(), header));
    EXPECT_EQ(header.kind, TypeParam::kKind);
    EXPECT_EQ(header.number, seed);
    EXPECT_EQ(encoded(decoded, seed), bytes);
  }
}

TYPED_TEST(Codec, RefusesWhatIsTooShortOrTooLong) {
  Bytes bytes = encoded(this->random_message(1), 1);
  TypeParam decoded;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(decode(bytes.data(), size, decoded)) << size;
  }
  bytes.push_back(0);
  EXPECT_FALSE(decode(bytes.data(), bytes.size(), decoded));
}

TYPED_TEST(Codec, RefusesOtherKinds) {
  const Bytes bytes = encoded(this->random_message(1), 1);
  TypeParam decoded;
  for (int kind = 0; kind < 256; ++kind) {
    Bytes other = bytes;
    other[0] = static_cast<std::uint8_t>(kind);
    EXPECT_EQ(decode(other.data(), other.size(), decoded), kind == bytes[0]);
  }
}

TYPED_TEST(Codec, EncodesNothingIfItDoesNotFit) {
  const auto message = this->random_message(1);
  const std::size_t size = encoded(message, 1).size();
  Bytes out(size);
  EXPECT_EQ(encode(message, 1, out.data(), size), size);
  EXPECT_EQ(encode(message, 1, out.data(), size - 1), 0U);
}

TYPED_TEST(Codec, StaysWithinTheLongestLength) {
  constexpr bool kIsUplink = static_cast<int>(TypeParam::kKind) >= 0x10;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    EXPECT_LE(encoded(this->random_message(seed), 1).size(),
              kIsUplink ? kLongestUplink : kLongestMessage);
  }
}

TEST(Encoding, OfTheLongestMessageFitsAFrame) {
  const Bytes bytes = encoded(stream(0, kLongestSamples), 0);
  EXPECT_EQ(bytes.size(), kLongestMessage);
  EXPECT_LE(bytes.size(), wire::kLongestMessage);
}

TEST(Encoding, RefusesTooManySamples) {
  Samples message = stream(0, 256);
  message.count = 257;
  EXPECT_TRUE(encoded(message, 0).empty());
  message.count = 0;
  EXPECT_TRUE(encoded(message, 0).empty());
}

TEST(Encoding, RefusesValuesThatAreNotListed) {
  Bytes status = encoded(Status{}, 0);
  Status decoded;
  status[5] = 4;
  EXPECT_FALSE(decode(status.data(), status.size(), decoded));
  Bytes edge = encoded(Edge{}, 0);
  Edge decoded_edge;
  edge[10] = 2;
  EXPECT_FALSE(decode(edge.data(), edge.size(), decoded_edge));
  for (const int reason : {0, 11, 255}) {
    Bytes refused = encoded(Refused{}, 0);
    refused[5] = static_cast<std::uint8_t>(reason);
    Refused decoded_refused;
    EXPECT_FALSE(decode(refused.data(), refused.size(), decoded_refused));
  }
}

TEST(Encoding, RefusesABoardThatIsNotText) {
  Bytes hello = encoded(Hello{}, 0);
  Hello decoded;
  EXPECT_TRUE(decode(hello.data(), hello.size(), decoded));
  hello[10] = 'a';  // after a zero
  EXPECT_FALSE(decode(hello.data(), hello.size(), decoded));
  hello[9] = 0x80;
  EXPECT_FALSE(decode(hello.data(), hello.size(), decoded));
}

TEST(Encoding, OfAnotherVersionsHelloIsReadUpToItsVersion) {
  Hello hello;
  hello.protocol_version = 2;
  Bytes bytes = encoded(hello, 3);
  EXPECT_EQ(bytes.size(), kHeadLength + 2);
  bytes.insert(bytes.end(), 100, 0xEE);
  Hello decoded;
  ASSERT_TRUE(decode(bytes.data(), bytes.size(), decoded));
  EXPECT_EQ(decoded.protocol_version, 2);
}

}  // namespace
}  // namespace gs::head::test
