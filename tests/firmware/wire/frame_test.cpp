// Frames of any length and content are read as they were written.
#include <wire_test/messages.hpp>

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include <outlet/crc32.hpp>
#include <wire/frame.hpp>

namespace gs::wire::test {
namespace {

// Contents that exercise COBS: no zeros, only zeros, zeros at the ends of groups.
std::vector<Bytes> contents(std::size_t length) {
  Bytes counting(length);
  std::iota(counting.begin(), counting.end(), std::uint8_t{1});
  Bytes zeros_at_ends(length, 0x55);
  for (std::size_t i = 0; i < length; ++i) {
    if (i % 254 == 0 || i % 254 == 253) {
      zeros_at_ends[i] = 0;
    }
  }
  std::mt19937 random(static_cast<std::uint32_t>(length));
  Bytes random_bytes(length);
  for (std::uint8_t& byte : random_bytes) {
    byte = static_cast<std::uint8_t>(random() % 4);
  }
  return {Bytes(length, 0xFF), Bytes(length, 0), counting, zeros_at_ends, random_bytes};
}

TEST(Crc, HasItsCheckValue) {
  constexpr std::uint8_t kCheck[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  outlet::Crc32 crc;
  crc.add(kCheck, sizeof kCheck);
  EXPECT_EQ(crc.value(), 0xCBF43926U);
}

TEST(Frame, EveryLengthArrivesAsSent) {
  FrameReader reader;
  for (std::size_t length = 1; length <= kLongestMessage; ++length) {
    for (const Bytes& message : contents(length)) {
      const Bytes frame = framed(message);
      ASSERT_GE(frame.size(), length + kCrcLength + 3);
      EXPECT_EQ(frame.front(), 0);
      EXPECT_EQ(frame.back(), 0);
      EXPECT_EQ(std::count(frame.begin(), frame.end(), 0), 2) << "length " << length;
      ASSERT_EQ(frames_in(reader, frame), std::vector<Bytes>{message}) << "length " << length;
    }
  }
}

TEST(Frame, TheCrcFollowsTheMessageLeastSignificantByteFirst) {
  // The check text and its CRC 0xCBF43926 contain no zero: a single group.
  const Bytes message = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(hex(framed(message)), "00 0e 31 32 33 34 35 36 37 38 39 26 39 f4 cb 00");
}

TEST(Frame, TheLongestHasTheDeclaredLength) {
  std::size_t longest = 0;
  for (const Bytes& message : contents(kLongestMessage)) {
    longest = std::max(longest, framed(message).size());
  }
  EXPECT_EQ(longest, kLongestFrame);
}

TEST(Frame, EmptyAndTooLongMessagesAreNotFramed) {
  EXPECT_TRUE(framed({}).empty());
  for (std::size_t length = kLongestMessage + 1; length <= kLongestMessage + 40; ++length) {
    Bytes out(2 * length);
    EXPECT_EQ(frame(Bytes(length, 1).data(), length, out.data(), out.size()), 0U);
  }
}

TEST(Frame, ABufferThatIsTooShortIsRefused) {
  const Bytes message = contents(300)[2];
  const std::size_t size = framed(message).size();
  for (std::size_t capacity = 0; capacity < size; ++capacity) {
    Bytes out(capacity);
    EXPECT_EQ(frame(message.data(), message.size(), out.data(), capacity), 0U) << capacity;
  }
  Bytes out(size);
  EXPECT_EQ(frame(message.data(), message.size(), out.data(), size), size);
}

// Other encoders may omit the empty group that this encoder writes after a full last group.
TEST(Frame, AFullLastGroupNeedsNoEmptyGroup) {
  const Bytes message(250, 0x31);  // its CRC contains no zero: one full group
  Bytes frame = framed(message);
  ASSERT_EQ(frame.size(), 258U);
  ASSERT_EQ(frame[1], 0xFF) << "the CRC contains a zero; use another message";
  ASSERT_EQ(frame[256], 0x01);
  frame.erase(frame.begin() + 256);
  FrameReader reader;
  EXPECT_EQ(frames_in(reader, frame), std::vector<Bytes>{message});
}

TEST(Frame, OneZeroOrManySeparateFrames) {
  const Bytes message = {1, 0, 2};
  const Bytes frame = framed(message);
  Bytes stream(100, 0);
  stream.insert(stream.end(), frame.begin(), frame.end());
  stream.insert(stream.end(), frame.begin() + 1, frame.end());  // shares the zero before it
  stream.insert(stream.end(), 100, 0);
  FrameReader reader;
  EXPECT_EQ(frames_in(reader, stream), (std::vector<Bytes>{message, message}));
}

TEST(Frame, IsBadIfTooShortForAMessageAndItsCrc) {
  FrameReader reader;
  // Valid COBS frames of 1 … 4 bytes. Four bytes are the correct CRC of an empty message.
  for (const Bytes& bytes :
       {Bytes{2, 1, 0}, Bytes{3, 1, 2, 0}, Bytes{4, 1, 2, 3, 0}, Bytes{1, 1, 1, 1, 0}}) {
    EXPECT_EQ(frames_in(reader, bytes), std::vector<Bytes>{{}}) << hex(bytes);
  }
}

TEST(Frame, IsBadIfTooLongAndTheNextIsRead) {
  FrameReader reader;
  const Bytes message = {7};
  const Bytes next = framed(message);
  // Code bytes 1: each group decodes to one zero.
  for (const std::size_t length : {kLongestMessage + kCrcLength + 2, std::size_t{100'000}}) {
    Bytes stream(length, 1);
    stream.insert(stream.end(), next.begin(), next.end());
    EXPECT_EQ(frames_in(reader, stream), (std::vector<Bytes>{{}, message}));
  }
}

}  // namespace
}  // namespace gs::wire::test
