#include <outlet/history.hpp>
#include <outlet/loss_lse.hpp>

namespace gs::outlet {

void push(History& history, float frequency_hz) {
  history.frequency_hz[history.head] = frequency_hz;
  history.head = static_cast<std::uint8_t>((history.head + 1) & (kHistoryLength - 1));
  if (history.filled < kHistoryLength) {
    ++history.filled;
  }
  if (history.unbroken < kHistoryLength) {
    ++history.unbroken;
  }
}

void note_gap(History& history) {
  history.unbroken = 0;
}

Line fit_line(const History& history, int age, int count) {
  // Against the oldest entry, so that the sums keep the last millihertz of a float.
  const float origin = at(history, age + count - 1);
  LseState<float> sums;
  for (int k = count - 1; k >= 0; --k) {
    add(sums, at(history, age + k) - origin);
  }
  return {origin + sums.sum / static_cast<float>(count), slope_hz_s(sums)};
}

}  // namespace gs::outlet
