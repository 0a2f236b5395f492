// Measurements against the limits that the profile declared before the run.
#pragma once

#include <vector>

#include <judge/catalogue.hpp>

namespace gsbench::judge {

// The rule, by itself: low <= value <= high with an uncertainty.
//   PASS          inside by at least the uncertainty
//   FAIL          outside by more than it; or the outlet did not do what was to be measured
//   INCONCLUSIVE  nearer to a limit than it; or the bench cannot tell
// A NaN never passes. NaN for a limit: none.
struct Judgement {
  record::Verdict verdict = record::Verdict::kInconclusive;
  std::string reason;  // empty for PASS
};
Judgement judge_number(const Reading& reading, double low, double high);
Judgement judge_word(const Reading& reading, const std::string& expected);

// Every measure of the catalogue for one outlet: first those the profile sets limits to, judged, in
// its order, then the others, for information.
std::vector<record::MeasurementResult> measure(const Case& c);

// Fills in measurements and verdict.
void judge_outlet(const profile::Plan& plan, const waveform::Truth& truth,
                  const BenchUncertainty& uncertainty, record::OutletRecord& outlet);

}  // namespace gsbench::judge
