// Judges a recorded run: compares the measurements with the limits of the profile and derives the
// verdict of each outlet and of the run.
#pragma once

#include <memory>
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

// All measures of the catalogue for one outlet, whose traces have been added to its case. Those
// with limits in the profile come first, judged and in the profile's order. The others follow for
// information; without a link, only those that need none.
std::vector<record::MeasurementResult> measure(const Case& c);

// Fills in the measurements and the verdict of the outlet of the case. An outlet with a fault
// during the run is ERROR and is still measured from its recorded data. An outlet that did not take
// part is ERROR without measurements.
void judge_outlet(const Case& c, record::OutletRecord& outlet);

// Judges the outlets of a run one after the other, in three steps:
//   Case c = judge.begin(outlet);  // with its marks
//   c.add(piece);                  // for each piece of its reports, in order
//   judge.finish(c, outlet);
// `plan` must be the plan of the run. The arguments outlive the judge.
class Judge {
 public:
  Judge(const profile::Plan& plan, const record::RunRecord& head);

  Case begin(const record::OutletRecord& outlet) const;
  // As judge_outlet(); ERROR without measurements if the bench failed or the run was interrupted.
  void finish(const Case& c, record::OutletRecord& outlet) const;

  // All steps for an outlet that has all of its reports.
  void judge(record::OutletRecord& outlet) const;

 private:
  const profile::Plan& plan_;
  std::shared_ptr<const waveform::ReferenceSignal> reference_;
  const record::RunRecord& head_;
};

// Overwrites run.verdict and run.verdict_reason by the verdicts of its outlets. The verdict of a
// run is the worst of its outlets. It is ERROR if the bench failed or the run was interrupted.
void conclude(record::RunRecord& run);

// Both, for all outlets of a run.
void judge(const profile::Plan& plan, record::RunRecord& run);

}  // namespace gsbench::judge
