#include <algorithm>

#include <fmt/format.h>

#include <fleet/limits.hpp>

namespace gsbench::fleet {

std::optional<Clairvoyants> clairvoyants_of(const std::vector<StrategyResult>& results) {
  std::optional<Clairvoyants> all;
  for (const auto& [strategy, result] : results) {
    if (!knows_loss_after_s(strategy) || !result) {
      continue;
    }
    const Clairvoyants so_far = all.value_or(Clairvoyants{result->nadir_hz, result->shed_mw});
    all = {std::min(so_far.lowest_nadir_hz, result->nadir_hz),
           std::max(so_far.most_shed_mw, result->shed_mw)};
  }
  return all;
}

ClosedLoopLimits limits_of(const profile::Plan& plan, const Clairvoyants& clairvoyants) {
  const double most_mw = clairvoyants.most_shed_mw;
  return {clairvoyants.lowest_nadir_hz - kNadirMargin_hz,
          most_mw > 0.0 ? kShedFactor * most_mw + kShedMargin_mw : 0.0,
          plan.stimulus.oscillations.empty()};
}

std::vector<std::string> missed_limits(const ClosedLoopResult& outlets,
                                       const ClosedLoopLimits& limits) {
  std::vector<std::string> missed;
  if (!(outlets.nadir_hz >= limits.least_nadir_hz)) {
    missed.push_back(fmt::format("the nadir of {:.3f} Hz is below {:.3f} Hz", outlets.nadir_hz,
                                 limits.least_nadir_hz));
  }
  if (!(outlets.shed_mw <= limits.most_shed_mw)) {
    missed.push_back(
        fmt::format("{:.1f} MW shed is more than {:.1f} MW", outlets.shed_mw, limits.most_shed_mw));
  }
  const std::size_t false_events = outlets.outlets ? outlets.outlets->false_events.value_or(0) : 0;
  if (limits.judges_false_events && false_events > 0) {
    missed.push_back(
        fmt::format("outlets that claimed an event while nothing was lost: {}", false_events));
  }
  return missed;
}

}  // namespace gsbench::fleet
