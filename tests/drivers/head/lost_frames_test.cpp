// A line that loses and damages frames: every sample is played exactly once, in order.
#include <head_driver_test/head_rig.hpp>

#include <random>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Loses one in `one_in` reads, or damages a byte of it, from the same sequence each time.
emulation::HeadEmulator::Spoiler spoiling(unsigned seed, int one_in, int& spoiled) {
  return [random = std::mt19937(seed), one_in, &spoiled](Bytes& bytes) mutable {
    if (random() % static_cast<unsigned>(one_in) != 0) {
      return;
    }
    ++spoiled;
    if (random() % 2 == 0) {
      bytes.clear();
    } else {
      bytes[random() % bytes.size()] ^= 0x10;
    }
  };
}

class HeadOnABadLine : public testing::TestWithParam<unsigned> {
 protected:
  HeadOnABadLine() {
    mains_.duration_s = 3.0;
    mains_.added = {0.01F, 5};  // no two periods are equal
  }
  void expect_every_sample_in_order() {
    const std::vector<std::uint16_t> expected = rig_.expected(mains_);
    EXPECT_LE(largest_difference(rig_.codes(), expected, expected.size()), 1);
  }

  HeadRig rig_;
  Mains mains_;
  int spoiled_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Seeds, HeadOnABadLine, testing::Range(1U, 5U));

TEST_P(HeadOnABadLine, PlaysEverySampleOnceAndInOrder) {
  rig_.head->spoil_from_bench(spoiling(GetParam(), 8, spoiled_));
  rig_.start(mains_);
  rig_.play(mains_);
  expect_every_sample_in_order();
  rig_.head->spoil_from_bench({});
  EXPECT_GE(spoiled_, 5);
}

TEST_P(HeadOnABadLine, DoesNotNeedEveryAnswer) {
  rig_.head->spoil_to_bench(spoiling(GetParam(), 4, spoiled_));
  rig_.start(mains_);
  rig_.play(mains_);
  expect_every_sample_in_order();
  rig_.head->spoil_to_bench({});
  EXPECT_GE(spoiled_, 5);
}

TEST_P(HeadOnABadLine, IsReportedAsSafeOnlyIfItIsOff) {
  rig_.start(mains_);
  advance(rig_.source(), 4000);
  rig_.head->spoil_from_bench(spoiling(GetParam(), 3, spoiled_));
  rig_.head->spoil_to_bench(spoiling(GetParam() + 100, 3, spoiled_));
  const auto safe = rig_.source().make_safe();
  EXPECT_TRUE(!safe.ok() || rig_.head->observe().state == gs::head::State::kOff);
  rig_.head->spoil_from_bench({});
  rig_.head->spoil_to_bench({});
}

// The last message before a pause is lost: nothing behind it shows the gap.
TEST_P(HeadOnABadLine, FindsTheLossOfTheLastMessage) {
  rig_.start(mains_);
  const auto played = rig_.source().advance(4000);
  ASSERT_TRUE(played.ok()) << played.error();
  rig_.head.freeze();
  bool lost = false;
  rig_.head->spoil_from_bench([&](Bytes& bytes) {
    if (!lost && bytes.size() > 60) {
      lost = true;
      bytes.clear();
    }
  });
  rig_.head.go_on();
  rig_.play(mains_, played.value());
  EXPECT_TRUE(lost);
  expect_every_sample_in_order();
  rig_.head->spoil_from_bench({});
}

}  // namespace
}  // namespace gsbench::test
