#include <gtest/gtest.h>

#include <wire/frame.hpp>

namespace gs::wire {
namespace {

using Order = Sequence::Order;

TEST(Sequence, TakesTheFirstWhateverItsNumber) {
  for (const std::uint32_t first : {0U, 1U, 77U, 0x80000000U, 0xFFFFFFFFU}) {
    Sequence sequence;
    EXPECT_EQ(sequence.take(first), Order::kNext);
    EXPECT_EQ(sequence.missed(), 0U);
    EXPECT_EQ(sequence.take(first + 1), Order::kNext);
  }
}

TEST(Sequence, CountsWhatAGapLeavesOut) {
  Sequence sequence;
  EXPECT_EQ(sequence.take(0), Order::kNext);
  EXPECT_EQ(sequence.take(2), Order::kGap);
  EXPECT_EQ(sequence.missed(), 1U);
  EXPECT_EQ(sequence.take(3), Order::kNext);
  EXPECT_EQ(sequence.missed(), 0U);
  EXPECT_EQ(sequence.take(1004), Order::kGap);
  EXPECT_EQ(sequence.missed(), 1000U);
}

TEST(Sequence, DropsWhatComesTwiceOrLate) {
  Sequence sequence;
  EXPECT_EQ(sequence.take(10), Order::kNext);
  EXPECT_EQ(sequence.take(10), Order::kDuplicate);
  EXPECT_EQ(sequence.take(9), Order::kDuplicate);
  EXPECT_EQ(sequence.take(13), Order::kGap);
  EXPECT_EQ(sequence.take(12), Order::kDuplicate) << "reordered: its place was told as lost";
  EXPECT_EQ(sequence.take(14), Order::kNext) << "a duplicate changes nothing";
}

TEST(Sequence, GoesOnBeyondTheGreatestNumber) {
  Sequence sequence;
  EXPECT_EQ(sequence.take(0xFFFFFFFEU), Order::kNext);
  EXPECT_EQ(sequence.take(0xFFFFFFFFU), Order::kNext);
  EXPECT_EQ(sequence.take(0), Order::kNext);
  EXPECT_EQ(sequence.take(0xFFFFFFFFU), Order::kDuplicate);
  EXPECT_EQ(sequence.take(1), Order::kNext);
}

TEST(Sequence, CountsAGapOverTheGreatestNumber) {
  Sequence sequence;
  EXPECT_EQ(sequence.take(0xFFFFFFFEU), Order::kNext);
  EXPECT_EQ(sequence.take(1), Order::kGap);
  EXPECT_EQ(sequence.missed(), 2U);
}

TEST(Sequence, HalfTheNumbersAreAheadAndHalfBehind) {
  Sequence ahead;
  EXPECT_EQ(ahead.take(0), Order::kNext);
  EXPECT_EQ(ahead.take(0x80000000U), Order::kGap);
  EXPECT_EQ(ahead.missed(), 0x7FFFFFFFU);
  Sequence behind;
  EXPECT_EQ(behind.take(0), Order::kNext);
  EXPECT_EQ(behind.take(0x80000001U), Order::kDuplicate);
}

TEST(Sequence, TakesAnyNumberAfterARestart) {
  Sequence sequence;
  EXPECT_EQ(sequence.take(5000), Order::kNext);
  EXPECT_EQ(sequence.take(0), Order::kDuplicate);
  sequence.restart();
  EXPECT_EQ(sequence.take(0), Order::kNext);
  EXPECT_EQ(sequence.take(1), Order::kNext);
}

}  // namespace
}  // namespace gs::wire
