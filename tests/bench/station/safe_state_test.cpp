#include "fake_station.hpp"
#include <test_support/mains.hpp>

#include <stdexcept>

#include <gtest/gtest.h>

#include <station/safe_state.hpp>

namespace gsbench::station::test {
namespace {

TEST(SafeState, IsReachedAtTheEndOfItsScopeAndNotBefore) {
  const gsbench::test::Mains mains;
  std::string failure;
  FakeStation station({});
  {
    const SafeState safe_state(station.source(), station.link(), failure);
    gsbench::test::start(station.source(), mains);
    EXPECT_TRUE(station.link().open().ok());
    EXPECT_FALSE(station.is_safe());
  }
  EXPECT_TRUE(station.is_safe());
}

TEST(SafeState, IsReachedByAnException) {
  const gsbench::test::Mains mains;
  std::string failure;
  FakeStation station({});
  const auto fail = [&] {
    const SafeState safe_state(station.source(), station.link(), failure);
    gsbench::test::start(station.source(), mains);
    throw std::runtime_error("a fault");
  };
  EXPECT_THROW(fail(), std::runtime_error);
  EXPECT_TRUE(station.is_safe());
}

TEST(SafeState, IsReachedWhereNothingWasEverStarted) {
  std::string failure;
  FakeStation station({});
  { const SafeState safe_state(station.source(), station.link(), failure); }
  EXPECT_TRUE(station.is_safe());
}

TEST(SafeState, TellsWhereTheSourceDidNotReachIt) {
  Script script;
  script.make_safe_error = "fake source: relay welded";
  FakeStation station(script);
  std::string failure;
  { const SafeState safe_state(station.source(), station.link(), failure); }
  EXPECT_EQ(failure, "the source may still be live: fake source: relay welded");
}

}  // namespace
}  // namespace gsbench::station::test
