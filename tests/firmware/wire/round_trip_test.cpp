// Encoding and decoding give the same message, bit for bit; lengths of messages.
#include <wire_test/messages.hpp>

#include <algorithm>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include <outlet/settings.hpp>
#include <wire/frame.hpp>

namespace gs::wire::test {
namespace {

constexpr int kRoundTrips = 300;

template <class Message>
void expect_round_trips(const std::vector<Message>& messages) {
  for (const Message& message : messages) {
    for (const std::uint32_t sequence : {0U, 0xFFFFFFFFU}) {
      const Bytes bytes = encoded(message, sequence);
      ASSERT_FALSE(bytes.empty());
      Message back;
      std::uint32_t back_sequence = ~sequence;
      ASSERT_EQ(decode(bytes.data(), bytes.size(), back, back_sequence), Decoded::kOk)
          << hex(bytes);
      EXPECT_EQ(back.kind, message.kind) << hex(bytes);
      EXPECT_EQ(back_sequence, sequence);
      EXPECT_EQ(fields_of(back), fields_of(message)) << hex(bytes);
      EXPECT_EQ(encoded(back, sequence), bytes);
    }
  }
}

TEST(RoundTrip, EveryKindIsDecodedBitForBit) {
  expect_round_trips(many_uplinks(kRoundTrips));
  expect_round_trips(many_downlinks(kRoundTrips));
}

TEST(RoundTrip, SampleCountKeepsAllSixtyFourBits) {
  Uplink message;
  message.kind = UplinkKind::kAborted;
  for (const std::uint64_t sample : {0ULL, 23ULL, 24ULL, 0xFFULL, 0x100ULL, 0xFFFFULL, 0x10000ULL,
                                     0xFFFFFFFFULL, 0x100000000ULL, 0xFFFFFFFFFFFFFFFFULL}) {
    message.sample = sample;
    const Bytes bytes = encoded(message, 7);
    Uplink back;
    std::uint32_t sequence = 0;
    ASSERT_EQ(decode(bytes.data(), bytes.size(), back, sequence), Decoded::kOk);
    EXPECT_EQ(back.sample, sample);
  }
}

// The sample messages cover every kind, so that a new kind is tested, too.
TEST(RoundTrip, EveryKindHasANameAndFields) {
  EXPECT_EQ(uplink_kinds().size(), 14U);
  for (const UplinkKind kind : uplink_kinds()) {
    EXPECT_STRNE(to_string(kind), "unknown");
    std::mt19937 random(1);
    const bool bare = kind == UplinkKind::kAborted;
    EXPECT_EQ(fields_of(uplink(kind, Fill::kHighest, random)).empty(), bare) << to_string(kind);
  }
  for (int code = static_cast<int>(kFirstErrorCode); code <= static_cast<int>(kLastErrorCode);
       ++code) {
    EXPECT_STRNE(to_string(static_cast<ErrorCode>(code)), "unknown error");
  }
}

TEST(RoundTrip, SettingsKeepTheirDigest) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    outlet::Settings settings;
    if (i > 0) {
      settings = downlink(DownlinkKind::kSettings, Fill::kAnything, random).settings;
    }
    const Bytes bytes = encoded(settings);
    outlet::Settings back;
    ASSERT_EQ(decode(bytes.data(), bytes.size(), back), Decoded::kOk);
    EXPECT_EQ(fields_of(back), fields_of(settings));
    EXPECT_EQ(encoded(back), bytes);
    // The wire has a single NaN, so that the digest of settings with another NaN changes. Such
    // settings are refused in any case.
    if (i == 0) {
      EXPECT_EQ(outlet::digest(back), outlet::digest(settings));
    }
    outlet::Settings again;
    ASSERT_EQ(decode(bytes.data(), bytes.size(), again), Decoded::kOk);
    EXPECT_EQ(outlet::digest(again), outlet::digest(back));
  }
}

