#include <array>

#include <gtest/gtest.h>
#include <queues/queues.hpp>

namespace gs::queues {
namespace {

TEST(ByteRing, ReturnsBytesInOrder) {
  ByteRing<8> ring;
  std::uint8_t next_in = 0;
  std::uint8_t next_out = 0;
  for (int round = 0; round < 200; ++round) {
    for (int i = 0; i < 5; ++i) {
      ASSERT_TRUE(ring.put(next_in++));
    }
    for (int i = 0; i < 5; ++i) {
      std::uint8_t byte = 0;
      ASSERT_TRUE(ring.take(byte));
      ASSERT_EQ(byte, next_out++);
    }
  }
  std::uint8_t byte = 0;
  EXPECT_FALSE(ring.take(byte));
}

TEST(ByteRing, TakesAllBytesOrNone) {
  ByteRing<8> ring;
  const std::array<std::uint8_t, 5> message = {1, 2, 3, 4, 5};
  EXPECT_TRUE(ring.put(message.data(), message.size()));
  EXPECT_FALSE(ring.put(message.data(), message.size()));
  EXPECT_EQ(ring.used(), 5U);
  EXPECT_TRUE(ring.put(message.data(), 3));
  EXPECT_EQ(ring.room(), 0U);
  EXPECT_FALSE(ring.put(9));
}

TEST(ByteRing, IsEmptyAfterClear) {
  ByteRing<8> ring;
  const std::array<std::uint8_t, 5> message = {1, 2, 3, 4, 5};
  ASSERT_TRUE(ring.put(message.data(), message.size()));
  ring.clear();
  EXPECT_EQ(ring.used(), 0U);
  EXPECT_TRUE(ring.put(message.data() + 2, 1));
  std::uint8_t byte = 0;
  EXPECT_TRUE(ring.take(byte));
  EXPECT_EQ(byte, 3);
}

using Queue = SampleQueue<16>;

void put(Queue& queue, std::int16_t first) {
  std::array<std::int16_t, 4> block = {};
  for (std::size_t i = 0; i < 4; ++i) {
    block[i] = static_cast<std::int16_t>(first + static_cast<int>(i));
  }
  queue.put(block.data(), 4);
}

TEST(SampleQueue, ReturnsSamplesInOrder) {
  Queue queue;
  std::int16_t next_in = 0;
  std::int16_t next_out = 0;
  for (int round = 0; round < 100; ++round) {
    put(queue, next_in);
    next_in = static_cast<std::int16_t>(next_in + 4);
    std::array<std::int16_t, 3> out = {};
    std::uint32_t lost = 1;
    for (std::size_t count = 1; count > 0;) {
      count = queue.take(out.data(), out.size(), lost);
      ASSERT_EQ(lost, 0U);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(out.at(i), next_out++);
      }
    }
  }
  EXPECT_EQ(next_out, 400);
}

TEST(SampleQueue, ReportsLostSamplesAtTheirPlace) {
  Queue queue;
  for (std::int16_t first = 0; first < 24; first = static_cast<std::int16_t>(first + 4)) {
    put(queue, first);  // the last two do not fit
  }
  std::array<std::int16_t, 16> out = {};
  std::uint32_t lost = 9;
  ASSERT_EQ(queue.take(out.data(), 12, lost), 12U);
  EXPECT_EQ(lost, 0U);
  put(queue, 100);  // would fit, but comes after the gap
  ASSERT_EQ(queue.take(out.data(), 16, lost), 4U);
  EXPECT_EQ(out[3], 15);
  EXPECT_FALSE(queue.idle());
  ASSERT_EQ(queue.take(out.data(), 16, lost), 0U);
  EXPECT_EQ(lost, 12U);
  EXPECT_TRUE(queue.idle());
  put(queue, 200);
  ASSERT_EQ(queue.take(out.data(), 16, lost), 4U);
  EXPECT_EQ(lost, 0U);
  EXPECT_EQ(out[0], 200);
}

}  // namespace
}  // namespace gs::queues
