// Limits on what outlets do in a closed loop. They follow from the clairvoyants
// (fleet/clairvoyant.hpp), because how far the frequency falls and how much must be shed depend on
// what is lost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <fleet/closed_loop.hpp>

namespace gsbench::fleet {

constexpr double kNadirMargin_hz = 0.020;  // below the lowest nadir of the clairvoyants
constexpr double kShedFactor = 1.15;       // of the most that one of the clairvoyants sheds …
constexpr double kShedMargin_mw = 10.0;    // … and this much more

// Nothing: the strategy is not possible with the profile.
struct StrategyResult {
  Strategy strategy;
  std::optional<ClosedLoopResult> result;
};

// Of the clairvoyants on one profile.
struct Clairvoyants {
  double lowest_nadir_hz;
  double most_shed_mw;  // that one of them has off at any time
};

// Nothing without a result of a clairvoyant.
std::optional<Clairvoyants> clairvoyants_of(const std::vector<StrategyResult>& results);

struct ClosedLoopLimits {
  double least_nadir_hz;
  double most_shed_mw;  // off at any time; 0 if no clairvoyant sheds
  // False with oscillations: they change the frequency that outlets see, so that an event before
  // the loss is not false.
  bool judges_false_events;
};

ClosedLoopLimits limits_of(const profile::Plan& plan, const Clairvoyants& clairvoyants);

// The limits that a strategy with outlets misses, a text for each: nadir, power shed, and false
// events, of which none is allowed. Empty: all are met.
std::vector<std::string> missed_limits(const ClosedLoopResult& outlets,
                                       const ClosedLoopLimits& limits);

}  // namespace gsbench::fleet
