#include <seed_sweep/distribution.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gsbench::seed_sweep {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void Distribution::add(double value) {
  if (std::isnan(value)) {
    ++missing_;
  } else {
    values_.push_back(value);
  }
}

void Distribution::merge(const Distribution& other) {
  values_.insert(values_.end(), other.values_.begin(), other.values_.end());
  missing_ += other.missing_;
  for (const auto& [text, count] : other.texts_) {
    texts_[text] += count;
  }
}

void Distribution::sort() {
  std::sort(values_.begin(), values_.end());
}

double Distribution::quantile(double p) const {
  if (values_.empty()) {
    return kNone;
  }
  const double rank = std::ceil(p * static_cast<double>(values_.size())) - 1.0;
  const double last = static_cast<double>(values_.size() - 1);
  return values_[static_cast<std::size_t>(std::min(std::max(rank, 0.0), last))];
}

double Distribution::mean() const {
  if (values_.empty()) {
    return kNone;
  }
  return std::accumulate(values_.begin(), values_.end(), 0.0) / static_cast<double>(values_.size());
}

double Distribution::standard_deviation() const {
  if (values_.size() < 2) {
    return kNone;
  }
  const double centre = mean();
  double squares = 0.0;
  for (const double value : values_) {
    squares += (value - centre) * (value - centre);
  }
  return std::sqrt(squares / static_cast<double>(values_.size() - 1));
}

double Distribution::share_within(double limit) const {
  const std::size_t all = values_.size() + missing_;
  if (all == 0) {
    return kNone;
  }
  const auto within = std::count_if(values_.begin(), values_.end(),
                                    [limit](double value) { return std::fabs(value) <= limit; });
  return static_cast<double>(within) / static_cast<double>(all);
}

}  // namespace gsbench::seed_sweep
