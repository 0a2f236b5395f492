// Damaged frames: no wrong message may be read, and the next frame must be.
#include <wire_test/messages.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include <wire/frame.hpp>

namespace gs::wire::test {
namespace {

// frames_in() with a new reader.
std::vector<Bytes> read_frames(const Bytes& stream) {
  FrameReader reader;
  return frames_in(reader, stream);
}

// One message of every kind, and the longest.
std::vector<Bytes> intact_messages() {
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
    // Keeps two bytes: with fewer there is no sign of a frame.
    {"CutFrame", 1,
     [](Bytes& frame, std::size_t length) { frame.resize(std::max<std::size_t>(length, 2)); }}};

class FrameDamage : public testing::TestWithParam<Damage> {};

INSTANTIATE_TEST_SUITE_P(Every, FrameDamage, testing::ValuesIn(kDamages),
                         [](const auto& damage) { return damage.param.name; });

// The damaged frame must be read as the original message or as a bad frame, and the next one
// always.
TEST_P(FrameDamage, IsDetected) {
  const Bytes next = framed(kAfter);
  int damaged_frames = 0;
  for (const Bytes& message : intact_messages()) {
    const Bytes frame = framed(message);
    for (std::size_t place = 0; place < GetParam().places_per_byte * frame.size(); ++place) {
      Bytes damaged = frame;
      GetParam().at(damaged, place);
      damaged.insert(damaged.end(), next.begin(), next.end());
      std::vector<Bytes> found = read_frames(damaged);
      ASSERT_FALSE(found.empty()) << hex(damaged);
      EXPECT_EQ(found.back(), kAfter) << hex(damaged);
      found.pop_back();
      const auto bad = std::count(found.begin(), found.end(), Bytes{});
      const auto whole = std::count(found.begin(), found.end(), message);
      EXPECT_EQ(static_cast<std::size_t>(bad + whole), found.size())
          << "a wrong message from " << hex(damaged);
      EXPECT_LE(whole, 1) << hex(damaged);
      if (whole == 0) {
        ++damaged_frames;
        EXPECT_GE(bad, 1) << "a lost frame was not reported: " << hex(damaged);
      }
    }
  }
  EXPECT_GT(damaged_frames, 0);
}

TEST(TwoFlippedBits, InAShortFrameAreDetected) {
  const Bytes message = {0x84, 0x0D, 0x01, 0x18, 0x80, 0x07};  // echo
  const Bytes frame = framed(message);
  for (std::size_t a = 0; a < 8 * frame.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      Bytes damaged = frame;
      flip_bit(damaged, a);
      flip_bit(damaged, b);
      for (const Bytes& found : read_frames(damaged)) {
        EXPECT_TRUE(found.empty() || found == message);
      }
    }
  }
}

TEST(RandomBytes, DoNotHideTheNextFrame) {
  std::mt19937 random(6);
  for (int i = 0; i < 20000; ++i) {
    Bytes stream(random() % 700);
    const std::uint32_t bound = i % 2 == 0 ? 256 : 4;  // also with many zeros and short groups
    for (std::uint8_t& byte : stream) {
      byte = static_cast<std::uint8_t>(random() % bound);
    }
    const Bytes frame = framed(kAfter);
    stream.insert(stream.end(), frame.begin(), frame.end());
    const std::vector<Bytes> found = read_frames(stream);
    ASSERT_FALSE(found.empty()) << hex(stream);
    EXPECT_EQ(found.back(), kAfter) << hex(stream);
    EXPECT_EQ(std::count(found.begin(), found.end(), Bytes{}),
              static_cast<std::ptrdiff_t>(found.size() - 1));
  }
}

}  // namespace
}  // namespace gs::wire::test
