#include "fake_station.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include <station/safe_state.hpp>

namespace gsbench::station::test {
namespace {

TEST(SafeState, IsReachedAtTheEndOfItsScopeAndNotBefore) {
  FakeStation station({});
  {
    const SafeState safe_state(station.source(), station.link());
    EXPECT_TRUE(station.source().start({}).ok());
    EXPECT_TRUE(station.link().open().ok());
    EXPECT_FALSE(station.is_safe());
  }
  EXPECT_TRUE(station.is_safe());
}

TEST(SafeState, IsReachedByAnException) {
  FakeStation station({});
  const auto fail = [&] {
    const SafeState safe_state(station.source(), station.link());
    EXPECT_TRUE(station.source().start({}).ok());
    throw std::runtime_error("a fault");
  };
  EXPECT_THROW(fail(), std::runtime_error);
  EXPECT_TRUE(station.is_safe());
}

TEST(SafeState, IsReachedWhereNothingWasEverStarted) {
  FakeStation station({});
  { const SafeState safe_state(station.source(), station.link()); }
  EXPECT_TRUE(station.is_safe());
}

}  // namespace
}  // namespace gsbench::station::test
