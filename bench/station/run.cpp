#include "boot.hpp"
#include "faults.hpp"
#include "run_steps.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <judge/judge.hpp>
#include <station/safe_state.hpp>
#include <station/source_check.hpp>
#include <station/station_lock.hpp>

namespace gsbench::station {

namespace {

source::Played upload(const profile::Plan& plan, const PlayedSignal& signal, Station& station,
                      const RunOptions& options) {
  source::Source& source = station.source();
  source::Played played = require(source, source.prepare(signal, [&](double part) {
    if (options.waiting) {
      options.waiting(fmt::format("uploading the waveform: {:.0f} %", 100.0 * part));
    }
  }));
  // A source may know its deviations better once it is connected.
  const std::string excess = beyond(plan.stimulus.tolerances, deviations_of(played));
  if (!excess.empty()) {
    throw BenchFault(source.limits().name +
                     ": the played signal would deviate too much from the profile: " + excess);
  }
  return played;
}

// An outlet that cannot be reached does not end the run of the others. If all cannot, nothing is
// energised.
void require_a_reachable_outlet(const std::vector<Slot>& slots, link::Link& link) {
  const std::vector<link::Fault> unreachable = link.unreachable();
  const link::Fault* first = nullptr;
  for (const Slot& slot : slots) {
    const auto found = std::find_if(
        unreachable.begin(), unreachable.end(),
        [&](const link::Fault& fault) { return slot.link_id && fault.id == *slot.link_id; });
    if (found == unreachable.end()) {
      return;
    }
    first = first != nullptr ? first : &*found;
  }
  if (first != nullptr) {
    throw BenchFault("outlet on " + first->id + " " + first->what + "; no outlet is left");
  }
}

// While it exists, RunOptions::stop also ends the calls of the source.
class StoppableSource {
 public:
  StoppableSource(source::Source& source, const std::atomic<bool>* stop) : source_(source) {
    source_.end_calls_if(stop);
  }
  ~StoppableSource() { source_.end_calls_if(nullptr); }
  StoppableSource(const StoppableSource&) = delete;
  StoppableSource& operator=(const StoppableSource&) = delete;

 private:
  source::Source& source_;
};

// What is stored so far stays readable; nothing more can be added.
record::RunRecord ended_by_store(const std::string& fault, const profile::Plan& plan,
                                 record::Store& store, record::RunRecord run) {
  run.fault = run.fault.empty() ? fault : fault + "; " + run.fault;
  run.finished_utc = utc_now();
  judge::judge(plan, run);
  store.abandon(run);
  return run;
}

}  // namespace

// The steps before judge_stored() record facts and faults only; the verdicts come from bench/judge.
record::RunRecord run(const profile::Plan& plan, Station& station, const RunOptions& options) {
  const StationLock lock(station.ports(), "profile " + plan.name);
  record::RunRecord run = prepare(plan, station);
  run.station_text = options.station_text;
  const std::vector<Slot> slots = assign(plan.outlets, station.slots());
  check_offered(plan, slots);
  const PlayedSignal signal = signal_of(plan, slots, station);
  if (!station.source_accuracy().empty()) {
    check_source(plan, signal, station.source());
  }
  record::MemoryStore memory;
  record::Store& store =
      options.writer != nullptr ? *options.writer : static_cast<record::Store&>(memory);
  capture::Capture capture;
  std::string store_fault;
  Recorder recorder(store, station, signal, capture, run);
  {
    const StoppableSource stoppable(station.source(), options.stop);
    const SafeState safe_state(station.source(), station.link(), run.fault, options.output_unknown);
    store.begin(run);
    try {
      note_source(upload(plan, signal, station, options), station, run);
      require(station.link().open());
      require_a_reachable_outlet(slots, station.link());
      require(station.relay_sense().open());
      require(station.source(), station.source().energise());
      Boot boot(station, slots, options);
      run.outlets = claim(plan, slots, station, boot);
      recorder.add_outlets();
      boot.finish();
      run.interrupted =
          !play(plan, slots, signal, station, options, run.outlets, capture, recorder);
    } catch (const BenchFault& fault) {
      run.fault = fault.what();
    } catch (const record::StoreError& error) {
      store_fault = error.what();
    } catch (const Stopped&) {
      run.interrupted = true;
    }
    note_relay_sense(station, run);
  }
  if (!store_fault.empty()) {
    return ended_by_store(store_fault, plan, store, std::move(run));
  }
  try {
    recorder.finish();
    judge_stored(plan, station, signal, store, options.writer == nullptr, run);
    run.finished_utc = utc_now();
    store.finish(run);
  } catch (const record::StoreError& error) {
    return ended_by_store(error.what(), plan, store, std::move(run));
  }
  return run;
}

}  // namespace gsbench::station
