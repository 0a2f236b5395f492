#include "align.hpp"
#include "claim.hpp"
#include "faults.hpp"
#include "finish.hpp"
#include "play.hpp"
#include "prepare.hpp"

#include <capture/capture.hpp>
#include <judge/judge.hpp>
#include <station/played_signal.hpp>
#include <station/run.hpp>
#include <station/safe_state.hpp>
#include <station/slot.hpp>

namespace gsbench::station {

// The record gets facts only, faults among them; what they come to is for the judge.
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
      power_up(signal, station.source());
      run.outlets = claim(plan, slots, station);
      run.interrupted = !play(plan, slots, signal, station, options, run.outlets, capture);
    } catch (const BenchFault& fault) {
      run.fault = fault.what();
    }
  }
  align(station, signal.markers(), capture, run);
  judge::judge(plan, run);
  finish(run, options.writer);
  return run;
}

}  // namespace gsbench::station
