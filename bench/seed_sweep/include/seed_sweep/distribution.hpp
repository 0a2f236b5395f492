// The distribution of one measurement over the outlets and seeds of a study.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace gsbench::seed_sweep {

class Distribution {
 public:
  void add(double value);  // a NaN counts as missing
  void add_word(const std::string& word) { ++words_[word]; }
  void merge(const Distribution& other);
  // Before any of the following, after the last add().
  void sort();

  std::size_t count() const { return values_.size(); }
  std::size_t missing() const { return missing_; }
  const std::map<std::string, std::size_t>& words() const { return words_; }
  // p in 0 … 1, by the nearest rank: a value that occurred. NaN where there is none.
  double quantile(double p) const;
  double mean() const;
  double standard_deviation() const;
  // Share of the values with |value| <= limit, the missing ones counted as outside.
  double share_within(double limit) const;

 private:
  std::vector<double> values_;
  std::size_t missing_ = 0;
  std::map<std::string, std::size_t> words_;
};

}  // namespace gsbench::seed_sweep
