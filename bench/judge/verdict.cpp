#include <algorithm>
#include <cmath>

#include <judge/judge.hpp>

namespace gsbench::judge {

using record::Verdict;

namespace {

Judgement missing(const Reading& reading) {
  return {reading.missing_fails ? Verdict::kFail : Verdict::kInconclusive, reading.missing};
}

}  // namespace

Judgement judge_number(const Reading& reading, double low, double high) {
  if (!reading.missing.empty()) {
    return missing(reading);
  }
  if (!std::isfinite(reading.value) || !(reading.uncertainty >= 0.0)) {
    return {Verdict::kInconclusive, "the value or its uncertainty is not a finite number"};
  }
  // Distance to the nearer limit; negative outside.
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const double margin = std::min(std::isnan(low) ? kNoLimit : reading.value - low,
                                 std::isnan(high) ? kNoLimit : high - reading.value);
  if (margin >= reading.uncertainty) {
    return {Verdict::kPass, ""};
  }
  if (margin < -reading.uncertainty) {
    return {Verdict::kFail, "outside its limits"};
  }
  return {Verdict::kInconclusive, "closer to a limit than the measurement uncertainty"};
}

Judgement judge_text(const Reading& reading, const std::string& expected) {
  if (!reading.missing.empty()) {
    return missing(reading);
  }
  if (reading.text == expected) {
    return {Verdict::kPass, ""};
  }
  return {Verdict::kFail, "expected " + expected};
}

}  // namespace gsbench::judge
