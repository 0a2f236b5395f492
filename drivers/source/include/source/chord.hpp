// How far straight lines between samples are from the curve that the samples belong to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gsbench::source {

// In the middle between two samples of a sine, a line is A·(1 − cos(ω·T/2)) off. With
// u = sin²(ω·T/2), this is A·(1 − √(1 − u)) ≤ A·(u/2 + u²/8 + u³/16 + 5·u⁴/16), and u is −1/4 of
// the second difference of the samples. The polynomial is interpolated to the middles. The result
// is exact at low frequencies, and at most 10 % too large up to 3/8 of the sample rate.
//
// Steps of the voltage have large differences, too, but no curve. They are rare: of seven
// successive periods, the median of the largest values counts.
class ChordMeter {
 public:
  // `period_samples`: of nominal frequency, above 0.
  explicit ChordMeter(std::int64_t period_samples);

  // The next samples.
  void add(const float* voltage, std::size_t count);

  // Largest distance so far, in the unit of the samples. An unfinished period counts only if it is
  // the first one.
  double largest() const { return periods_.empty() ? largest_of_period_ : largest_; }

 private:
  void end_period();

  std::int64_t period_;
  std::int64_t in_period_ = 0;
  std::vector<float> newest_;  // samples
  double largest_of_period_ = 0.0;
  std::vector<double> periods_;  // at most seven
  double largest_ = 0.0;
};

}  // namespace gsbench::source
