#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <campaign/histogram.hpp>

namespace gsbench::campaign {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t kLow32 = 0xFFFFFFFF;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

// For values within twice the range, the number of steps is below 2²³ and its square below 2⁴⁶.
// Sums of 10⁹ values stay below 2⁶³, as the lower 32 bits of the squares are summed separately.
Histogram::Histogram(double low, double high, std::size_t bins)
    : low_(low),
      width_((high - low) / static_cast<double>(bins)),
      bins_(bins),
      unit_((high - low) * 0x1p-22),
      counts_(kFirstBin + bins, 0),
      smallest_(kInfinity),
      largest_(-kInfinity) {
  if (!(high > low) || bins == 0) {
    throw std::invalid_argument("a histogram must have high > low and at least one bin");
  }
}

void Histogram::add(double value) {
  if (std::isnan(value)) {
    ++counts_[kMissing];
    return;
  }
  const double middle = low_ + 0.5 * width_ * static_cast<double>(bins_);
  const double at = std::floor((value - low_) / width_);
  if (at < 0.0) {
    ++counts_[kBelow];
  } else if (at >= static_cast<double>(bins_)) {
    ++counts_[kAbove];
  } else {
    ++counts_[kFirstBin + static_cast<std::size_t>(at)];
  }
  const std::int64_t steps = std::llround((value - middle) / unit_);
  const std::int64_t square = steps * steps;
  counts_[kSum] += steps;
  counts_[kSquaresLow] += square & kLow32;
  counts_[kSquaresHigh] += square >> 32;
  smallest_ = std::min(smallest_, value);
  largest_ = std::max(largest_, value);
}

void Histogram::merge(const Histogram& other) {
  if (other.low_ != low_ || other.width_ != width_ || other.bins_ != bins_) {
    throw std::invalid_argument("histograms with different bins cannot be merged");
  }
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    counts_[i] += other.counts_[i];
  }
  smallest_ = std::min(smallest_, other.smallest_);
  largest_ = std::max(largest_, other.largest_);
}

std::int64_t Histogram::count() const {
  return counts_[kBelow] + counts_[kAbove] +
         std::accumulate(counts_.begin() + kFirstBin, counts_.end(), std::int64_t{0});
}

double Histogram::mean() const {
  const std::int64_t n = count();
  return n == 0 ? kNone
                : low_ + 0.5 * width_ * static_cast<double>(bins_) +
                      unit_ * static_cast<double>(counts_[kSum]) / static_cast<double>(n);
}

double Histogram::standard_deviation() const {
  const std::int64_t n = count();
  if (n < 2) {
    return kNone;
  }
  const auto all = static_cast<long double>(n);
  const long double mean_steps = static_cast<long double>(counts_[kSum]) / all;
  const long double squares = static_cast<long double>(counts_[kSquaresHigh]) * 0x1p32L +
                              static_cast<long double>(counts_[kSquaresLow]);
  const long double variance = std::max(squares / all - mean_steps * mean_steps, 0.0L);
  return unit_ * static_cast<double>(std::sqrt(variance * all / (all - 1.0L)));
}

std::int64_t Histogram::count_between(double from, double to) const {
  const auto edge = [this](double value) {
    const auto bin = std::llround((value - low_) / width_);
    return kFirstBin +
           static_cast<std::size_t>(std::clamp<long long>(bin, 0, static_cast<long long>(bins_)));
  };
  const std::size_t first = edge(from);
  const std::size_t end = std::max(edge(to), first);
  return std::accumulate(counts_.begin() + static_cast<std::ptrdiff_t>(first),
                         counts_.begin() + static_cast<std::ptrdiff_t>(end), std::int64_t{0});
}

double Histogram::share_between(double from, double to) const {
  const std::int64_t all = count() + missing();
  return all == 0 ? kNone : static_cast<double>(count_between(from, to)) / static_cast<double>(all);
}

double Histogram::quantile(double p) const {
  const std::int64_t n = count();
  if (n == 0) {
    return kNone;
  }
  const auto rank = static_cast<std::int64_t>(std::ceil(p * static_cast<double>(n)));
  std::int64_t passed = counts_[kBelow];
  if (passed >= rank && passed > 0) {
    return smallest_;
  }
  for (std::size_t bin = 0; bin < bins_; ++bin) {
    passed += in_bin(bin);
    if (passed >= rank) {
      return low_ + width_ * (static_cast<double>(bin) + 0.5);
    }
  }
  return largest_;
}

}  // namespace gsbench::campaign
