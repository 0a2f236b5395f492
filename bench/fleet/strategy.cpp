#include <algorithm>

#include <fleet/strategy.hpp>

namespace gsbench::fleet {
namespace {

struct StrategyRow {
  Strategy strategy;
  const char* name;
  std::optional<double> knows_after_s = {};  // of clairvoyants
};

constexpr StrategyRow kStrategies[] = {
    {Strategy::kNone, "none"},
    {Strategy::kPaper, "paper"},
    {Strategy::kGsbench, "gsbench"},
    {Strategy::kCentral, "central"},
    {Strategy::kUfls, "ufls"},
    {Strategy::kClairvoyant300ms, "clairvoyant-0.3", 0.3},
    {Strategy::kClairvoyant500ms, "clairvoyant-0.5", 0.5},
    {Strategy::kClairvoyant750ms, "clairvoyant-0.75", 0.75},
    {Strategy::kClairvoyant960ms, "clairvoyant-0.96", 0.96},
};

const StrategyRow& row_of(Strategy strategy) {
  return *std::find_if(std::begin(kStrategies), std::end(kStrategies),
                       [&](const StrategyRow& row) { return row.strategy == strategy; });
}

}  // namespace

const char* to_string(Strategy strategy) {
  return row_of(strategy).name;
}

const std::vector<Strategy>& all_strategies() {
  static const std::vector<Strategy> all = [] {
    std::vector<Strategy> strategies;
    for (const StrategyRow& row : kStrategies) {
      strategies.push_back(row.strategy);
    }
    return strategies;
  }();
  return all;
}

bool has_outlets(Strategy strategy) {
  return strategy == Strategy::kPaper || strategy == Strategy::kGsbench;
}

std::optional<double> knows_loss_after_s(Strategy strategy) {
  return row_of(strategy).knows_after_s;
}

bool plays_recorded_frequency(const profile::Plan& plan) {
  const auto& points = plan.stimulus.points;
  return std::any_of(points.begin(), points.end(), [&](const recording::TracePoint& point) {
    return point.frequency_hz != points.front().frequency_hz;
  });
}

bool is_possible(const profile::Plan& plan, Strategy strategy) {
  const bool knows_losses = strategy == Strategy::kCentral || knows_loss_after_s(strategy);
  return !knows_losses || !plays_recorded_frequency(plan);
}

}  // namespace gsbench::fleet
