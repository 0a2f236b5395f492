// The relay sense measures when relay contacts move. It has its own clock and does not depend on
// what outlets report. It is the reference for switching times. An outlet may have no channel.
#pragma once

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::relay {

struct Edge {
  std::size_t channel = 0;
  std::int64_t count = 0;  // on the relay sense's clock
  bool closed = false;
};

// Converts the relay sense's counts to the source's ticks, by a straight line. The count rate is
// `counts_per_tick` times the stimulus's sample rate.
struct Alignment {
  double count_at_tick_0 = 0.0;
  double counts_per_tick = 1.0;
  double uncertainty_ticks = 0.0;  // largest error of an edge's tick, ±
  // Largest error of the time between an edge and an instant of RelaySense::count_at(), ±: without
  // the errors that both share.
  double uncertainty_between_ticks = 0.0;

  std::int64_t tick_of(std::int64_t count) const {
    return std::llround((static_cast<double>(count) - count_at_tick_0) / counts_per_tick);
  }
};

// Used by one thread at a time.
class RelaySense {
 public:
  virtual ~RelaySense() = default;
  // Connects. Called before the source is energised. Blocks until ports are open.
  [[nodiscard]] virtual drivers::Status open() { return drivers::Done{}; }
  // Valid from the source's start on, for the edges polled so far. `uncertainty_ticks` is valid at
  // any time. Before the start it lacks what is not_known_yet(); it may grow with each poll.
  virtual Alignment alignment() const = 0;
  // For people: what adds to the uncertainty in a run and is not known before; empty: nothing.
  virtual std::string not_known_yet() const { return {}; }
  // The count at an instant of this machine's clock, such as that of a command; nullopt: the relay
  // sense does not count that clock.
  virtual std::optional<std::int64_t> count_at(std::chrono::steady_clock::time_point) const {
    return std::nullopt;
  }
  // Appends the edges since the last call, bounces included, in time order for each channel. Does
  // not block. A contact counts as closed until its first edge: for a contact that is open when the
  // bench first sees it, the first edge is an opening at that time.
  [[nodiscard]] virtual drivers::Status poll(std::vector<Edge>& edges) = 0;
};

}  // namespace gsbench::relay
