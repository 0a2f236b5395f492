// Ring of the newest valid frequencies, and least-squares lines through them.
#pragma once

#include <cstdint>

#include <outlet/loss_lse.hpp>

namespace gs::outlet {

constexpr int kHistoryLength = 32;  // a power of two, 0.5 s

struct History {
  float frequency_hz[kHistoryLength] = {};
  std::uint8_t head = 0;      // next place
  std::uint8_t filled = 0;    // entries, up to kHistoryLength
  std::uint8_t unbroken = 0;  // newest entries that follow one another without a gap
};

inline void push(History& history, float frequency_hz) {
  history.frequency_hz[history.head] = frequency_hz;
  history.head = static_cast<std::uint8_t>((history.head + 1) & (kHistoryLength - 1));
  if (history.filled < kHistoryLength) {
    ++history.filled;
  }
  if (history.unbroken < kHistoryLength) {
    ++history.unbroken;
  }
}

// Records a gap in the measurements. Lines must not be fitted across it.
inline void note_gap(History& history) {
  history.unbroken = 0;
}

// Entry `age` reports back; 0 is the newest.
inline float at(const History& history, int age) {
  return history.frequency_hz[(history.head - 1 - age) & (kHistoryLength - 1)];
}

// A frequency counts as steady while its slope is within ± this.
constexpr float kSteady_hz_s = 0.1f;

template <class Real>
struct LineOf {
  Real mean_hz{};  // mean of the frequencies: the line's value in the middle
  Real slope_hz_s{};
};
using Line = LineOf<float>;

// Least-squares line through `count` >= 2 frequencies of successive reports; `back(n)` returns the
// frequency n reports before the newest. `Real`: float, or a vector of floats with one trajectory
// per lane.
template <class Real, class Back>
LineOf<Real> fit_line(const Back& back, int count) {
  // The sums are of differences from the oldest frequency. Sums of values near 50 Hz would lose
  // millihertz in a float.
  const Real origin = back(count - 1);
  LseState<Real> sums{};
  for (int n = count - 1; n >= 0; --n) {
    add(sums, back(n) - origin);
  }
  return {origin + sums.sum / static_cast<float>(count), slope_hz_s(sums)};
}

// Line through `count` entries of the history, the newest of them `age` reports back.
inline Line fit_line(const History& history, int age, int count) {
  return fit_line<float>([&](int n) { return at(history, age + n); }, count);
}

}  // namespace gs::outlet
