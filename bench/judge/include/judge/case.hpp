// Input of a measurement: one outlet's record and the reference that was played.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <judge/trace_sums.hpp>
#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <waveform/reference_signal.hpp>

namespace gsbench::judge {

struct Case {
  const profile::Plan& plan;
  const waveform::ReferenceSignal& reference;
  const record::OutletRecord& outlet;  // with its marks; its traces are not used
  const record::BenchUncertainty& uncertainty;
  TraceSums traces = {};

  // The traces of the next piece of the outlet's reports, placed on the run's time.
  void add(const record::Reports& piece);

  double seconds(std::int64_t tick) const;
  double milliseconds_between(std::int64_t from_tick, std::int64_t to_tick) const;
  // The declared delay: a report with time stamp t gives the frequency at t − delay.
  double tracker_delay_s() const;
  // The first loss of power in the profile.
  std::optional<std::int64_t> first_loss_tick() const;
  // Total power lost in the profile up to `tick`, MW.
  double lost_mw(std::int64_t tick) const;
  // Power lost before the profile, MW, that explains its frequency before; below 0 above nominal.
  double lost_before_mw() const;
  // Amplitude at the outlet's terminals in p.u. of nominal, without noise and harmonics.
  double reference_voltage_pu(double t_s) const;
  const record::Mark* first_mark(const std::string& kind, std::int64_t from_tick = 0) const;
  // The outlet's first report of a command to open its relay.
  const record::Mark* first_reported_opening(std::int64_t from_tick = 0) const;
};

// A change of the contact as seen by the relay sense: a burst of edges (bounces) counts as one.
struct ContactChange {
  std::int64_t first_tick;  // of its first edge
  bool closed;              // after the last edge
  int edges;
};

// Only lasting changes: a burst that ends in the position it started from is not a change.
struct Contact {
  std::vector<ContactChange> changes;
  int idle_edges = 0;  // edges of bursts without a lasting change
  bool closed = true;  // at the end
};
Contact contact(const Case& c);

}  // namespace gsbench::judge
