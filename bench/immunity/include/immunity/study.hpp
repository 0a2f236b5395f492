// Many cases, counted by kind and compared with the limits.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include <immunity/settled_outlets.hpp>

namespace gsbench::immunity {

constexpr double kMostEventsOfDips =
    1e-3;  // events per dip, over all kinds of dips; no trips at all

struct Count {
  std::uint32_t cases = 0;
  std::uint32_t events = 0;  // cases with an event
  std::uint32_t trips = 0;   // cases with an open relay
  // The first case with a trip; without one, and if the kind is a dip, the first with an event.
  std::optional<std::uint32_t> first_failing;

  bool passes_trips() const { return trips == 0; }
  bool passes_events() const { return events <= kMostEventsOfDips * cases; }
};

struct Result {
  std::array<Count, kKinds.size()> kinds;  // in the order of kKinds
  Count dips() const;                      // the sum over all kinds of dips
  Count all() const;
  bool passes() const { return all().passes_trips() && dips().passes_events(); }
};

using Cases = std::function<Disturbance(std::uint32_t number)>;  // called on any thread

// Plays cases 0 … cases − 1 of the options. After a stop, those that were played are counted. The
// result does not depend on the number of threads. Throws like SettledOutlets.
Result play_all(const SettledOutlets& outlets, const Cases& cases,
                const campaign::Execution& execution);

}  // namespace gsbench::immunity
