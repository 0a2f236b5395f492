// The bench's own eye on each outlet's contact: what it sees is the truth about switching.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::relay {

struct Edge {
  std::size_t outlet = 0;
  std::int64_t tick = 0;
  bool closed = false;
};

class RelaySense {
 public:
  virtual ~RelaySense() = default;
  // Half a width within which an edge's tick is right, in ticks.
  virtual double uncertainty_ticks() const = 0;
  // Appends the edges since the last call, bounces included, in order for each outlet.
  [[nodiscard]] virtual drivers::Status poll(std::vector<Edge>& edges) = 0;
};

}  // namespace gsbench::relay
