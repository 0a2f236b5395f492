// The last valid frequencies, for what needs more than the newest one.
#pragma once

#include <cstdint>

#include <outlet/front_end.hpp>

namespace gs::outlet {

constexpr int kHistoryLength = 32;  // a power of two, 0.5 s

struct History {
  float frequency_hz[kHistoryLength] = {};
  std::uint8_t head = 0;      // next place
  std::uint8_t filled = 0;    // entries, up to kHistoryLength
  std::uint8_t unbroken = 0;  // newest entries that follow one another without a gap
};

void push(History& history, float frequency_hz);

// A gap in the measurements: slopes must not reach across it.
void note_gap(History& history);

// Entry `age` reports back; 0 is the newest.
inline float at(const History& history, int age) {
  return history.frequency_hz[(history.head - 1 - age) & (kHistoryLength - 1)];
}

// Below this a course counts as steady.
constexpr float kSteadyHzS = 0.1f;

struct Line {
  float mean_hz = 0.0f;  // of the entries, so the frequency in their middle
  float slope_hz_s = 0.0f;
};

// Least-squares line through `count` >= 2 entries, the newest of them `age` reports back.
Line fit_line(const History& history, int age, int count);

}  // namespace gs::outlet
