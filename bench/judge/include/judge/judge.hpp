// Judges a recorded run: compares the measurements with the limits of the profile and derives the
// verdict of each outlet and of the run.
#pragma once

#include <vector>

#include <judge/reading.hpp>

namespace gsbench::judge {

// The decision rule for low <= value <= high with an uncertainty:
//   PASS          inside the limits by at least the uncertainty
//   FAIL          outside by more than the uncertainty, or the outlet did not do what is measured
//   INCONCLUSIVE  closer to a limit than the uncertainty, or the bench could not measure it
// A value of NaN never passes. A limit of NaN is no limit.
struct Judgement {
  record::Verdict verdict = record::Verdict::kInconclusive;
  std::string reason;  // empty for PASS
};
Judgement judge_number(const Reading& reading, double low, double high);
Judgement judge_text(const Reading& reading, const std::string& expected);

// All measures of the catalogue for one outlet. Those with limits in the profile come first, judged
// and in the profile's order. The others follow for information; without a link, only those that
// need none.
std::vector<record::MeasurementResult> measure(const Case& c);

// Fills in the measurements and the verdict of an outlet. An outlet with a fault during the run is
// ERROR and is still measured from its recorded data. An outlet that did not take part is ERROR
// without measurements.
void judge_outlet(const profile::Plan& plan, const waveform::ReferenceSignal& reference,
                  const record::BenchUncertainty& uncertainty, record::OutletRecord& outlet);

// Calls judge_outlet for each outlet and overwrites run.verdict and run.verdict_reason. The verdict
// of a run is the worst of its outlets. It is ERROR, without measurements, if the bench failed or
// the run was interrupted. `plan` must be the plan of run.profile_text.
void judge(const profile::Plan& plan, record::RunRecord& run);

}  // namespace gsbench::judge
