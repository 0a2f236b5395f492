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

}  // namespace

record::ReferenceTrace reference_trace(const waveform::ReferenceSignal& reference,
                                       std::int64_t duration_ticks, std::int64_t sample_rate_hz) {
  const auto rate = static_cast<double>(sample_rate_hz);
  const std::int64_t step = sample_rate_hz * 16 / 1000;
  record::ReferenceTrace entries;
  std::vector<std::int64_t>& ticks = entries.tick;
  for (std::int64_t tick = 0; tick < duration_ticks; tick += step) {
    ticks.push_back(tick);
  }
  ticks.push_back(duration_ticks);
  for (const double corner_s : reference.corners_s()) {
    const std::int64_t tick = waveform::tick_at(corner_s, sample_rate_hz);
    if (tick > 0 && tick < duration_ticks) {
      // One on each side, since the ROCOF has a step there.
      ticks.push_back(tick - 1);
      ticks.push_back(tick);
    }
  }
  std::sort(ticks.begin(), ticks.end());
  ticks.erase(std::unique(ticks.begin(), ticks.end()), ticks.end());

  for (const std::int64_t tick : ticks) {
    const double t_s = static_cast<double>(tick) / rate;
    entries.frequency_hz.push_back(reference.frequency_hz(t_s));
    entries.rocof_hz_s.push_back(reference.rocof_hz_s(t_s));
  }
  record::ReferenceTrace trace;
  const auto keep = [&](std::size_t i) {
    trace.tick.push_back(ticks[i]);
    trace.frequency_hz.push_back(entries.frequency_hz[i]);
    trace.rocof_hz_s.push_back(entries.rocof_hz_s[i]);
  };
  keep(0);
  std::size_t first = 0;
  while (first + 1 < ticks.size()) {
    // Exponential, then binary search for the longest line: few checks of each entry.
    std::size_t good = first + 1;
    std::size_t reach = 2;
    while (first + reach < ticks.size() && reach <= kLongestRun &&
           line_fits(entries, first, first + reach)) {
      good = first + reach;
      reach *= 2;
    }
    std::size_t bad = std::min(first + reach, ticks.size());
    while (good + 1 < bad) {
      const std::size_t middle = good + (bad - good) / 2;
      (line_fits(entries, first, middle) ? good : bad) = middle;
    }
    keep(good);
    first = good;
  }
  return trace;
}

}  // namespace gsbench::capture
