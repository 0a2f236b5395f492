// Distribution of one measure over the outlets and seeds of a study.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace gsbench::seed_sweep {

class Distribution {
 public:
  void add(double value);  // NaN counts as missing
  void add_text(const std::string& value) { ++texts_[value]; }
  void merge(const Distribution& other);
  // To be called after the last add() or merge() and before quantile().
  void sort();

  std::size_t count() const { return values_.size(); }
  std::size_t missing() const { return missing_; }
  // Number of occurrences of each text value.
  const std::map<std::string, std::size_t>& texts() const { return texts_; }
  // Quantile by the nearest-rank method, p in 0 … 1. Quantile and mean are NaN if there are no
  // values. The standard deviation is NaN if there are fewer than two.
  double quantile(double p) const;
  double mean() const;
  double standard_deviation() const;
  // Share of the values with |value| <= limit, 0 … 1. Missing values count as outside.
  double share_within(double limit) const;

 private:
  std::vector<double> values_;
  std::size_t missing_ = 0;
  std::map<std::string, std::size_t> texts_;
};

}  // namespace gsbench::seed_sweep
