#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <campaign/tally.hpp>

namespace {

using gsbench::campaign::Tally;

Tally of(const std::vector<double>& values) {
  Tally tally(0.0, 100.0, 1000);
  for (const double value : values) {
    tally.add(value);
  }
  return tally;
}

TEST(Tally, MeanAndDeviationAreThoseOfTheValues) {
  const Tally tally = of({10.0, 20.0, 60.0, 90.0});
  EXPECT_EQ(tally.count(), 4);
  EXPECT_NEAR(tally.mean(), 45.0, 1e-4);
  EXPECT_NEAR(tally.standard_deviation(), 36.9685, 1e-2);
  EXPECT_EQ(tally.smallest(), 10.0);
  EXPECT_EQ(tally.largest(), 90.0);
}

TEST(Tally, ASmallSpreadFarFromTheMiddleIsKept) {
  Tally tally(0.0, 1000.0, 20000);
  for (int i = 0; i < 1000; ++i) {
    tally.add(i % 2 == 0 ? 899.0 : 901.0);
  }
  EXPECT_NEAR(tally.standard_deviation(), 1.0005, 1e-3);
}

TEST(Tally, CountsWhatLiesWithinEdgesAndWhatLiesOutside) {
  const Tally tally = of({-5.0, 10.0, 19.99, 20.0, 99.99, 100.0, 1000.0});
  EXPECT_EQ(tally.count(), 7);
  EXPECT_EQ(tally.count_between(10.0, 20.0), 2);
  EXPECT_EQ(tally.count_between(0.0, 100.0), 4);
  EXPECT_DOUBLE_EQ(tally.share_between(0.0, 100.0), 4.0 / 7.0);
  EXPECT_EQ(tally.smallest(), -5.0);
  EXPECT_EQ(tally.largest(), 1000.0);
}

TEST(Tally, WhatIsMissingCountsAsOutsideEveryShare) {
  const Tally tally = of({50.0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(tally.count(), 1);
  EXPECT_EQ(tally.missing(), 1);
  EXPECT_DOUBLE_EQ(tally.share_between(0.0, 100.0), 0.5);
}

TEST(Tally, QuantilesAreTheBinsThatHoldThem) {
  Tally tally(0.0, 100.0, 1000);
  for (int i = 0; i < 1000; ++i) {
    tally.add(0.1 * i + 0.05);
  }
  EXPECT_NEAR(tally.quantile(0.5), 49.95, 0.051);
  EXPECT_NEAR(tally.quantile(0.99), 98.95, 0.051);
  EXPECT_NEAR(tally.quantile(0.0), 0.05, 0.051);
  EXPECT_NEAR(tally.quantile(1.0), 99.95, 0.051);
}

TEST(Tally, PartsAddUpToTheWholeInAnyOrder) {
  Tally whole(0.0, 100.0, 1000);
  std::vector<Tally> parts(7, whole);
  for (int i = 0; i < 10000; ++i) {
    const double value = 50.0 + 40.0 * std::sin(i * 1.7);
    whole.add(value);
    parts[static_cast<std::size_t>(i) % parts.size()].add(value);
  }
  Tally forwards(0.0, 100.0, 1000);
  Tally backwards(0.0, 100.0, 1000);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    forwards.merge(parts[i]);
    backwards.merge(parts[parts.size() - 1 - i]);
  }
  for (const Tally* sum : {&forwards, &backwards}) {
    EXPECT_EQ(sum->mean(), whole.mean());
    EXPECT_EQ(sum->standard_deviation(), whole.standard_deviation());
    EXPECT_EQ(sum->quantile(0.3), whole.quantile(0.3));
  }
}

TEST(Tally, OfNothingHasNoFigures) {
  const Tally tally = of({});
  EXPECT_TRUE(std::isnan(tally.mean()));
  EXPECT_TRUE(std::isnan(tally.standard_deviation()));
  EXPECT_TRUE(std::isnan(tally.quantile(0.5)));
  EXPECT_TRUE(std::isnan(tally.share_between(0.0, 100.0)));
}

TEST(Tally, OfDifferentBinsDoNotAddUp) {
  Tally tally = of({1.0});
  EXPECT_THROW(tally.merge(Tally(0.0, 100.0, 999)), std::invalid_argument);
  EXPECT_THROW(Tally(1.0, 1.0, 10), std::invalid_argument);
}

}  // namespace
