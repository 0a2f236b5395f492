// The contact of a relay: it follows the coil after some milliseconds and bounces when it closes.
#pragma once

#include <cstdint>
#include <vector>

#include <models/noise.hpp>

namespace gsbench::models {

// The bounces of one operation must end before the next can begin:
// 2·largest_bounces·bounce_ms < operate_ms − operate_spread_ms.
struct RelayParameters {
  double operate_ms = 8.0;         // mean time from coil to contact
  double operate_spread_ms = 1.5;  // uniform, ± around the mean
  int largest_bounces = 3;         // on closing; a bounce is a pair of edges
  double bounce_ms = 0.4;          // longest time between two edges
};

struct ContactEdge {
  std::int64_t tick;
  bool closed;
};

// The contact edges after the n-th operation of this relay's coil, ascending in time; the last edge
// is the final state. A pure function of its arguments.
std::vector<ContactEdge> contact_edges(const RelayParameters& parameters, const Stream& stream,
                                       std::uint64_t n, std::int64_t coil_tick, bool closes,
                                       std::int64_t sample_rate_hz);

}  // namespace gsbench::models
