#include "faults.hpp"
#include "run_steps.hpp"

#include <utility>

#include <judge/judge.hpp>

namespace gsbench::station {
namespace {

void align_stored(const Station& station, const PlayedSignal& signal, const record::RunRecord& run,
                  record::OutletRecord& outlet) {
  if (!has_own_clock(station, outlet)) {
    return;
  }
  if (!align(signal.markers(), outlet.trace, run.sample_rate_hz, outlet)) {
    if (!run.interrupted) {
      note(outlet,
           "did not report the marker dips played before the run: its time stamps cannot be "
           "aligned");
    }
  } else if (outlet.clock.is_aligned()) {
    // The dips are as early or late as all that the source plays.
    outlet.clock.uncertainty_ms += run.bench_uncertainty.time_ms;
  }
}

}  // namespace

void judge_stored(const profile::Plan& plan, const Station& station, const PlayedSignal& signal,
                  record::Store& store, bool keeps_reports, record::RunRecord& run) {
  const judge::Judge judge(plan, run);
  record::ContentDigest digest;
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    record::OutletRecord& outlet = run.outlets[i];
    record::OutletRecord stored = store.outlet(i);
    static_cast<record::Reports&>(outlet) = std::move(static_cast<record::Reports&>(stored));
    align_stored(station, signal, run, outlet);
    record::place_on_run_time(outlet, run.duration_ticks);
    judge.judge(outlet);
    if (!keeps_reports) {
      digest.add(outlet);
      static_cast<record::Reports&>(outlet) = {};
    }
    store.update_outlet(i, outlet);
  }
  judge::conclude(run);
  note_clocks(station, run);
  run.content_sha256 = keeps_reports ? "" : digest.of(run);
}

}  // namespace gsbench::station
