#include <cmath>

#include <models/relay_model.hpp>

namespace gsbench::models {

std::vector<ContactEdge> contact_edges(const RelayParameters& parameters, const Stream& stream,
                                       std::uint64_t n, std::int64_t coil_tick, bool closes,
                                       std::int64_t sample_rate_hz) {
  constexpr std::uint64_t kDrawsPerChange = 64;  // random values reserved for each operation
  std::uint64_t draw = n * kDrawsPerChange;
  const auto next = [&] { return uniform(stream, draw++); };
  const double ticks_per_ms = static_cast<double>(sample_rate_hz) / 1000.0;
  const double operate_ms =
      parameters.operate_ms + parameters.operate_spread_ms * (2.0 * next() - 1.0);
  std::int64_t tick = coil_tick + std::llround(operate_ms * ticks_per_ms);
  std::vector<ContactEdge> edges = {{tick, closes}};
  // Only a closing contact bounces.
  const int bounces = closes ? static_cast<int>(next() * (parameters.largest_bounces + 1)) : 0;
  for (int bounce = 0; bounce < bounces; ++bounce) {
    for (const bool closed : {!closes, closes}) {
      tick += 1 + std::llround(next() * parameters.bounce_ms * ticks_per_ms);
      edges.push_back({tick, closed});
    }
  }
  return edges;
}

}  // namespace gsbench::models
