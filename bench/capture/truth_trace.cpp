#include <algorithm>
#include <cmath>
#include <vector>

#include <capture/truth_trace.hpp>

namespace gsbench::capture {
namespace {

constexpr double kToleranceHz = 5e-5;
// Longest run of entries one line may replace: bounds the work of looking back over it.
constexpr std::size_t kLongestRun = 2000;

// Whether the straight line from `first` to `last` is right at every entry between them.
bool line_serves(const std::vector<double>& ticks, const std::vector<double>& hz, std::size_t first,
                 std::size_t last) {
  const double slope = (hz[last] - hz[first]) / (ticks[last] - ticks[first]);
  for (std::size_t i = first + 1; i < last; ++i) {
    const double on_line = hz[first] + slope * (ticks[i] - ticks[first]);
    if (std::fabs(on_line - hz[i]) > kToleranceHz) {
      return false;
    }
  }
  return true;
}

}  // namespace

record::TruthTrace truth_trace(const waveform::Truth& truth, std::int64_t duration_ticks,
                               std::int64_t sample_rate_hz) {
  const auto rate = static_cast<double>(sample_rate_hz);
  const std::int64_t step = sample_rate_hz * 16 / 1000;
  std::vector<std::int64_t> ticks;
  for (std::int64_t tick = 0; tick < duration_ticks; tick += step) {
    ticks.push_back(tick);
  }
  ticks.push_back(duration_ticks);
  for (const double corner_s : truth.corners_s()) {
    const double tick = std::round(corner_s * rate);
    if (tick > 0.0 && tick < static_cast<double>(duration_ticks)) {
      ticks.push_back(static_cast<std::int64_t>(tick));
    }
  }
  std::sort(ticks.begin(), ticks.end());
  ticks.erase(std::unique(ticks.begin(), ticks.end()), ticks.end());

  std::vector<double> position(ticks.begin(), ticks.end());
  std::vector<double> hz(ticks.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    hz[i] = truth.frequency_hz(position[i] / rate);
  }
  record::TruthTrace trace;
  const auto keep = [&](std::size_t i) {
    trace.tick.push_back(ticks[i]);
    trace.frequency_hz.push_back(hz[i]);
    trace.rocof_hz_s.push_back(truth.rocof_hz_s(position[i] / rate));
  };
  keep(0);
  std::size_t first = 0;
  while (first + 1 < ticks.size()) {
    // Doubling, then halving: the longest run found costs few looks at each entry.
    std::size_t good = first + 1;
    std::size_t reach = 2;
    while (first + reach < ticks.size() && reach <= kLongestRun &&
           line_serves(position, hz, first, first + reach)) {
      good = first + reach;
      reach *= 2;
    }
    std::size_t bad = std::min(first + reach, ticks.size());
    while (good + 1 < bad) {
      const std::size_t middle = good + (bad - good) / 2;
      (line_serves(position, hz, first, middle) ? good : bad) = middle;
    }
    keep(good);
    first = good;
  }
  return trace;
}

}  // namespace gsbench::capture
