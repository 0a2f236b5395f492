// Malformed messages are refused wherever the defect is; additions of later versions are ignored.
#include <wire_test/messages.hpp>

#include <cmath>
#include <cstring>
#include <functional>
#include <utility>

#include <gtest/gtest.h>

#include <wire/cbor.hpp>

namespace gs::wire::test {
namespace {

constexpr std::uint32_t kAnySequence = 1000;

Decoded decode_uplink(const Bytes& bytes) {
  Uplink message;
  std::uint32_t sequence = 0;
  return decode(bytes.data(), bytes.size(), message, sequence);
}

Decoded decode_downlink(const Bytes& bytes) {
  Downlink message;
  std::uint32_t sequence = 0;
  return decode(bytes.data(), bytes.size(), message, sequence);
}

Decoded decode_settings(const Bytes& bytes) {
  outlet::Settings settings;
  return decode(bytes.data(), bytes.size(), settings);
}

// A well-formed message and its decoder.
struct Case {
  Bytes bytes;
  Decoded (*decode)(const Bytes&);
};

std::vector<Case> cases() {
  std::vector<Case> all;
  std::mt19937 random(7);
  for (const Fill fill : {Fill::kLongest, Fill::kLowest, Fill::kAnything}) {
    for (const UplinkKind kind : uplink_kinds()) {
      all.push_back({encoded(uplink(kind, fill, random), kAnySequence), decode_uplink});
    }
    for (const DownlinkKind kind : downlink_kinds()) {
      all.push_back({encoded(downlink(kind, fill, random), kAnySequence), decode_downlink});
    }
  }
  return all;
}

// The encoded items of an array.
std::vector<Bytes> items_of(const Bytes& message) {
  cbor::Reader reader(message.data(), message.size());
  std::size_t count = 0;
  EXPECT_TRUE(reader.array(count));
  std::vector<Bytes> items;
  for (; count > 0; --count) {
    const auto* begin = message.data() + (message.size() - reader.left());
    EXPECT_TRUE(reader.skip());
    const auto* end = message.data() + (message.size() - reader.left());
    items.emplace_back(begin, end);
  }
  EXPECT_EQ(reader.left(), 0U);
  return items;
}

Bytes joined(Bytes head, const std::vector<Bytes>& items) {
  for (const Bytes& item : items) {
    head.insert(head.end(), item.begin(), item.end());
  }
  return head;
}

Bytes array_of(const std::vector<Bytes>& items) {
  Bytes head(9);
  cbor::Writer writer(head.data(), head.size());
  writer.array(items.size());
  head.resize(writer.size());
  return joined(head, items);
}

// Decodes each case with its items changed. Too long a message is malformed in any case.
template <class Change>
void expect_changed(Decoded expected, Change change) {
  for (const Case& one : cases()) {
    const Bytes bytes = change(items_of(one.bytes));
    EXPECT_EQ(one.decode(bytes), bytes.size() > kLongestMessage ? Decoded::kMalformed : expected)
        << hex(bytes);
  }
}

// One item of each type, and the limits of the numbers.
const std::vector<Bytes> kAnyItem = {
    {0x00},
    {0x1B, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF},
    {0x20},
    {0x3B, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF},
    {0x41, 'x'},
    {0x61, 'x'},
    {0x82, 0x01, 0x81, 0x80},
    {0xA1, 0x01, 0xF6},
    {0xC1, 0x00},
    {0xF4},
    {0xF6},
    {0xF9, 0x3C, 0x00},
    {0xFA, 0x3F, 0x80, 0x00, 0x00},
    {0xFB, 0x3F, 0xF0, 0, 0, 0, 0, 0, 0},
};

TEST(Refusal, ATruncatedMessageIsMalformed) {
  for (const Case& one : cases()) {
    ASSERT_EQ(one.decode(one.bytes), Decoded::kOk);
    for (std::size_t length = 0; length < one.bytes.size(); ++length) {
      const Bytes cut(one.bytes.begin(), one.bytes.begin() + static_cast<std::ptrdiff_t>(length));
      EXPECT_EQ(one.decode(cut), Decoded::kMalformed) << hex(cut);
    }
  }
}

TEST(Refusal, BytesAfterTheMessageMakeItMalformed) {
  for (const std::uint8_t extra : Bytes{0x00, 0x80, 0xF6, 0xFF}) {
    expect_changed(Decoded::kMalformed, [extra](const std::vector<Bytes>& items) {
      return joined(array_of(items), {{extra}});
    });
  }
}

TEST(Refusal, AMessageWithMissingItemsIsMalformed) {
  for (const Case& one : cases()) {
    std::vector<Bytes> items = items_of(one.bytes);
    while (!items.empty()) {
      items.pop_back();
      EXPECT_EQ(one.decode(array_of(items)), Decoded::kMalformed) << hex(array_of(items));
    }
  }
}

// Replaces every item by one of every other type.
TEST(Refusal, AnItemOfAnotherTypeIsMalformed) {
  const auto type_of = [](const Bytes& item) {
    const int major = item[0] >> 5;
    if (item[0] == 0xF4 || item[0] == 0xF5) {
      return 100;
    }
    return major == 7 ? static_cast<int>(item[0]) : major;
  };
  for (const Case& one : cases()) {
    const std::vector<Bytes> items = items_of(one.bytes);
    for (std::size_t at = 0; at < items.size(); ++at) {
      for (const Bytes& other : kAnyItem) {
        const int was = type_of(items[at]);
        const int is = type_of(other);
        const bool both_integers = was <= 1 && is <= 1;
        if (was == is || both_integers) {
          continue;
        }
        std::vector<Bytes> changed = items;
        changed[at] = other;
        EXPECT_EQ(one.decode(array_of(changed)), Decoded::kMalformed)
            << "item " << at << ": " << hex(array_of(changed));
      }
    }
  }
}

TEST(Refusal, ExtraItemsOfAnyTypeAreIgnored) {
  for (std::size_t extras = 1; extras <= kAnyItem.size(); ++extras) {
    expect_changed(Decoded::kOk, [extras](std::vector<Bytes> items) {
      items.insert(items.end(), kAnyItem.begin(),
                   kAnyItem.begin() + static_cast<std::ptrdiff_t>(extras));
      return array_of(items);
    });
  }
}

TEST(Refusal, IllFormedOrDeeplyNestedExtraItemsAreMalformed) {
  for (const Bytes& extra : {Bytes{0x9F, 0xFF}, Bytes{0x5F, 0x40, 0xFF}, Bytes{0xFF}, Bytes{0x1C},
                             Bytes{0xF8, 0x14}, Bytes{0x41}, Bytes(10000, 0x81)}) {
    expect_changed(Decoded::kMalformed, [&extra](std::vector<Bytes> items) {
      items.push_back(extra);
      return array_of(items);
    });
  }
}

TEST(Refusal, AnArrayOfIndefiniteLengthIsMalformed) {
  expect_changed(Decoded::kMalformed, [](std::vector<Bytes> items) {
    items.push_back({0xFF});
    return joined({0x9F}, items);
  });
}

TEST(Refusal, AnArrayWithTooLargeACountIsMalformed) {
  for (const Bytes& head :
       {Bytes{0x9B, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF},
        Bytes{0x9B, 0, 0, 0, 1, 0, 0, 0, 3}, Bytes{0x9A, 0xFF, 0xFF, 0xFF, 0xFF}}) {
    expect_changed(Decoded::kMalformed,
                   [&head](const std::vector<Bytes>& items) { return joined(head, items); });
  }
}

TEST(Refusal, AnItemOtherThanAnArrayIsMalformed) {
  for (const Bytes& item : kAnyItem) {
    EXPECT_EQ(decode_uplink(item), Decoded::kMalformed) << hex(item);
    EXPECT_EQ(decode_downlink(item), Decoded::kMalformed) << hex(item);
    EXPECT_EQ(decode_settings(item), Decoded::kMalformed) << hex(item);
  }
}

TEST(Refusal, AnUnknownKindIsDistinguishedFromAMalformedMessage) {
  // Kinds 0, one above the last, 255, 2^64 − 1, and any fields.
  const Bytes sequence = {0x01};
  const Bytes sample = {0x02};
  const Bytes start = {0x03};
  const Bytes session = {0x04};
  for (const Bytes& kind : {Bytes{0x00}, Bytes{0x0F}, Bytes{0x18, 0xFF}, kAnyItem[1]}) {
    const std::vector<Bytes> up = {kind, sequence, sample, start};
    EXPECT_EQ(decode_uplink(array_of(up)), Decoded::kUnknownKind);
    std::vector<Bytes> longer = up;
    longer.insert(longer.end(), {{0xF6}, {0x81, 0x01}});
    EXPECT_EQ(decode_uplink(array_of(longer)), Decoded::kUnknownKind);
    longer.back() = {0x41};
    EXPECT_EQ(decode_uplink(array_of(longer)), Decoded::kMalformed) << "cut short";
    EXPECT_EQ(decode_uplink(array_of({kind, sequence, sample})), Decoded::kMalformed);
    EXPECT_EQ(decode_downlink(array_of({kind, sequence, session})), Decoded::kUnknownKind);
    EXPECT_EQ(decode_downlink(array_of({kind, sequence})), Decoded::kMalformed);
    EXPECT_EQ(decode_downlink(array_of({kind, sequence, {0xF4}})), Decoded::kMalformed);
  }
  EXPECT_EQ(decode_uplink({0x84, 0x0F, 0x01, 0x02, 0x03, 0x00}), Decoded::kMalformed)
      << "a byte too many";
}

// Its number counts, so that the receiver must know its head.
TEST(Refusal, TheHeadOfAnUnknownKindIsRead) {
  const Bytes up = {0x84, 0x0F, 0x11, 0x12, 0x13};
  Uplink uplink;
  std::uint32_t sequence = 0;
  ASSERT_EQ(decode(up.data(), up.size(), uplink, sequence), Decoded::kUnknownKind);
  EXPECT_EQ(sequence, 0x11U);
  EXPECT_EQ(uplink.sample, 0x12U);
  EXPECT_EQ(uplink.start_number, 0x13U);
  const Bytes down = {0x83, 0x07, 0x11, 0x12};
  Downlink downlink;
  ASSERT_EQ(decode(down.data(), down.size(), downlink, sequence), Decoded::kUnknownKind);
  EXPECT_EQ(downlink.session, 0x12U);
}

TEST(Refusal, AMessageOfMoreThan560BytesIsMalformed) {
  // identify, and a text that is ignored: 9 bytes, and its contents.
  for (const std::size_t size : {kLongestMessage, kLongestMessage + 1}) {
    Bytes bytes = {0x84, 0x03, 0x00, 0x05, 0x79, 0, 0};
    const std::size_t text = size - bytes.size();
    bytes[5] = static_cast<std::uint8_t>(text >> 8);
    bytes[6] = static_cast<std::uint8_t>(text);
    bytes.resize(size, 'x');
    EXPECT_EQ(decode_downlink(bytes), size == 560 ? Decoded::kOk : Decoded::kMalformed);
    bytes[3] = 0x00;
    EXPECT_EQ(decode_downlink(bytes), Decoded::kMalformed) << "session 0";
  }
}

Decoded decode_hello(const std::function<void(Hello&)>& change) {
  Uplink message;
  std::strcpy(message.hello.id, "outlet-7");
  message.hello.sample_rate_hz = 8000;
  message.hello.nominal_hz = 50;
  change(message.hello);
  return decode_uplink(encoded(message, 0));
}

TEST(Refusal, AHelloOutOfItsRangesIsMalformed) {
  EXPECT_EQ(decode_hello([](Hello&) {}), Decoded::kOk);
  for (const char* const good : {"a", "A-z_0.9", "12345678901234567890123456789012"}) {
    EXPECT_EQ(decode_hello([&](Hello& hello) { std::strcpy(hello.id, good); }), Decoded::kOk);
  }
  for (const char* const bad : {"", "$x", "a b", "a/b", "+", "#", "a~"}) {
    const auto set = [&](Hello& hello) { std::strcpy(hello.id, bad); };
    EXPECT_EQ(decode_hello(set), Decoded::kMalformed) << bad;
    EXPECT_EQ(decode_hello([&](Hello& hello) {
                set(hello);
                hello.protocol_version = 4;
              }),
              Decoded::kMalformed)
        << bad;
  }
  const std::pair<std::int32_t, Decoded> rates[] = {
      {1000, Decoded::kOk},         {1000000, Decoded::kOk},    {0, Decoded::kMalformed},
      {-8000, Decoded::kMalformed}, {999, Decoded::kMalformed}, {1000001, Decoded::kMalformed}};
  for (const auto& [rate_hz, expected] : rates) {
    EXPECT_EQ(decode_hello([&, at = rate_hz](Hello& hello) { hello.sample_rate_hz = at; }),
              expected)
        << rate_hz;
  }
  for (const std::int32_t nominal_hz : {0, 49, 51, 55, 61, -50}) {
    EXPECT_EQ(decode_hello([&](Hello& hello) { hello.nominal_hz = nominal_hz; }),
              Decoded::kMalformed)
        << nominal_hz;
  }
  EXPECT_EQ(decode_hello([](Hello& hello) { hello.nominal_hz = 60; }), Decoded::kOk);
  for (float Hello::*const delay_s : {&Hello::tracker_delay_s, &Hello::voltage_delay_s}) {
    for (const float good_s : {0.0F, 1.0F}) {
      EXPECT_EQ(decode_hello([&](Hello& hello) { hello.*delay_s = good_s; }), Decoded::kOk);
    }
    for (const float bad_s : {-0.001F, 1.001F, std::nanf(""), HUGE_VALF}) {
      EXPECT_EQ(decode_hello([&](Hello& hello) { hello.*delay_s = bad_s; }), Decoded::kMalformed)
          << bad_s;
    }
  }
}

TEST(Refusal, ACommandWithRequestZeroIsMalformed) {
  EXPECT_EQ(decode_downlink({0x86, 0x02, 0x00, 0x05, 0x01, 0xF4, 0x00}), Decoded::kOk);
  EXPECT_EQ(decode_downlink({0x86, 0x02, 0x00, 0x05, 0x00, 0xF4, 0x00}), Decoded::kMalformed);
}

// Replaces a field of a message by an integer, and decodes it.
Decoded with_field(const Uplink& message, std::size_t field, std::uint64_t value) {
  std::vector<Bytes> items = items_of(encoded(message, kAnySequence));
  Bytes number(9);
  cbor::Writer writer(number.data(), number.size());
  writer.unsigned_integer(value);
  number.resize(writer.size());
  items.at((message.kind == UplinkKind::kHello ? 3 : 4) + field) = number;
  return decode_uplink(array_of(items));
}

TEST(Refusal, EnumeratorsOutOfRangeAreMalformed) {
  struct Range {
    UplinkKind kind;
    std::size_t field;
    std::uint64_t first;
    std::uint64_t last;
  };
  const Range ranges[] = {
      {UplinkKind::kSettingsAnswer, 0, 0, 13}, {UplinkKind::kMeasurement, 3, 0, 2},
      {UplinkKind::kEstimate, 3, 0, 5},        {UplinkKind::kDecision, 6, 0, 5},
      {UplinkKind::kRelay, 1, 0, 3},           {UplinkKind::kStatus, 2, 0, 3},
      {UplinkKind::kStatus, 3, 0, 2},          {UplinkKind::kError, 0, 1, 9}};
  std::mt19937 random(8);
  for (const Range& range : ranges) {
    const Uplink message = uplink(range.kind, Fill::kHighest, random);
    for (std::uint64_t value = 0; value < 600; ++value) {
      const bool in_range = value >= range.first && value <= range.last;
      EXPECT_EQ(with_field(message, range.field, value),
                in_range ? Decoded::kOk : Decoded::kMalformed)
          << to_string(range.kind) << " field " << range.field << " = " << value;
    }
  }
}

TEST(Refusal, NumbersOutOfRangeAreMalformed) {
  std::mt19937 random(9);
  const Uplink decision = uplink(UplinkKind::kDecision, Fill::kLowest, random);
  EXPECT_EQ(with_field(decision, 5, 0xFFFF), Decoded::kOk);
  EXPECT_EQ(with_field(decision, 5, 0x10000), Decoded::kMalformed);
  const Uplink echo = uplink(UplinkKind::kEcho, Fill::kLowest, random);
  EXPECT_EQ(with_field(echo, 0, 0xFFFFFFFF), Decoded::kOk);
  EXPECT_EQ(with_field(echo, 0, 0x100000000), Decoded::kMalformed);
  const Uplink hello = uplink(UplinkKind::kHello, Fill::kLowest, random);
  EXPECT_EQ(with_field(hello, 2, 0xFFFFFFFF), Decoded::kOk);
  EXPECT_EQ(with_field(hello, 2, 0x100000000), Decoded::kMalformed);
  // A sequence number of more than 32 bits.
  EXPECT_EQ(decode_downlink({0x83, 0x03, 0x1A, 0xFF, 0xFF, 0xFF, 0xFF, 0x05}), Decoded::kOk);
  EXPECT_EQ(decode_downlink({0x83, 0x03, 0x1B, 0, 0, 0, 1, 0, 0, 0, 0, 0x05}), Decoded::kMalformed);
}

// Decodes a settings message with this map, and the map alone.
void expect_settings(const Bytes& map, Decoded expected, const char* what) {
  EXPECT_EQ(decode_downlink(array_of({{0x01}, {0x05}, {0x06}, map})), expected) << what;
  EXPECT_EQ(decode_settings(map), expected) << what;
  for (std::size_t length = 0; length < map.size(); ++length) {
    const Bytes cut(map.begin(), map.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_EQ(decode_settings(cut), Decoded::kMalformed) << what << " cut to " << length;
  }
}

TEST(Refusal, SettingsWithWrongTypesOrDuplicateKeysAreMalformed) {
  expect_settings({0xA1, 0x10, 0x0A}, Decoded::kOk, "lse_samples 10");
  expect_settings({0xA1, 0x10, 0xFA, 0, 0, 0, 0}, Decoded::kMalformed, "a float for an integer");
  expect_settings({0xA1, 0x10, 0x20}, Decoded::kMalformed, "a negative number");
  expect_settings({0xA1, 0x10, 0x19, 0x01, 0x00}, Decoded::kMalformed, "256 in eight bits");
  expect_settings({0xA2, 0x10, 0x0A, 0x10, 0x0A}, Decoded::kMalformed, "a duplicate key");
  expect_settings({0xA2, 0x10, 0x0A, 0x18, 0x10, 0x0B}, Decoded::kMalformed,
                  "a duplicate key in another form");
  expect_settings({0xA1, 0x61, 'x', 0x0A}, Decoded::kMalformed, "a text for a key");
  expect_settings({0xA1, 0x06, 0x0A}, Decoded::kMalformed, "an integer for a float");
  expect_settings({0x82, 0x10, 0x0A}, Decoded::kMalformed, "an array instead of the map");
  expect_settings({0xBB, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x10, 0x0A},
                  Decoded::kMalformed, "a map with too large a count");
}

TEST(Refusal, SettingsWithAnUnknownKeyDecodeWithAnError) {
  for (const Bytes& value : kAnyItem) {
    const Bytes map = joined({0xA2, 0x18, 0xC8}, {value, {0x10, 0x0C}});
    const Bytes bytes = array_of({{0x01}, {0x05}, {0x06}, map});
    Downlink message;
    std::uint32_t sequence = 0;
    ASSERT_EQ(decode(bytes.data(), bytes.size(), message, sequence), Decoded::kOk) << hex(bytes);
    EXPECT_EQ(message.settings_error, outlet::SettingsError::kUnknownField);
    EXPECT_EQ(message.settings.lse_samples, 12) << "later keys are read";
    EXPECT_EQ(decode_settings(map), Decoded::kMalformed) << "stored by another firmware";
  }
}

TEST(Refusal, ConditionsHaveTwoNumbersPerRowAndAtMost32Rows) {
  const auto conditions = [](std::size_t numbers) {
    Bytes map = {0xA1, 0x0A, 0x98, static_cast<std::uint8_t>(numbers)};
    for (std::size_t i = 0; i < numbers; ++i) {
      map.insert(map.end(), {0xFA, 0x42, 0x47, 0, 0});
    }
    return map;
  };
  expect_settings(conditions(0), Decoded::kOk, "none");
  expect_settings(conditions(64), Decoded::kOk, "32 rows");
  expect_settings(conditions(66), Decoded::kMalformed, "33 rows");
  expect_settings(conditions(3), Decoded::kMalformed, "half a row");
  expect_settings({0xA1, 0x0A, 0x82, 0x01, 0x02}, Decoded::kMalformed, "integers");
}

}  // namespace
}  // namespace gs::wire::test
