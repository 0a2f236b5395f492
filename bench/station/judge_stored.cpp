#include "faults.hpp"
#include "run_steps.hpp"

#include <utility>

#include <judge/judge.hpp>

namespace gsbench::station {
namespace {

void align_stored(const Station& station, const PlayedSignal& signal, record::Store& store,
                  std::size_t i, record::RunRecord& run) {
  record::OutletRecord& outlet = run.outlets[i];
  if (has_own_clock(station, outlet) && !align(signal.markers(), store, i, run) &&
      !run.interrupted) {
    note(outlet,
         "did not report the marker dips played before the run: its time stamps cannot be "
         "aligned");
  }
}

}  // namespace

void judge_stored(const profile::Plan& plan, const Station& station, const PlayedSignal& signal,
                  record::Store& store, bool keeps_reports, record::RunRecord& run) {
  const judge::Judge judge(plan, run);
  record::ContentDigest digest;
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    align_stored(station, signal, store, i, run);
    record::OutletRecord& outlet = run.outlets[i];
    outlet.reports = store.outlet(i).reports;
    record::place_on_run_time(outlet.reports, outlet.clock, run.duration_ticks);
    judge::Case c = judge.begin(outlet);
    record::Reports traces;
    store.read_reports(i, [&](record::Reports piece) {
      piece.marks.clear();
      piece.sent.clear();
      record::place_on_run_time(piece, outlet.clock, run.duration_ticks);
      c.add(piece);
      if (keeps_reports) {
        traces.append(piece);
      } else {
        digest.add_traces(piece);
      }
    });
    judge.finish(c, outlet);
    if (keeps_reports) {
      outlet.reports.append(traces);
    } else {
      digest.add_outlet(outlet);
      outlet.reports = {};
    }
    store.update_outlet(i, outlet);
  }
  judge::conclude(run);
  note_clocks(station, run);
  run.content_sha256 = keeps_reports ? "" : digest.of(run);
}

}  // namespace gsbench::station
