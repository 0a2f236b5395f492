// Frames that suffer on the line: nothing false may arrive, and what follows must.
#include <wire_test/messages.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include <wire/frame.hpp>

namespace gs::wire::test {
namespace {

struct Heard {
  std::vector<Bytes> messages;
  int bad_frames = 0;
};

Heard hear(const Bytes& stream) {
  FrameReader reader;
  Heard heard;
  for (const std::uint8_t byte : stream) {
    const FrameReader::Taken taken = reader.take(byte);
    if (taken == FrameReader::Taken::kMessage) {
      heard.messages.emplace_back(reader.message(), reader.message() + reader.size());
    }
    heard.bad_frames += taken == FrameReader::Taken::kBadFrame ? 1 : 0;
  }
  return heard;
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

// Damages one frame in each way `damage` lists; the damaged one must be heard whole or not at all,
// and the one after it always. Returns how many were not heard.
template <class Damage>
int count_unheard(Damage damage) {
  int unheard = 0;
  for (const Bytes& message : victims()) {
    const Bytes frame = framed(message);
    for (Bytes& damaged : damage(frame)) {
      const Bytes next = framed(kAfter);
      damaged.insert(damaged.end(), next.begin(), next.end());
      const Heard heard = hear(damaged);
      EXPECT_FALSE(heard.messages.empty()) << hex(damaged);
      if (heard.messages.empty()) continue;
      EXPECT_EQ(heard.messages.back(), kAfter) << hex(damaged);
      for (std::size_t i = 0; i + 1 < heard.messages.size(); ++i) {
        EXPECT_EQ(heard.messages[i], message) << "a false message from " << hex(damaged);
      }
      EXPECT_LE(heard.messages.size(), 2U);
      if (heard.messages.size() == 1) {
        ++unheard;
        EXPECT_GE(heard.bad_frames, 1) << "a lost frame that nobody was told of: " << hex(damaged);
      }
    }
  }
  return unheard;
}

TEST(FrameDamage, EverySingleFlippedBitIsFoundOut) {
  const int unheard = count_unheard([](const Bytes& frame) {
    std::vector<Bytes> all;
    for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
      Bytes damaged = frame;
      damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
      all.push_back(std::move(damaged));
    }
    return all;
  });
  EXPECT_GT(unheard, 0);
}

TEST(FrameDamage, EveryPairOfFlippedBitsInAShortFrameIsFoundOut) {
  const Bytes message = {0x84, 0x0D, 0x01, 0x18, 0x80, 0x07};  // echo
  const Bytes frame = framed(message);
  for (std::size_t a = 0; a < 8 * frame.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      Bytes damaged = frame;
      damaged[a / 8] = static_cast<std::uint8_t>(damaged[a / 8] ^ (1U << (a % 8)));
      damaged[b / 8] = static_cast<std::uint8_t>(damaged[b / 8] ^ (1U << (b % 8)));
      for (const Bytes& heard : hear(damaged).messages) EXPECT_EQ(heard, message);
    }
  }
}

TEST(FrameDamage, EveryDroppedByteIsFoundOut) {
  const int unheard = count_unheard([](const Bytes& frame) {
    std::vector<Bytes> all;
    for (std::size_t at = 0; at < frame.size(); ++at) {
      Bytes damaged = frame;
      damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(at));
      all.push_back(std::move(damaged));
    }
    return all;
  });
  EXPECT_GT(unheard, 0);
}

TEST(FrameDamage, EveryDoubledByteIsFoundOut) {
  const int unheard = count_unheard([](const Bytes& frame) {
    std::vector<Bytes> all;
    for (std::size_t at = 0; at < frame.size(); ++at) {
      Bytes damaged = frame;
      damaged.insert(damaged.begin() + static_cast<std::ptrdiff_t>(at), frame[at]);
      all.push_back(std::move(damaged));
    }
    return all;
  });
  EXPECT_GT(unheard, 0);
}

TEST(FrameDamage, EveryPairOfSwappedBytesIsFoundOut) {
  const int unheard = count_unheard([](const Bytes& frame) {
    std::vector<Bytes> all;
    for (std::size_t at = 0; at + 1 < frame.size(); ++at) {
      Bytes damaged = frame;
      std::swap(damaged[at], damaged[at + 1]);
      all.push_back(std::move(damaged));
    }
    return all;
  });
  EXPECT_GT(unheard, 0);
}

TEST(FrameDamage, AFrameCutAnywhereIsFoundOut) {
  count_unheard([](const Bytes& frame) {
    std::vector<Bytes> all;
    for (std::size_t length = 2; length < frame.size(); ++length) {
      all.emplace_back(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(length));
    }
    return all;
  });
}

TEST(FrameDamage, AfterAnyJunkTheNextFrameArrives) {
  std::mt19937 random(6);
  for (int i = 0; i < 20000; ++i) {
    Bytes stream(random() % 700);
    const std::uint32_t bound = i % 2 == 0 ? 256 : 4;  // also with many zeros and short groups
    for (std::uint8_t& byte : stream) byte = static_cast<std::uint8_t>(random() % bound);
    const Bytes frame = framed(kAfter);
    stream.insert(stream.end(), frame.begin(), frame.end());
    const Heard heard = hear(stream);
    ASSERT_EQ(heard.messages.size(), 1U) << hex(stream);
    EXPECT_EQ(heard.messages.back(), kAfter);
  }
}

}  // namespace
}  // namespace gs::wire::test
