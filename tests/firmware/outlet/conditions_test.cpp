#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <outlet/conditions.hpp>

namespace gs::outlet {
namespace {

constexpr float kNominal_hz = 50.0F;

// Two rows: 49.9 … 50 Hz below −0.3 Hz/s, 49.8 … 49.9 Hz below −0.2 Hz/s.
Settings two_rows() {
  Settings settings;
  settings.conditions[0] = {49.9F, -0.3F};
  settings.conditions[1] = {49.8F, -0.2F};
  settings.condition_rows = 2;
  return settings;
}

bool met(float mean_hz, float slope_hz_s) {
  return condition_met(two_rows(), kNominal_hz, Line{mean_hz, slope_hz_s});
}

TEST(Conditions, EachRowHasItsOwnLimit) {
  EXPECT_TRUE(met(49.95F, -0.31F));
  EXPECT_FALSE(met(49.95F, -0.29F));
  EXPECT_TRUE(met(49.85F, -0.21F));
  EXPECT_FALSE(met(49.85F, -0.19F));
}

TEST(Conditions, ARowHoldsFromItsLowerEdgeUpToTheNextRow) {
  EXPECT_FALSE(met(49.9F, -0.25F)) << "the lower edge is in the row";
  EXPECT_TRUE(met(std::nextafter(49.9F, 0.0F), -0.25F)) << "just below it is the next";
}

TEST(Conditions, TheLimitItselfDoesNotMeetTheCondition) {
  EXPECT_FALSE(met(49.95F, -0.3F));
  EXPECT_TRUE(met(49.95F, std::nextafter(-0.3F, -1.0F)));
}

TEST(Conditions, NoConditionIsMetAtOrAboveNominal) {
  EXPECT_FALSE(met(50.0F, -10.0F));
  EXPECT_FALSE(met(50.5F, -10.0F));
  EXPECT_TRUE(met(std::nextafter(50.0F, 0.0F), -10.0F));
}

TEST(Conditions, BelowTheLowestRowAnyFallMeetsTheCondition) {
  EXPECT_TRUE(met(49.79F, -1e-6F));
  EXPECT_FALSE(met(49.79F, 0.0F));
  EXPECT_FALSE(met(49.79F, 0.1F));
}

TEST(Conditions, ANaNLineMeetsNoCondition) {
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(met(kUnknown, -1.0F));
  EXPECT_FALSE(met(49.95F, kUnknown));
  EXPECT_FALSE(met(49.5F, kUnknown));
}

}  // namespace
}  // namespace gs::outlet
