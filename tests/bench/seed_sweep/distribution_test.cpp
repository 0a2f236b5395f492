#include <seed_sweep/distribution.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace gsbench::seed_sweep {
namespace {

Distribution of(std::initializer_list<double> values) {
  Distribution distribution;
  for (const double value : values) {
    distribution.add(value);
  }
  distribution.sort();
  return distribution;
}

TEST(Distribution, QuantilesUseTheNearestRank) {
  const Distribution four = of({4.0, 1.0, 3.0, 2.0});
  EXPECT_EQ(four.quantile(0.0), 1.0);
  EXPECT_EQ(four.quantile(0.25), 1.0);
  EXPECT_EQ(four.quantile(0.26), 2.0);
  EXPECT_EQ(four.quantile(0.5), 2.0);
  EXPECT_EQ(four.quantile(0.75), 3.0);
  EXPECT_EQ(four.quantile(0.76), 4.0);
  EXPECT_EQ(four.quantile(1.0), 4.0);
}

TEST(Distribution, PercentilesOfAHundredValuesAreExact) {
  Distribution hundred;
  for (int i = 100; i >= 1; --i) {
    hundred.add(i);
  }
  hundred.sort();
  for (const int percent : {1, 5, 50, 95, 99, 100}) {
    EXPECT_EQ(hundred.quantile(percent / 100.0), percent);
  }
}

TEST(Distribution, AllQuantilesOfASingleValueAreThatValue) {
  const Distribution one = of({7.0});
  for (const double p : {0.0, 0.01, 0.5, 1.0}) {
    EXPECT_EQ(one.quantile(p), 7.0);
  }
  EXPECT_EQ(one.mean(), 7.0);
  EXPECT_TRUE(std::isnan(one.standard_deviation()));
}

TEST(Distribution, WithoutValuesHasNaNForAllFigures) {
  const Distribution none;
  EXPECT_TRUE(std::isnan(none.quantile(0.5)));
  EXPECT_TRUE(std::isnan(none.mean()));
  EXPECT_TRUE(std::isnan(none.standard_deviation()));
  EXPECT_TRUE(std::isnan(none.share_within(1.0)));
}

TEST(Distribution, HasMeanAndStandardDeviationOfTheSample) {
  const Distribution five = of({2.0, 4.0, 4.0, 5.0, 10.0});
  EXPECT_DOUBLE_EQ(five.mean(), 5.0);
  // (9 + 1 + 1 + 0 + 25) / (n − 1 = 4).
  EXPECT_DOUBLE_EQ(five.standard_deviation(), 3.0);
}

TEST(Distribution, CountsNaNAsMissing) {
  const Distribution d = of({1.0, std::numeric_limits<double>::quiet_NaN(), 3.0});
  EXPECT_EQ(d.count(), 2U);
  EXPECT_EQ(d.missing(), 1U);
  EXPECT_EQ(d.mean(), 2.0);
}

TEST(Distribution, ShareWithinIsInclusiveAndCountsMissingAsOutside) {
  const Distribution d = of({-4.0, 4.0, 4.5, -5.0, 0.0});
  EXPECT_DOUBLE_EQ(d.share_within(4.0), 0.6);
  EXPECT_DOUBLE_EQ(d.share_within(5.0), 1.0);
  EXPECT_DOUBLE_EQ(d.share_within(0.0), 0.2);
  const Distribution with_missing = of({0.0, 0.0, 0.0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_DOUBLE_EQ(with_missing.share_within(1.0), 0.75);
  const Distribution only_missing = of({std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(only_missing.share_within(1.0), 0.0);
}

TEST(Distribution, MergeContainsTheValuesOfBothDistributions) {
  Distribution a = of({3.0, 1.0});
  a.add_text("open");
  Distribution b = of({2.0, std::numeric_limits<double>::quiet_NaN()});
  b.add_text("open");
  b.add_text("closed");
  a.merge(b);
  a.sort();
  EXPECT_EQ(a.count(), 3U);
  EXPECT_EQ(a.missing(), 1U);
  EXPECT_EQ(a.quantile(0.5), 2.0);
  EXPECT_EQ(a.texts(), (std::map<std::string, std::size_t>{{"closed", 1}, {"open", 2}}));
}

}  // namespace
}  // namespace gsbench::seed_sweep
