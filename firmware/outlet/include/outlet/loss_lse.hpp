// Least-squares estimate (LSE), eq. (18) and (19): the slope of a line through the first
// measurements after the event. The first estimate of the lost power follows from this slope.
#pragma once

#include <outlet/front_end.hpp>

namespace gs::outlet {

constexpr int kMaxLseSamples = 64;

template <class Real>
struct LseState {
  int count = 0;
  Real sum{};           // of f − f_0
  Real weighted_sum{};  // of k·(f − f_0), k = 0 … n−1
};

template <class Real>
void add(LseState<Real>& s, Real deviation_hz) {
  s.sum = s.sum + deviation_hz;
  s.weighted_sum = s.weighted_sum + deviation_hz * static_cast<float>(s.count);
  ++s.count;
}

// Least-squares slope g(t_0), Hz/s, of at least two measurements at intervals of 16 ms.
template <class Real>
Real slope_hz_s(const LseState<Real>& s) {
  const float n = static_cast<float>(s.count);
  const float mean_k = 0.5f * (n - 1.0f);
  // Σ (k − mean)² = n·(n² − 1)/12.
  const float squares = n * (n * n - 1.0f) / 12.0f;
  return (s.weighted_sum - s.sum * mean_k) * (1.0f / (squares * kReport_s));
}

}  // namespace gs::outlet
