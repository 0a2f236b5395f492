#include <vector>

#include <gtest/gtest.h>

#include <wire/frame.hpp>

namespace gs::wire {
namespace {

using Order = Sequence::Order;

struct Step {
  std::uint32_t number;
  Order order;
  std::uint32_t missed = 0;  // checked unless a duplicate
};

void expect_orders(Sequence& sequence, const std::vector<Step>& steps) {
  for (const Step& step : steps) {
    EXPECT_EQ(sequence.take(step.number), step.order) << step.number;
    if (step.order != Order::kDuplicate) {
      EXPECT_EQ(sequence.missed(), step.missed) << step.number;
    }
  }
}

void expect_orders(const std::vector<Step>& steps) {
  Sequence sequence;
  expect_orders(sequence, steps);
}

TEST(Sequence, AcceptsAnyFirstNumber) {
  for (const std::uint32_t first : {0U, 1U, 77U, 0x80000000U, 0xFFFFFFFFU}) {
    expect_orders({{first, Order::kNext}, {first + 1, Order::kNext}});
  }
}

TEST(Sequence, CountsTheNumbersMissingInAGap) {
  expect_orders(
      {{0, Order::kNext}, {2, Order::kGap, 1}, {3, Order::kNext}, {1004, Order::kGap, 1000}});
}

TEST(Sequence, DropsDuplicateAndLateMessages) {
  expect_orders({{10, Order::kNext},
                 {10, Order::kDuplicate},
                 {9, Order::kDuplicate},
                 {13, Order::kGap, 2},
                 {12, Order::kDuplicate},  // reordered: already counted as lost
                 {14, Order::kNext}});     // a duplicate changes nothing
}

TEST(Sequence, WrapsAfterTheLargestNumber) {
  expect_orders({{0xFFFFFFFEU, Order::kNext},
                 {0xFFFFFFFFU, Order::kNext},
                 {0, Order::kNext},
                 {0xFFFFFFFFU, Order::kDuplicate},
                 {1, Order::kNext}});
}

TEST(Sequence, CountsAGapAcrossTheWrap) {
  expect_orders({{0xFFFFFFFEU, Order::kNext}, {1, Order::kGap, 2}});
}

TEST(Sequence, HalfTheNumbersAreAheadAndHalfBehind) {
  expect_orders({{0, Order::kNext}, {0x80000000U, Order::kGap, 0x7FFFFFFFU}});
  expect_orders({{0, Order::kNext}, {0x80000001U, Order::kDuplicate}});
}

TEST(Sequence, AcceptsAnyNumberAfterARestart) {
  Sequence sequence;
  expect_orders(sequence, {{5000, Order::kNext}, {0, Order::kDuplicate}});
  sequence.restart();
  expect_orders(sequence, {{0, Order::kNext}, {1, Order::kNext}});
}

TEST(Sequence, CountsWhatIsMissingBeforeTheFirstIfItsNumberIsKnown) {
  Sequence sequence;
  sequence.expect(10);
  sequence.expect(20);
  expect_orders(sequence, {{23, Order::kGap, 3}});
  sequence.expect(30);
  expect_orders(sequence, {{24, Order::kNext}});
  for (const std::uint32_t first : {7U, 20U}) {
    sequence.restart();
    sequence.expect(20);
    expect_orders(sequence, {{first, Order::kNext}, {first + 1, Order::kNext}});
  }
  sequence.restart();
  expect_orders(sequence, {{99, Order::kNext}});
}

}  // namespace
}  // namespace gs::wire
