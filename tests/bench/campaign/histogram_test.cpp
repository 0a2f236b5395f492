#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <campaign/histogram.hpp>

namespace gsbench::campaign {
namespace {

Histogram of(const std::vector<double>& values) {
  Histogram histogram(0.0, 100.0, 1000);
  for (const double value : values) {
    histogram.add(value);
  }
  return histogram;
}

TEST(Histogram, HasTheMeanAndStandardDeviationOfTheValues) {
  const Histogram histogram = of({10.0, 20.0, 60.0, 90.0});
  EXPECT_EQ(histogram.count(), 4);
  EXPECT_NEAR(histogram.mean(), 45.0, 1e-4);
  EXPECT_NEAR(histogram.standard_deviation(), 36.9685, 1e-2);
  EXPECT_EQ(histogram.smallest(), 10.0);
  EXPECT_EQ(histogram.largest(), 90.0);
}

TEST(Histogram, ComputesASmallStandardDeviationFarFromTheCentre) {
  Histogram histogram(0.0, 1000.0, 20000);
  for (int i = 0; i < 1000; ++i) {
    histogram.add(i % 2 == 0 ? 899.0 : 901.0);
  }
  EXPECT_NEAR(histogram.standard_deviation(), 1.0005, 1e-3);
}

TEST(Histogram, CountsTheValuesOfARangeOfBins) {
  const Histogram histogram = of({-5.0, 10.0, 19.99, 20.0, 99.99, 100.0, 1000.0});
  EXPECT_EQ(histogram.count(), 7);
  EXPECT_EQ(histogram.count_between(10.0, 20.0), 2);
  EXPECT_EQ(histogram.count_between(0.0, 100.0), 4);
  EXPECT_DOUBLE_EQ(histogram.share_between(0.0, 100.0), 4.0 / 7.0);
  EXPECT_EQ(histogram.smallest(), -5.0);
  EXPECT_EQ(histogram.largest(), 1000.0);
}

TEST(Histogram, NaNCountsAsOutsideEveryShare) {
  const Histogram histogram = of({50.0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(histogram.count(), 1);
  EXPECT_EQ(histogram.missing(), 1);
  EXPECT_DOUBLE_EQ(histogram.share_between(0.0, 100.0), 0.5);
}

TEST(Histogram, AQuantileIsTheMiddleOfItsBin) {
  Histogram histogram(0.0, 100.0, 1000);
  for (int i = 0; i < 1000; ++i) {
    histogram.add(0.1 * i + 0.05);
  }
  EXPECT_NEAR(histogram.quantile(0.5), 49.95, 0.051);
  EXPECT_NEAR(histogram.quantile(0.99), 98.95, 0.051);
  EXPECT_NEAR(histogram.quantile(0.0), 0.05, 0.051);
  EXPECT_NEAR(histogram.quantile(1.0), 99.95, 0.051);
}

TEST(Histogram, PartsMergeToTheSameResultInAnyOrder) {
  Histogram whole(0.0, 100.0, 1000);
  std::vector<Histogram> parts(7, whole);
  for (int i = 0; i < 10000; ++i) {
    const double value = 50.0 + 40.0 * std::sin(i * 1.7);
    whole.add(value);
    parts[static_cast<std::size_t>(i) % parts.size()].add(value);
  }
  Histogram forwards(0.0, 100.0, 1000);
  Histogram backwards(0.0, 100.0, 1000);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    forwards.merge(parts[i]);
    backwards.merge(parts[parts.size() - 1 - i]);
  }
  for (const Histogram* sum : {&forwards, &backwards}) {
    EXPECT_EQ(sum->mean(), whole.mean());
    EXPECT_EQ(sum->standard_deviation(), whole.standard_deviation());
    EXPECT_EQ(sum->quantile(0.3), whole.quantile(0.3));
  }
}

TEST(Histogram, WithoutValuesAllFiguresAreNaN) {
  const Histogram histogram = of({});
  EXPECT_TRUE(std::isnan(histogram.mean()));
  EXPECT_TRUE(std::isnan(histogram.standard_deviation()));
  EXPECT_TRUE(std::isnan(histogram.quantile(0.5)));
  EXPECT_TRUE(std::isnan(histogram.share_between(0.0, 100.0)));
}

TEST(Histogram, RejectsMergingDifferentBinsAndAnEmptyRange) {
  Histogram histogram = of({1.0});
  EXPECT_THROW(histogram.merge(Histogram(0.0, 100.0, 999)), std::invalid_argument);
  EXPECT_THROW(Histogram(1.0, 1.0, 10), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::campaign
