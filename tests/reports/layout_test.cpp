// Lines and tables on a terminal, and the digits of figures in them.
#include <limits>

#include <gmock/gmock.h>

#include <render/figures.hpp>
#include <render/layout.hpp>

namespace gsbench::render {
namespace {

using ::testing::ElementsAre;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

TEST(Wrapped, BreaksAtWordsAndIndentsTheLinesThatFollow) {
  EXPECT_EQ(wrapped("one two three four", 9), "one two\nthree\nfour");
  EXPECT_EQ(wrapped("one two three four", 9, 2), "one two\n  three\n  four");
  EXPECT_EQ(wrapped("one two", 7), "one two");
  EXPECT_EQ(wrapped("", 7), "");
}

TEST(Wrapped, CountsCodePoints) {
  EXPECT_EQ(wrapped("ΔΔΔ ΔΔΔ", 7), "ΔΔΔ ΔΔΔ");
  EXPECT_EQ(wrapped("ΔΔΔ ΔΔΔ", 6), "ΔΔΔ\nΔΔΔ");
}

TEST(Wrapped, KeepsLineEndsAndRunsOfSpaces) {
  EXPECT_EQ(wrapped("name    text\nnext", 20, 2), "name    text\n  next");
}

TEST(Wrapped, DoesNotBreakAWordThatIsLongerThanALine) {
  EXPECT_EQ(wrapped("in /a/long/path now", 8), "in\n/a/long/path\nnow");
}

TEST(Beginning, ReplacesTheEndByAnEllipsis) {
  EXPECT_EQ(beginning("kitchen-1", 9), "kitchen-1");
  EXPECT_EQ(beginning("kitchen-1", 8), "kitchen…");
  EXPECT_EQ(beginning("ΔΔΔΔΔΔ", 4), "ΔΔΔ…");
}

TEST(Shortened, ReplacesTheMiddleByAnEllipsis) {
  EXPECT_EQ(shortened("kitchen-1", 9), "kitchen-1");
  EXPECT_EQ(shortened("kitchen-1", 8), "kitc…n-1");
  EXPECT_EQ(shortened("kitchen-1", 1), "…");
  EXPECT_EQ(shortened("ΔΔΔΔΔΔ", 4), "ΔΔ…Δ");
  EXPECT_EQ(columns_of(shortened(std::string(64, 'x'), 40)), 40U);
}

TEST(Aligned, PutsEachColumnOnItsSide) {
  EXPECT_THAT(aligned({{"a", "bb", "c"}, {"dd", "e", "ff"}}),
              ElementsAre("a   bb   c", "dd   e  ff"));
  EXPECT_THAT(aligned({{"a", "bb", "c"}, {"dd", "e", "ff"}}, "rl"),
              ElementsAre(" a  bb  c", "dd  e   ff"));
}

TEST(Aligned, TakesRowsOfAnyLengthAndLeavesNoSpacesAtTheEnd) {
  EXPECT_THAT(aligned({{"a", "b"}, {"cc"}, {"dd", "", ""}}), ElementsAre("a   b", "cc", "dd"));
}

TEST(Figure, HasSignificantDigitsWithoutTrailingZeros) {
  EXPECT_EQ(figure(351.92), "351.92");
  EXPECT_EQ(figure(112.0), "112");
  EXPECT_EQ(figure(-1011.9204), "-1011.9");
  EXPECT_EQ(figure(1234567.0), "1234567");
  EXPECT_EQ(figure(0.0), "0");
  EXPECT_EQ(figure(-0.0), "0");
  EXPECT_EQ(figure(3e-12), "3e-12");
  EXPECT_EQ(figure(kNotANumber), "–");
  EXPECT_EQ(figure(std::numeric_limits<double>::infinity()), "∞");
}

TEST(Fixed, HasTheDecimalsAskedFor) {
  EXPECT_EQ(fixed(503.75, 1), "503.8");
  EXPECT_EQ(fixed(498.0, 1), "498.0");
  EXPECT_EQ(fixed(-0.001, 2), "0.00");
  EXPECT_EQ(fixed(-0.016, 2), "-0.02");
  EXPECT_EQ(fixed(kNotANumber, 2), "–");
}

TEST(Decimals, AreThoseThatTheUncertaintySupports) {
  EXPECT_EQ(decimals_for({928.125, 927.0}, 0.0625), 1);
  EXPECT_EQ(decimals_for({928.125, 927.0}, 0.13), 1);
  EXPECT_EQ(decimals_for({928.125}, 3.0), 0);
  EXPECT_EQ(decimals_for({928.125}, 42.0), 0);
  EXPECT_EQ(decimals_for({79.304125}, 6.25e-5), 4);
}

TEST(Decimals, WithoutAnUncertaintyFollowFromTheLargestMagnitude) {
  EXPECT_EQ(decimals_for({503.75, 499.92, 5.0}), 1);
  EXPECT_EQ(decimals_for({0.75, -0.016, 1.054}), 2);
  EXPECT_EQ(decimals_for({-0.014, 0.0998}), 3);
  EXPECT_EQ(decimals_for({1309.2}), 0);
}

TEST(Decimals, AreNoneForWholeNumbersAndForNoValue) {
  EXPECT_EQ(decimals_for({920.0, 0.0, kNotANumber}), 0);
  EXPECT_EQ(decimals_for({}), 0);
}

TEST(Decimals, ShowTwoSignificantDigitsOfAStandardDeviation) {
  EXPECT_EQ(decimals_of_two_digits(13.34), 0);
  EXPECT_EQ(decimals_of_two_digits(2.246), 1);
  EXPECT_EQ(decimals_of_two_digits(0.03102), 3);
  EXPECT_EQ(decimals_of_two_digits(0.0), 0);
}

TEST(Decimals, OfAPublishedFigureAreThoseItIsPrintedWith) {
  EXPECT_EQ(decimals_of_written(3.72), 2);
  EXPECT_EQ(decimals_of_written(351.9), 1);
  EXPECT_EQ(decimals_of_written(310.0), 0);
}

}  // namespace
}  // namespace gsbench::render
