// ADC samples → one complex phasor every 16 ms.
//
// Samples are mixed with a table of the nominal frequency and summed over 1 ms in integers, which
// is exact. A linear-phase filter over 56 of these sums then leaves only what is near the
// fundamental: its image at twice the nominal frequency (85 … 125 Hz away) is 73 dB down, the
// second harmonic and an offset (40 … 60 Hz) 43 dB, all else 51 dB, for any frequency of 45 … 55 Hz
// on a 50 Hz grid. The sums fold whole kilohertz back onto the fundamental: what is within 40 Hz of
// one, seen from the nominal frequency, is 39 dB down, and a 21st harmonic 60 dB at 50 Hz.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::outlet {

constexpr int kSubsumsPerReport = 16;  // of 1 ms
constexpr int kReport_ms = 16;
constexpr float kReport_s = kReport_ms / 1000.0f;
constexpr int kFilterLength = 56;
// The phasor is that of the middle of the filter, so much before the report.
constexpr int kFrontEndDelay_ms = kFilterLength / 2;
constexpr float kFrontEndDelay_s = kFrontEndDelay_ms / 1000.0f;
// Voltage is measured over 50 ms: five half periods of 50 Hz, six of 60 Hz.
constexpr int kVoltageWindow_ms = 50;
constexpr float kVoltageDelay_s = 0.025f;

constexpr std::int32_t kMaxSampleRate_hz = 32000;
constexpr std::size_t kMaxTable = 1600;  // kMaxSampleRate_hz / gcd with 60

// What the board is made of; fixed at start-up.
struct Hardware {
  std::int32_t sample_rate_hz = 8000;  // whole multiple of 1000, up to kMaxSampleRate_hz
  std::int32_t nominal_hz = 50;        // 50 or 60
  float counts_per_pu = 21845.0f;      // ADC counts at the nominal amplitude (peak)
  // False: the samples' clock is not the crystal's. At 1 % off, healthy mains look like mains that
  // are below f^B, so that no frequency is measured: the outlet obeys commands alone.
  bool has_crystal = true;
};

struct FrontEndConfig {
  std::uint16_t samples_per_ms = 0;
  std::uint16_t table_length = 0;  // samples until the nominal phase repeats
  float pu_per_count = 0.0f;
  std::int16_t cosine[kMaxTable] = {};  // × 16384
  std::int16_t sine[kMaxTable] = {};
};

struct FrontEndState {
  std::int64_t in_phase = 0;  // sums over the current millisecond
  std::int64_t quadrature = 0;
  std::int64_t squares = 0;
  std::uint16_t table_index = 0;
  std::uint16_t samples_in_ms = 0;
  std::uint8_t subsum = 0;   // millisecond within the report
  std::uint8_t head = 0;     // next place in the rings
  std::uint16_t filled = 0;  // subsums so far, up to kFilterLength
  float ring_in_phase[kFilterLength] = {};
  float ring_quadrature[kFilterLength] = {};
  float ring_squares[kFilterLength] = {};
};

struct Phasor {
  float in_phase = 0.0f;  // per unit of the nominal amplitude, relative to the table
  float quadrature = 0.0f;
  float voltage_pu = 0.0f;  // RMS of everything, per unit of the nominal RMS
  bool complete = false;    // the filter is full
};

// False where the hardware is none this front end can serve.
bool make_front_end(const Hardware& hardware, FrontEndConfig& config);

// Takes samples up to the end of the report in hand, at most `count`; returns how many it took.
// `ready` tells that the report is due: read it with phasor().
std::size_t feed(const FrontEndConfig& config, FrontEndState& state, const std::int16_t* samples,
                 std::size_t count, bool& ready);

Phasor phasor(const FrontEndState& state);

}  // namespace gs::outlet
