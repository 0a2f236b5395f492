#include "fake_station.hpp"
#include <test_support/mains.hpp>

#include <stdexcept>

#include <gtest/gtest.h>

#include <station/safe_state.hpp>

namespace gsbench::station::test {
namespace {

class SafeStateTest : public testing::Test {
 protected:
  const gsbench::test::Mains mains_{};
  FakeStation station_{Script{}};
  std::string failure_;
};

TEST_F(SafeStateTest, IsReachedAtTheEndOfTheScope) {
  {
    const SafeState safe_state(station_.source(), station_.link(), failure_);
    gsbench::test::start(station_.source(), mains_);
    EXPECT_TRUE(station_.link().open().ok());
    EXPECT_FALSE(station_.is_safe());
  }
  EXPECT_TRUE(station_.is_safe());
  EXPECT_EQ(failure_, "");
}

TEST_F(SafeStateTest, IsReachedAfterAnException) {
  const auto fail = [&] {
    const SafeState safe_state(station_.source(), station_.link(), failure_);
    gsbench::test::start(station_.source(), mains_);
    throw std::runtime_error("a fault");
  };
  EXPECT_THROW(fail(), std::runtime_error);
  EXPECT_TRUE(station_.is_safe());
}

TEST_F(SafeStateTest, ReportsASourceThatCannotBeSwitchedOff) {
  FakeStation welded(with(&Script::make_safe_error, "fake source: relay welded"));
  { const SafeState safe_state(welded.source(), welded.link(), failure_); }
  EXPECT_TRUE(welded.is_safe());
  EXPECT_EQ(
      failure_,
      "output state unknown: fake source: relay welded. The outlets may be live: switch the source "
      "off by hand, or unplug it.");
}

}  // namespace
}  // namespace gsbench::station::test