TEST(RoundTrip, MissingSettingsHaveTheirDefaults) {
  const Bytes bytes = {0x84, 0x01, 0x05, 0x06, 0xA1, 0x10, 0x18, 0x1E};  // lse_samples 30
  Downlink message;
  std::uint32_t sequence = 0;
  ASSERT_EQ(decode(bytes.data(), bytes.size(), message, sequence), Decoded::kOk);
  EXPECT_EQ(message.settings_error, outlet::SettingsError::kNone);
  outlet::Settings expected;
  expected.lse_samples = 30;
  EXPECT_EQ(fields_of(message.settings), fields_of(expected));
}

TEST(RoundTrip, EachSettingHasAUniqueKey) {
  std::set<int> keys;
  for (const outlet::Field& field : outlet::kSettingsFields) {
    keys.insert(field.key);
  }
  EXPECT_EQ(keys.size(), std::size(outlet::kSettingsFields));
  EXPECT_EQ(keys.count(0), 0U);
}

TEST(RoundTrip, EveryNaNIsEncodedAsTheProtocolsNaN) {
  std::mt19937 random(1);
  Uplink message = uplink(UplinkKind::kLse, Fill::kNaN, random);
  message.sample = 5;
  message.start_number = 6;
  EXPECT_EQ(hex(encoded(message, 1)), "85 05 01 05 06 fa 7f c0 00 00");
}

TEST(RoundTrip, OfAHelloOfAnotherVersionOnlyVersionAndIdAreRead) {
  std::mt19937 random(1);
  Uplink message = uplink(UplinkKind::kHello, Fill::kHighest, random);
  // [1, 3, 9, version 9, "a-7", fields unknown to this version]
  const Bytes bytes = {0x87, 0x01, 0x03, 0x09, 0x09, 0x63, 'a', '-', '7', 0xF6, 0xA0};
  std::uint32_t sequence = 0;
  ASSERT_EQ(decode(bytes.data(), bytes.size(), message, sequence), Decoded::kOk);
  EXPECT_EQ(message.hello.protocol_version, 9);
  EXPECT_STREQ(message.hello.id, "a-7");
  EXPECT_EQ(sequence, 3U);
  EXPECT_EQ(message.sample, 9U);
}

// ---- lengths

template <class Message>
std::size_t longest_of(const std::vector<Message>& messages) {
  std::size_t longest = 0;
  for (const Message& message : messages) {
    longest = std::max(longest, encoded(message, 0xFFFFFFFFU).size());
  }
  return longest;
}

TEST(Length, SettingsWithAllRowsAreTheLongestMessage) {
  std::mt19937 random(3);
  const Downlink longest = downlink(DownlinkKind::kSettings, Fill::kLongest, random);
  EXPECT_EQ(encoded(longest, 0xFFFFFFFFU).size(), kLongestOfThisVersion);
  EXPECT_LE(longest_of(many_uplinks(kRoundTrips)), kLongestOfThisVersion);
  EXPECT_EQ(longest_of(many_downlinks(kRoundTrips)), kLongestOfThisVersion);
}

TEST(Length, ABufferThatIsTooShortIsRefused) {
  std::mt19937 random(4);
  for (const UplinkKind kind : uplink_kinds()) {
    const Uplink message = uplink(kind, Fill::kLongest, random);
    const Bytes whole = encoded(message, 1);
    for (std::size_t capacity = 0; capacity < whole.size(); ++capacity) {
      Bytes out(capacity);
      EXPECT_EQ(encode(message, 1, out.data(), capacity), 0U) << to_string(kind) << capacity;
    }
    Bytes out(whole.size());
    EXPECT_EQ(encode(message, 1, out.data(), out.size()), whole.size());
  }
  const Downlink message = downlink(DownlinkKind::kSettings, Fill::kLongest, random);
  const std::size_t size = encoded(message, 1).size();
  const std::size_t settings_size = encoded(message.settings).size();
  for (std::size_t capacity = 0; capacity < size; ++capacity) {
    Bytes out(capacity);
    EXPECT_EQ(encode(message, 1, out.data(), capacity), 0U);
    EXPECT_EQ(encode(message.settings, out.data(), capacity),
              capacity < settings_size ? 0U : settings_size);
  }
}

}  // namespace
}  // namespace gs::wire::test
