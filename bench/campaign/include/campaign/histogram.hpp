// The distribution of one figure over a campaign: a histogram, and sums for mean and standard
// deviation. Bins and sums are integers (the sums in very small units). The result therefore does
// not depend on the order of additions, nor on the number of threads or processes. The memory does
// not grow with the number of values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gsbench::campaign {

class Histogram {
 public:
  // From low to high in equal bins; values outside are counted as below or above. Exact for up to
  // 10⁹ values within twice the range. Throws std::invalid_argument unless high > low and bins > 0.
  Histogram(double low, double high, std::size_t bins);

  void add(double value);              // a NaN counts as missing
  void merge(const Histogram& other);  // throws std::invalid_argument for different bins

  std::int64_t count() const;  // without the missing
  std::int64_t missing() const { return counts_[kMissing]; }
  double mean() const;                // NaN without a value
  double standard_deviation() const;  // NaN for fewer than two values
  double smallest() const { return smallest_; }
  double largest() const { return largest_; }
  // Values in [from, to), both on edges of bins. Missing values are in no bin.
  std::int64_t count_between(double from, double to) const;
  double share_between(double from, double to) const;  // of all values, missing ones included
  // The quantile p, 0 … 1, as the middle of its bin. NaN without a value.
  double quantile(double p) const;

  double low() const { return low_; }
  std::size_t bins() const { return bins_; }
  std::int64_t in_bin(std::size_t bin) const { return counts_[kFirstBin + bin]; }

 private:
  enum : std::size_t { kMissing, kBelow, kAbove, kSum, kSquaresLow, kSquaresHigh, kFirstBin };

  double low_;
  double width_;
  std::size_t bins_;
  double unit_;  // of the sums
  std::vector<std::int64_t> counts_;
  double smallest_;
  double largest_;
};

}  // namespace gsbench::campaign
