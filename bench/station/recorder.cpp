#include "recorder.hpp"

#include "run_steps.hpp"

namespace gsbench::station {
namespace {

// Of the signal. A station that plays faster than real time takes far less for either.
constexpr double kPeriod_s = 0.5;
constexpr double kFastPeriod_s = 8.0;
// Blocks of real time are shorter.
constexpr double kLongestRealTimeBlock_s = 0.1;
// After the dips before the run, which end a second before it, these have been reported.
constexpr double kDipsReported_s = 0.3;
constexpr double kLastAttempt_s = 5.0;

std::string changing(const record::OutletRecord& outlet) {
  return outlet.settings_digest + (outlet.clock.is_aligned() ? " aligned " : " ") + outlet.fault;
}

}  // namespace

Recorder::Recorder(record::Store& store, const Station& station, const PlayedSignal& signal,
                   capture::Capture& capture, record::RunRecord& run)
    : store_(store),
      station_(station),
      signal_(signal),
      capture_(capture),
      run_(run),
      period_ticks_(
          waveform::tick_at(station.block_s() > kLongestRealTimeBlock_s ? kFastPeriod_s : kPeriod_s,
                            signal.sample_rate_hz())),
      next_tick_(period_ticks_) {}

void Recorder::add_outlets() {
  for (record::OutletRecord& outlet : run_.outlets) {
    if (has_own_clock(station_, outlet)) {
      outlet.clock.samples_per_tick = 0.0;  // not aligned yet
    }
    store_.add_outlet(outlet);
    outlet.reports = {};
    stored_.push_back(changing(outlet));
  }
}

void Recorder::reached(std::int64_t tick) {
  if (tick < next_tick_) {
    return;
  }
  next_tick_ = tick + period_ticks_;
  append();
  align_early(tick);
  update_changed();
}

void Recorder::finish() {
  append();
  update_changed();
}

void Recorder::append() {
  std::vector<record::Reports> reports;
  for (record::OutletRecord& outlet : run_.outlets) {
    reports.push_back(capture_.take(outlet.id));
    outlet.settings_digest = capture_.settings_digest(outlet.id);
  }
  store_.append(reports);
}

void Recorder::align_early(std::int64_t tick) {
  const std::vector<capture::Dip>& dips = signal_.markers().before.dips;
  if (dips.empty()) {
    return;
  }
  const double since_dips_s =
      static_cast<double>(tick - signal_.lead_ticks() - dips.back().to_tick) /
      static_cast<double>(signal_.sample_rate_hz());
  if (since_dips_s < kDipsReported_s || since_dips_s > kLastAttempt_s) {
    return;
  }
  for (std::size_t i = 0; i < run_.outlets.size(); ++i) {
    if (has_own_clock(station_, run_.outlets[i]) && !run_.outlets[i].clock.is_aligned()) {
      align(signal_.markers(), store_, i, run_);
    }
  }
}

void Recorder::update_changed() {
  for (std::size_t i = 0; i < run_.outlets.size(); ++i) {
    const std::string now = changing(run_.outlets[i]);
    if (now != stored_[i]) {
      store_.update_outlet(i, run_.outlets[i]);
      stored_[i] = now;
    }
  }
}

}  // namespace gsbench::station
