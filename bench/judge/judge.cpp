#include <algorithm>

#include <judge/judge.hpp>

namespace gsbench::judge {

using record::OutletRecord;
using record::RunRecord;
using record::Verdict;

namespace {

constexpr const char* kInterrupted = "interrupted before its end";

// Sets the run and all outlets to ERROR, without measurements.
void set_error(RunRecord& run, const std::string& reason) {
  run.verdict = Verdict::kError;
  run.verdict_reason = reason;
  for (OutletRecord& outlet : run.outlets) {
    outlet.measurements.clear();
    outlet.verdict = Verdict::kError;
  }
}

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

void judge(const profile::Plan& plan, RunRecord& run) {
  if (!run.fault.empty() || run.interrupted || run.outlets.empty()) {
    set_error(run, !run.fault.empty() ? run.fault
                   : run.interrupted  ? kInterrupted
                                      : "the run has no outlets");
    return;
  }
  const auto reference = plan.reference();
  run.verdict = Verdict::kPass;
  for (OutletRecord& outlet : run.outlets) {
    judge_outlet(plan, *reference, run.bench_uncertainty, outlet);
    run.verdict = std::max(run.verdict, outlet.verdict);
  }
  run.verdict_reason = reason_of(run);
}

}  // namespace gsbench::judge
