#include "faults.hpp"
#include "run_steps.hpp"

#include <judge/judge.hpp>
#include <station/safe_state.hpp>

namespace gsbench::station {

// The steps before judge() record facts and faults only; the verdicts come from bench/judge.
record::RunRecord run(const profile::Plan& plan, Station& station, const RunOptions& options) {
  record::RunRecord run = prepare(plan, station);
  const std::vector<Slot> slots = assign(plan.outlets, station.slots());
  const PlayedSignal signal(plan, !station.outlets_count_ticks());
  capture::Capture capture(plan.stimulus.sample_rate_hz);
  {
    const SafeState safe_state(station.source(), station.link(), run.fault);
    if (options.writer != nullptr) {
      options.writer->begin(run);
    }
    try {
      require(station.source().prepare(signal));
      require(station.source().energise());
      run.outlets = claim(plan, slots, station);
      run.interrupted = !play(plan, slots, signal, station, options, run.outlets, capture);
    } catch (const BenchFault& fault) {
      run.fault = fault.what();
    }
  }
  align(station, signal.markers(), capture, run);
  judge::judge(plan, run);
  run.finished_utc = utc_now();
  if (options.writer != nullptr) {
    for (const record::OutletRecord& outlet : run.outlets) {
      options.writer->add_outlet(outlet);
    }
    options.writer->finish(run);
  }
  return run;
}

}  // namespace gsbench::station
