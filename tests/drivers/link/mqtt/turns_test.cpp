// Two units with one client id differ from one unit that restarts, or whose hellos are late.
#include <turns.hpp>

#include <gtest/gtest.h>

namespace gsbench::link {
namespace {

constexpr bool kHadLeft = true;

TEST(Turns, TwoReturnsToAnEarlierStartAreTwoUnits) {
  Turns turns;
  EXPECT_FALSE(turns.take(1, 0, kHadLeft));
  EXPECT_FALSE(turns.take(2, 0, kHadLeft));
  EXPECT_FALSE(turns.take(1, 1, kHadLeft));
  EXPECT_TRUE(turns.take(2, 1, kHadLeft));
}

TEST(Turns, OneUnitThatRestartsLeavesAndIsAskedOftenIsOne) {
  Turns turns;
  for (std::uint32_t start = 0; start < 100; ++start) {
    for (std::uint32_t hello = 0; hello < 5; ++hello) {
      EXPECT_FALSE(turns.take(start, hello, hello % 2 == 0));
    }
  }
}

TEST(Turns, HellosThatComeAgainOrLateAreNoReturns) {
  Turns turns;
  EXPECT_FALSE(turns.take(1, 4, kHadLeft));
  EXPECT_FALSE(turns.take(2, 0, kHadLeft));
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(turns.take(1, 4, kHadLeft)) << "repeated";
    EXPECT_FALSE(turns.take(1, 3, kHadLeft)) << "older";
    EXPECT_FALSE(turns.take(1, 5, !kHadLeft)) << "overtaken";
    EXPECT_FALSE(turns.take(2, 0, kHadLeft)) << "repeated";
  }
}

}  // namespace
}  // namespace gsbench::link
