// Frames that suffer on the line: nothing false may arrive, and what follows must.
#include <wire_test/messages.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include <wire/frame.hpp>

namespace gs::wire::test {
namespace {

// As frames_in().
std::vector<Bytes> hear(const Bytes& stream) {
  FrameReader reader;
  return frames_in(reader, stream);
}

// One of every kind and the longest of all.
std::vector<Bytes> victims() {
  std::vector<Bytes> all;
  std::mt19937 random(5);
  for (const UplinkKind kind : uplink_kinds()) {
    all.push_back(encoded(uplink(kind, Fill::kAnything, random), 100));
  }
  for (const DownlinkKind kind : downlink_kinds()) {
    all.push_back(encoded(downlink(kind, Fill::kAnything, random), 200));
  }
  all.push_back(encoded(downlink(DownlinkKind::kSettings, Fill::kLongest, random), 0));
  all.emplace_back(300, std::uint8_t{0});
  return all;
}

const Bytes kAfter = {0x82, 0x03, 0x18, 0x64};  // identify, number 100

struct Damage {
  const char* name;
  std::size_t places_per_byte;
  void (*at)(Bytes& frame, std::size_t place);
};

void PrintTo(const Damage& damage, std::ostream* out) {
  *out << damage.name;
}

void flip_bit(Bytes& frame, std::size_t bit) {
  frame[bit / 8] = static_cast<std::uint8_t>(frame[bit / 8] ^ (1U << (bit % 8)));
}

Bytes::iterator at(Bytes& frame, std::size_t place) {
  return frame.begin() + static_cast<std::ptrdiff_t>(place);
}

const Damage kDamages[] = {
    {"FlippedBit", 8, flip_bit},
    {"DroppedByte", 1, [](Bytes& frame, std::size_t byte) { frame.erase(at(frame, byte)); }},
    {"DoubledByte", 1,
     [](Bytes& frame, std::size_t byte) { frame.insert(at(frame, byte), frame[byte]); }},
    {"PairOfSwappedBytes", 1,
     [](Bytes& frame, std::size_t byte) {
       if (byte + 1 < frame.size()) {
         std::swap(frame[byte], frame[byte + 1]);
       }
     }},
    // Of less than two bytes nothing tells that there was a frame.
    {"CutFrame", 1,
     [](Bytes& frame, std::size_t length) { frame.resize(std::max<std::size_t>(length, 2)); }}};

class FrameDamage : public testing::TestWithParam<Damage> {};

INSTANTIATE_TEST_SUITE_P(Every, FrameDamage, testing::ValuesIn(kDamages),
                         [](const auto& damage) { return damage.param.name; });

// The damaged frame must be heard whole or not at all, and the one after it always.
TEST_P(FrameDamage, IsFoundOut) {
  const Bytes next = framed(kAfter);
  int unheard = 0;
  for (const Bytes& message : victims()) {
    const Bytes frame = framed(message);
    for (std::size_t place = 0; place < GetParam().places_per_byte * frame.size(); ++place) {
      Bytes damaged = frame;
      GetParam().at(damaged, place);
      damaged.insert(damaged.end(), next.begin(), next.end());
      std::vector<Bytes> heard = hear(damaged);
      ASSERT_FALSE(heard.empty()) << hex(damaged);
      EXPECT_EQ(heard.back(), kAfter) << hex(damaged);
      heard.pop_back();
      const auto bad = std::count(heard.begin(), heard.end(), Bytes{});
      const auto whole = std::count(heard.begin(), heard.end(), message);
      EXPECT_EQ(static_cast<std::size_t>(bad + whole), heard.size())
          << "a false message from " << hex(damaged);
      EXPECT_LE(whole, 1) << hex(damaged);
      if (whole == 0) {
        ++unheard;
        EXPECT_GE(bad, 1) << "a lost frame that nobody was told of: " << hex(damaged);
      }
    }
  }
  EXPECT_GT(unheard, 0);
}

TEST(TwoFlippedBits, InAShortFrameAreFoundOut) {
  const Bytes message = {0x84, 0x0D, 0x01, 0x18, 0x80, 0x07};  // echo
  const Bytes frame = framed(message);
  for (std::size_t a = 0; a < 8 * frame.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      Bytes damaged = frame;
      flip_bit(damaged, a);
      flip_bit(damaged, b);
      for (const Bytes& heard : hear(damaged)) {
        EXPECT_TRUE(heard.empty() || heard == message);
      }
    }
  }
}

TEST(AnyJunk, IsFollowedByTheNextFrame) {
  std::mt19937 random(6);
  for (int i = 0; i < 20000; ++i) {
    Bytes stream(random() % 700);
    const std::uint32_t bound = i % 2 == 0 ? 256 : 4;  // also with many zeros and short groups
    for (std::uint8_t& byte : stream) {
      byte = static_cast<std::uint8_t>(random() % bound);
    }
    const Bytes frame = framed(kAfter);
    stream.insert(stream.end(), frame.begin(), frame.end());
    const std::vector<Bytes> heard = hear(stream);
    ASSERT_FALSE(heard.empty()) << hex(stream);
    EXPECT_EQ(heard.back(), kAfter) << hex(stream);
    EXPECT_EQ(std::count(heard.begin(), heard.end(), Bytes{}),
              static_cast<std::ptrdiff_t>(heard.size() - 1));
  }
}

}  // namespace
}  // namespace gs::wire::test
