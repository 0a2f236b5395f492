#include <algorithm>
#include <cmath>
#include <vector>

#include <capture/capture.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::capture {
namespace {

constexpr double kTolerance_hz = 5e-5;
constexpr double kTolerance_hz_s = 5e-3;
// Limit of the entries that one line may replace; bounds the work of checking them.
constexpr std::size_t kLongestRun = 2000;

// True if lines from `first` to `last` reproduce every entry between them within the tolerances.
bool line_fits(const record::ReferenceTrace& entries, std::size_t first, std::size_t last) {
  const auto off_line = [&](const std::vector<double>& y, std::size_t i) {
    const double part = static_cast<double>(entries.tick[i] - entries.tick[first]) /
                        static_cast<double>(entries.tick[last] - entries.tick[first]);
    return std::fabs(y[first] + part * (y[last] - y[first]) - y[i]);
  };
  for (std::size_t i = first + 1; i < last; ++i) {
    if (off_line(entries.frequency_hz, i) > kTolerance_hz ||
        off_line(entries.rocof_hz_s, i) > kTolerance_hz_s) {
      return false;
    }
  }
  return true;
}

// Ticks on each side of every corner, where the ROCOF has a step, ascending.
std::vector<std::int64_t> corner_ticks(const waveform::ReferenceSignal& reference,
                                       std::int64_t duration_ticks, std::int64_t sample_rate_hz) {
  std::vector<std::int64_t> ticks;
  for (const double corner_s : reference.corners_s()) {
    const std::int64_t tick = waveform::tick_at(corner_s, sample_rate_hz);
    if (tick > 0 && tick < duration_ticks) {
      ticks.push_back(tick - 1);
      ticks.push_back(tick);
    }
  }
  std::sort(ticks.begin(), ticks.end());
  return ticks;
}

// Entries every 16 ms, at corners and at the end. Only those that a line may reach are in memory.
class Entries {
 public:
  Entries(const waveform::ReferenceSignal& reference, std::int64_t duration_ticks,
          std::int64_t sample_rate_hz)
      : reference_(reference),
        corners_(corner_ticks(reference, duration_ticks, sample_rate_hz)),
        last_tick_(duration_ticks),
        step_ticks_(sample_rate_hz * 16 / 1000),
        rate_hz_(static_cast<double>(sample_rate_hz)) {
    corners_.push_back(duration_ticks);
  }

  // Adds entries until a line from `first` may end at any of them, or to the end. Drops what is
  // before `first` from time to time, and then sets it to 0.
  const record::ReferenceTrace& from(std::size_t& first) {
    if (first > kKept) {
      const auto end = static_cast<std::ptrdiff_t>(first);
      entries_.tick.erase(entries_.tick.begin(), entries_.tick.begin() + end);
      entries_.frequency_hz.erase(entries_.frequency_hz.begin(),
                                  entries_.frequency_hz.begin() + end);
      entries_.rocof_hz_s.erase(entries_.rocof_hz_s.begin(), entries_.rocof_hz_s.begin() + end);
      first = 0;
    }
    while (next_tick_ <= last_tick_ && entries_.tick.size() < first + kAhead) {
      add(next_tick_);
      const auto corner = std::upper_bound(corners_.begin(), corners_.end(), next_tick_);
      const std::int64_t on_grid = (next_tick_ / step_ticks_ + 1) * step_ticks_;
      next_tick_ = corner == corners_.end() ? last_tick_ + 1 : std::min(*corner, on_grid);
    }
    return entries_;
  }

 private:
  static constexpr std::size_t kAhead = 2 * kLongestRun + 1;
  static constexpr std::size_t kKept = 2 * kAhead;

  void add(std::int64_t tick) {
    const double t_s = static_cast<double>(tick) / rate_hz_;
    entries_.tick.push_back(tick);
    entries_.frequency_hz.push_back(reference_.frequency_hz(t_s));
    entries_.rocof_hz_s.push_back(reference_.rocof_hz_s(t_s));
  }

  const waveform::ReferenceSignal& reference_;
  std::vector<std::int64_t> corners_;  // and the end
  std::int64_t last_tick_;
  std::int64_t step_ticks_;
  double rate_hz_;
  std::int64_t next_tick_ = 0;
  record::ReferenceTrace entries_;
};

}  // namespace

record::ReferenceTrace reference_trace(const waveform::ReferenceSignal& reference,
                                       std::int64_t duration_ticks, std::int64_t sample_rate_hz) {
  Entries all(reference, duration_ticks, sample_rate_hz);
  record::ReferenceTrace trace;
  std::size_t first = 0;
  for (bool more = true; more;) {
    const record::ReferenceTrace& entries = all.from(first);
    const std::size_t count = entries.tick.size();
    trace.tick.push_back(entries.tick[first]);
    trace.frequency_hz.push_back(entries.frequency_hz[first]);
    trace.rocof_hz_s.push_back(entries.rocof_hz_s[first]);
    more = first + 1 < count;
    // Exponential, then binary search for the longest line: few checks of each entry.
    std::size_t good = first + 1;
    std::size_t reach = 2;
    while (first + reach < count && reach <= kLongestRun &&
           line_fits(entries, first, first + reach)) {
      good = first + reach;
      reach *= 2;
    }
    std::size_t bad = std::min(first + reach, count);
    while (good + 1 < bad) {
      const std::size_t middle = good + (bad - good) / 2;
      (line_fits(entries, first, middle) ? good : bad) = middle;
    }
    first = good;
  }
  return trace;
}

}  // namespace gsbench::capture
