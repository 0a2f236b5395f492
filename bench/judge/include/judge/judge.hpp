// Judges a run by its record: measurements against the limits that the profile declared before the
// run, then the verdict of each outlet and of the run.
#pragma once

#include <vector>

#include <judge/reading.hpp>

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

// Fills in the measurements and verdict of an outlet; a faulty one is measured and its verdict is
// ERROR, one that did not take part is not measured.
void judge_outlet(const profile::Plan& plan, const waveform::ReferenceSignal& reference,
                  const record::BenchUncertainty& uncertainty, record::OutletRecord& outlet);

// Fills in what judge_outlet does of each outlet, run.verdict and run.verdict_reason; what they
// were before does not count. A run is as good as its worst outlet, and ERROR where the bench
// failed or the run was interrupted: then nothing is measured. `plan` is that of run.profile_text.
void judge(const profile::Plan& plan, record::RunRecord& run);

}  // namespace gsbench::judge
