#include <algorithm>

#include <judge/judge.hpp>

namespace gsbench::judge {

using record::OutletRecord;
using record::RunRecord;
using record::Verdict;

namespace {

constexpr const char* kInterrupted = "interrupted before its end";

std::string reason_of(const RunRecord& run) {
  const auto did_not_pass =
      std::count_if(run.outlets.begin(), run.outlets.end(),
                    [](const OutletRecord& o) { return o.verdict != Verdict::kPass; });
  if (did_not_pass == 0) {
    return {};
  }
  const auto faulty = std::find_if(run.outlets.begin(), run.outlets.end(),
                                   [](const OutletRecord& o) { return !o.fault.empty(); });
  return std::to_string(did_not_pass) + " of " + std::to_string(run.outlets.size()) +
         " outlets did not pass" +
         (faulty == run.outlets.end() ? "" : ": outlet " + faulty->id + " " + faulty->fault);
}

}  // namespace

Judge::Judge(const profile::Plan& plan, const RunRecord& head)
    : plan_(plan), reference_(plan.reference()), head_(head) {}

Case Judge::begin(const OutletRecord& outlet) const {
  return {plan_, *reference_, outlet, head_.bench_uncertainty};
}

void Judge::finish(const Case& c, OutletRecord& outlet) const {
  if (is_judged(head_)) {
    judge_outlet(c, outlet);
  } else {
    outlet.measurements.clear();
    outlet.verdict = Verdict::kError;
  }
}

void Judge::judge(OutletRecord& outlet) const {
  Case c = begin(outlet);
  c.add(outlet.reports);
  finish(c, outlet);
}

void conclude(RunRecord& run) {
  run.verdict = is_judged(run) && !run.outlets.empty() ? Verdict::kPass : Verdict::kError;
  for (const OutletRecord& outlet : run.outlets) {
    run.verdict = std::max(run.verdict, outlet.verdict);
  }
  run.verdict_reason = !run.fault.empty()    ? run.fault
                       : run.interrupted     ? kInterrupted
                       : run.outlets.empty() ? "the run has no outlets"
                                             : reason_of(run);
}

void judge(const profile::Plan& plan, RunRecord& run) {
  const Judge judge(plan, run);
  for (OutletRecord& outlet : run.outlets) {
    judge.judge(outlet);
  }
  conclude(run);
}

}  // namespace gsbench::judge
