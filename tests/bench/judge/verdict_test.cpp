#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include <judge/judge.hpp>

namespace gsbench::judge {
namespace {

using record::Verdict;
using ::testing::HasSubstr;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Verdict verdict(double value, double uncertainty, double low, double high) {
  return judge_number(number(value, uncertainty), low, high).verdict;
}

// All values are multiples of 0.25, which doubles represent exactly.
TEST(NumberVerdict, PassesInsideByAtLeastTheUncertainty) {
  EXPECT_EQ(verdict(15.0, 0.25, 10.0, 20.0), Verdict::kPass);
  EXPECT_EQ(verdict(19.75, 0.25, 10.0, 20.0), Verdict::kPass);
  EXPECT_EQ(verdict(std::nextafter(19.75, 20.0), 0.25, 10.0, 20.0), Verdict::kInconclusive);
  EXPECT_EQ(verdict(10.25, 0.25, 10.0, 20.0), Verdict::kPass);
  EXPECT_EQ(verdict(std::nextafter(10.25, 10.0), 0.25, 10.0, 20.0), Verdict::kInconclusive);
}

TEST(NumberVerdict, FailsOutsideByMoreThanTheUncertainty) {
  EXPECT_EQ(verdict(20.25, 0.25, 10.0, 20.0), Verdict::kInconclusive);
  EXPECT_EQ(verdict(std::nextafter(20.25, 21.0), 0.25, 10.0, 20.0), Verdict::kFail);
  EXPECT_EQ(verdict(9.75, 0.25, 10.0, 20.0), Verdict::kInconclusive);
  EXPECT_EQ(verdict(std::nextafter(9.75, 9.0), 0.25, 10.0, 20.0), Verdict::kFail);
}

TEST(NumberVerdict, LimitsAreInclusiveWithoutUncertainty) {
  EXPECT_EQ(verdict(0.0, 0.0, kNone, 0.0), Verdict::kPass);
  EXPECT_EQ(verdict(1.0, 0.0, 1.0, 1.0), Verdict::kPass);
  EXPECT_EQ(verdict(1.0, 0.0, kNone, 0.0), Verdict::kFail);
  EXPECT_EQ(verdict(std::nextafter(1.0, 2.0), 0.0, 1.0, 1.0), Verdict::kFail);
}

TEST(NumberVerdict, NeverPassesIfTheLimitsAreCloserThanTwiceTheUncertainty) {
  for (double value = 9.0; value <= 11.0; value += 0.0625) {
    EXPECT_NE(verdict(value, 0.5, 9.75, 10.25), Verdict::kPass) << value;
  }
}

TEST(NumberVerdict, AcceptsASingleLimit) {
  EXPECT_EQ(verdict(-1e300, 0.0, kNone, 5.0), Verdict::kPass);
  EXPECT_EQ(verdict(6.0, 0.0, kNone, 5.0), Verdict::kFail);
  EXPECT_EQ(verdict(1e300, 0.0, 5.0, kNone), Verdict::kPass);
  EXPECT_EQ(verdict(4.0, 0.0, 5.0, kNone), Verdict::kFail);
}

TEST(NumberVerdict, NeverPassesAValueThatIsNotFinite) {
  for (const double value : {kNone, kInfinity, -kInfinity}) {
    for (const double limit : {kNone, -1e300, 1e300, kInfinity}) {
      EXPECT_EQ(verdict(value, 0.0, kNone, limit), Verdict::kInconclusive);
      EXPECT_EQ(verdict(value, 0.0, limit, kNone), Verdict::kInconclusive);
    }
  }
}

TEST(NumberVerdict, NeverPassesWithAnInvalidUncertainty) {
  EXPECT_EQ(verdict(5.0, kNone, 0.0, 10.0), Verdict::kInconclusive);
  EXPECT_EQ(verdict(5.0, -1.0, 0.0, 10.0), Verdict::kInconclusive);
  EXPECT_EQ(verdict(5.0, kInfinity, 0.0, 10.0), Verdict::kInconclusive);
}

TEST(NumberVerdict, HasAReasonUnlessItIsPass) {
  EXPECT_EQ(judge_number(number(5.0), 0.0, 10.0).reason, "");
  EXPECT_THAT(judge_number(number(11.0), 0.0, 10.0).reason, HasSubstr("outside"));
  EXPECT_THAT(judge_number(number(10.0, 1.0), 0.0, 10.0).reason, HasSubstr("uncertainty"));
  EXPECT_THAT(judge_number(number(kNone), 0.0, 10.0).reason, HasSubstr("not a finite number"));
}

TEST(MissingVerdict, IsFailForTheOutletAndInconclusiveForTheBench) {
  for (const bool is_text : {false, true}) {
    const auto judged = [&](const Reading& reading) {
      return is_text ? judge_text(reading, "open") : judge_number(reading, 0.0, 1.0);
    };
    EXPECT_EQ(judged(not_done("no report")).verdict, Verdict::kFail);
    EXPECT_EQ(judged(not_done("no report")).reason, "no report");
    EXPECT_EQ(judged(not_known("no sensor")).verdict, Verdict::kInconclusive);
    EXPECT_EQ(judged(not_known("no sensor")).reason, "no sensor");
  }
}

TEST(MissingVerdict, OverridesAValue) {
  Reading reading = number(0.5);
  reading.missing = "stale value";
  EXPECT_EQ(judge_number(reading, 0.0, 1.0).verdict, Verdict::kFail);
}

TEST(TextVerdict, PassesOnlyTheExpectedText) {
  EXPECT_EQ(judge_text(text("open"), "open").verdict, Verdict::kPass);
  EXPECT_EQ(judge_text(text("closed"), "open").verdict, Verdict::kFail);
  EXPECT_EQ(judge_text(text("closed"), "open").reason, "expected open");
  EXPECT_EQ(judge_text(text("open"), "").verdict, Verdict::kFail);
  EXPECT_EQ(judge_text(text(""), "open").verdict, Verdict::kFail);
}

}  // namespace
}  // namespace gsbench::judge
