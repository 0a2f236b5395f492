#include "thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gsbench::render {
namespace {

constexpr std::size_t kKeptAPart = 5;  // minimum and maximum of two columns, and a NaN

void keep_extremes(const std::vector<double>& values, std::size_t from, std::size_t to,
                   std::vector<std::size_t>& kept) {
  std::size_t least = to;
  std::size_t greatest = to;
  for (std::size_t i = from; i < to; ++i) {
    if (std::isnan(values[i])) {
      continue;
    }
    if (least == to || values[i] < values[least]) {
      least = i;
    }
    if (greatest == to || values[i] > values[greatest]) {
      greatest = i;
    }
  }
  if (least == to) {
    return;
  }
  kept.push_back(least);
  kept.push_back(greatest);
}

void keep_stretches(const std::vector<std::int64_t>& tick, const std::vector<Stretch>& whole,
                    std::size_t most, std::vector<std::size_t>& kept) {
  for (const Stretch& stretch : whole) {
    const auto from = std::lower_bound(tick.begin(), tick.end(), stretch.from_tick);
    const auto to = std::upper_bound(from, tick.end(), stretch.to_tick);
    for (auto entry = from; entry < to && kept.size() < most; ++entry) {
      kept.push_back(static_cast<std::size_t>(entry - tick.begin()));
    }
  }
}

}  // namespace

std::vector<std::size_t> thinned(const std::vector<std::int64_t>& tick,
                                 const std::vector<double>& first,
                                 const std::vector<double>& second,
                                 const std::vector<Stretch>& whole, std::size_t most) {
  const std::size_t count = tick.size();
  std::vector<std::size_t> kept;
  if (count <= most) {
    kept.resize(count);
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    return kept;
  }
  kept = {0, count - 1};
  keep_stretches(tick, whole, most / 2, kept);
  const std::size_t parts = (most - kept.size()) / kKeptAPart;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t from = count * part / parts;
    const std::size_t to = count * (part + 1) / parts;
    keep_extremes(first, from, to, kept);
    keep_extremes(second, from, to, kept);
    std::size_t gap = from;
    while (gap < to && !std::isnan(first[gap])) {
      ++gap;
    }
    if (gap < to) {
      kept.push_back(gap);
    }
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace gsbench::render
