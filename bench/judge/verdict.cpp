#include <algorithm>
#include <cmath>

#include <judge/judge.hpp>

namespace gsbench::judge {

using record::Verdict;

namespace {

Judgement missing(const Reading& reading) {
  return {reading.outlets_fault ? Verdict::kFail : Verdict::kInconclusive, reading.missing};
}

}  // namespace

Judgement judge_number(const Reading& reading, double low, double high) {
  if (!reading.missing.empty()) {
    return missing(reading);
  }
  if (!std::isfinite(reading.value) || !(reading.uncertainty >= 0.0)) {
    return {Verdict::kInconclusive, "the measurement gave no number"};
  }
  // How far inside the nearer limit; negative when outside.
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const double margin = std::min(std::isnan(low) ? kNoLimit : reading.value - low,
                                 std::isnan(high) ? kNoLimit : high - reading.value);
  if (margin >= reading.uncertainty) {
    return {Verdict::kPass, ""};
  }
  if (margin < -reading.uncertainty) {
    return {Verdict::kFail, "outside its limits"};
  }
  return {Verdict::kInconclusive, "nearer to its limit than the bench's uncertainty"};
}

Judgement judge_word(const Reading& reading, const std::string& expected) {
  if (!reading.missing.empty()) {
    return missing(reading);
  }
  if (reading.word == expected) {
    return {Verdict::kPass, ""};
  }
  return {Verdict::kFail, "expected " + expected};
}

}  // namespace gsbench::judge
