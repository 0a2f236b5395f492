// The distribution of one figure over a campaign, kept in whole numbers alone: a histogram, and
// sums in units far below what matters. Whole numbers add up to the same in any order, so that
// neither threads nor processes leave a trace, and their memory does not grow with the campaign.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gsbench::campaign {

class Histogram {
 public:
  // From low to high in that many equal bins; what lies outside is counted below and above. Exact
  // up to 10⁹ values within twice the range.
  Histogram(double low, double high, std::size_t bins);

  void add(double value);  // a NaN counts as missing
  void merge(const Histogram& other);

  std::int64_t count() const;  // without the missing
  std::int64_t missing() const { return counts_[kMissing]; }
  double mean() const;                // NaN where there is none
  double standard_deviation() const;  // NaN below two
  double smallest() const { return smallest_; }
  double largest() const { return largest_; }
  // Values in [from, to), both on edges of bins. The missing are in none.
  std::int64_t count_between(double from, double to) const;
  double share_between(double from, double to) const;  // of all, the missing too
  // p in 0 … 1: the middle of the bin that it falls into.
  double quantile(double p) const;

  double low() const { return low_; }
  std::size_t bins() const { return bins_; }
  std::int64_t in_bin(std::size_t bin) const { return counts_[kFirstBin + bin]; }

 private:
  enum : std::size_t { kMissing, kBelow, kAbove, kSum, kSquaresLow, kSquaresHigh, kFirstBin };

  double low_;
  double width_;
  std::size_t bins_;
  double unit_;  // of what is summed
  std::vector<std::int64_t> counts_;
  double smallest_;
  double largest_;
};

}  // namespace gsbench::campaign
