// What a measurement is made of: one outlet's record, beside the reference that was played.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <waveform/reference_signal.hpp>

namespace gsbench::judge {

struct Case {
  const profile::Plan& plan;
  const waveform::ReferenceSignal& reference;
  const record::OutletRecord& outlet;
  const record::BenchUncertainty& uncertainty;

  double seconds(std::int64_t tick) const;
  double milliseconds_between(std::int64_t from_tick, std::int64_t to_tick) const;
  // An outlet's frequency is that of so long before its stamp.
  double tracker_delay_s() const;
  // The first loss of power that the profile plays.
  std::optional<std::int64_t> first_loss_tick() const;
  // Power lost in sum by then, MW.
  double lost_mw(std::int64_t tick) const;
  // Amplitude at the outlet's terminals, per unit of nominal, noise and harmonics aside.
  double true_voltage_pu(double t_s) const;
  const record::Mark* first_mark(const std::string& kind, std::int64_t from_tick = 0) const;
  // Where the outlet reports that its relay opened.
  const record::Mark* first_word_open(std::int64_t from_tick = 0) const;
};

// A contact's change as the relay sense saw it: a burst of edges, its bounces, taken as one.
struct ContactChange {
  std::int64_t first_tick;  // of its first edge
  bool closed;              // where it came to rest
  int edges;
};

// Changes that last; a burst that ends where it began is none, but its edges count as chatter.
struct Contact {
  std::vector<ContactChange> changes;
  int idle_edges = 0;  // in bursts that ended where they began
  bool closed = true;  // at the end
};
Contact contact(const Case& c);

}  // namespace gsbench::judge
