// The bench's own eye on contacts: when they move, by its own clock. What it sees is the reference
// for switching, whatever an outlet reports. An outlet may be without a channel of it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::relay {

struct Edge {
  std::size_t channel = 0;
  std::int64_t count = 0;  // of the sense's clock
  bool closed = false;
};

// The sense's counts as the source's ticks: a straight line. Its rate is `counts_per_tick` times
// the stimulus's sample rate.
struct Alignment {
  double count_at_tick_0 = 0.0;
  double counts_per_tick = 1.0;
  double uncertainty_ticks = 0.0;  // half a width within which an edge's tick is right

  std::int64_t tick_of(std::int64_t count) const {
    return std::llround((static_cast<double>(count) - count_at_tick_0) / counts_per_tick);
  }
};

class RelaySense {
 public:
  virtual ~RelaySense() = default;
  // From the source's start on; of the edges polled so far. Its uncertainty is known before.
  virtual Alignment alignment() const = 0;
  // Appends the edges since the last call, bounces included, in order for each channel.
  [[nodiscard]] virtual drivers::Status poll(std::vector<Edge>& edges) = 0;
};

}  // namespace gsbench::relay
