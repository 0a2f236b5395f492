// A relay's contact: it follows its coil some milliseconds later and bounces when it closes.
#pragma once

#include <cstdint>
#include <vector>

#include <models/noise.hpp>

namespace gsbench::models {

// The bounces of one change are over before the next can begin:
// 2·largest_bounces·bounce_ms < operate_ms − operate_spread_ms.
struct RelayParameters {
  double operate_ms = 8.0;         // coil to contact, mean
  double operate_spread_ms = 1.5;  // ± of it, uniform
  int largest_bounces = 3;         // pairs of edges on closing
  double bounce_ms = 0.4;          // longest gap between two of them
};

struct ContactEdge {
  std::int64_t tick;
  bool closed;
};

// The contact edges that follow a change of the coil, the n-th of this relay; ascending in time,
// the last of them the lasting one. A pure function of its arguments.
std::vector<ContactEdge> contact_edges(const RelayParameters& parameters, const Stream& stream,
                                       std::uint64_t n, std::int64_t coil_tick, bool closes,
                                       std::int64_t sample_rate_hz);

}  // namespace gsbench::models
