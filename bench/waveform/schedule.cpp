#include "schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsbench::waveform {
namespace {

// Times closer than this are equal: rounding errors of decimal fractions in doubles.
constexpr double kSameTime_s = 1e-9;

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

struct Interval {
  std::int64_t from_tick;
  std::int64_t end_tick;
  double level;
};

struct Jump {
  std::int64_t tick;
  double degrees;
};

std::vector<Interval> intervals_of(const SignalSpec& spec, std::int64_t sample_rate_hz) {
  std::vector<Interval> result;
  for (const AmplitudeStep& step : spec.amplitude_steps) {
    result.push_back({tick_at(step.at_s, sample_rate_hz),
                      tick_at(step.at_s + step.duration_s, sample_rate_hz), step.level_pct / 100});
  }
  std::sort(result.begin(), result.end(),
            [](const Interval& a, const Interval& b) { return a.from_tick < b.from_tick; });
  return result;
}

std::vector<Jump> jumps_of(const SignalSpec& spec, std::int64_t sample_rate_hz) {
  std::vector<Jump> result;
  for (const PhaseJump& jump : spec.phase_jumps) {
    result.push_back({tick_at(jump.at_s, sample_rate_hz), jump.degrees});
  }
  std::sort(result.begin(), result.end(),
            [](const Jump& a, const Jump& b) { return a.tick < b.tick; });
  return result;
}

}  // namespace

std::int64_t tick_at(double t_s, std::int64_t sample_rate_hz) {
  const double tick = std::ceil((t_s - kSameTime_s) * static_cast<double>(sample_rate_hz));
  return tick < 0x1p62 ? static_cast<std::int64_t>(tick) : kNever;
}

Schedule::Schedule(const SignalSpec& spec, std::int64_t sample_rate_hz) {
  const std::vector<Interval> levels = intervals_of(spec, sample_rate_hz);
  const std::vector<Jump> jumps = jumps_of(spec, sample_rate_hz);
  std::vector<std::int64_t> ticks = {0};
  for (const Interval& interval : levels) {
    ticks.push_back(interval.from_tick);
    ticks.push_back(interval.end_tick);
  }
  for (const Jump& jump : jumps) {
    ticks.push_back(jump.tick);
  }
  std::sort(ticks.begin(), ticks.end());
  ticks.erase(std::unique(ticks.begin(), ticks.end()), ticks.end());

  std::vector<Interval> holding;
  auto next_level = levels.begin();
  auto next_jump = jumps.begin();
  double degrees = spec.initial_phase_deg;
  for (const std::int64_t tick : ticks) {
    const auto is_over = [tick](const Interval& interval) { return interval.end_tick <= tick; };
    holding.erase(std::remove_if(holding.begin(), holding.end(), is_over), holding.end());
    for (; next_level != levels.end() && next_level->from_tick <= tick; ++next_level) {
      if (!is_over(*next_level)) {
        holding.push_back(*next_level);
      }
    }
    for (; next_jump != jumps.end() && next_jump->tick <= tick; ++next_jump) {
      degrees += next_jump->degrees;
    }
    double level = 1.0;
    for (const Interval& interval : holding) {
      level *= interval.level;
    }
    const double cycles = degrees / 360.0;
    entries_.push_back({tick, level, cycles - std::floor(cycles), cycles});
  }
}

std::size_t Schedule::index_at(std::int64_t tick) const {
  const auto next = std::upper_bound(
      entries_.begin(), entries_.end(), tick,
      [](std::int64_t at, const ScheduleEntry& entry) { return at < entry.from_tick; });
  return static_cast<std::size_t>(next - entries_.begin()) - 1;
}

std::int64_t Schedule::end_tick(std::size_t index) const {
  return index + 1 < entries_.size() ? entries_[index + 1].from_tick : kNever;
}

}  // namespace gsbench::waveform
