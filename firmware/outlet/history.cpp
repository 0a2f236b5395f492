#include <outlet/history.hpp>

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
  return fit_line<float>([&](int n) { return at(history, age + n); }, count);
}

}  // namespace gs::outlet
