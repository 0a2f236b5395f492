// Front end: ADC samples in, one complex phasor every 16 ms out.
//
// Samples are mixed with a table of the nominal frequency and summed over 1 ms. The sums are
// integers and therefore exact. A linear-phase filter over 56 sums then selects the fundamental.
// Attenuation on a 50 Hz grid, for any frequency of 45 … 55 Hz:
//   image at twice the nominal frequency (85 … 125 Hz away)       73 dB
//   second harmonic and DC offset (40 … 60 Hz away)               43 dB
//   aliases: 1 kHz, 2 kHz, … away from nominal, ± 40 Hz           39 dB
//   21st harmonic of 50 Hz, an alias                              60 dB
//   everything else                                               51 dB
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::outlet {

constexpr int kSubsumsPerReport = 16;  // of 1 ms
constexpr int kReport_ms = 16;
constexpr float kReport_s = kReport_ms / 1000.0f;
constexpr int kFilterLength = 56;
// A phasor belongs to the middle of the filter: this long before the report.
constexpr int kFrontEndDelay_ms = kFilterLength / 2;
constexpr float kFrontEndDelay_s = kFrontEndDelay_ms / 1000.0f;
// Voltage is measured over 50 ms: five half periods of 50 Hz, six of 60 Hz.
constexpr int kVoltageWindow_ms = 50;
constexpr float kVoltageDelay_s = 0.025f;

constexpr std::int32_t kMaxSampleRate_hz = 32000;
constexpr std::size_t kMaxTable = 1600;  // kMaxSampleRate_hz / gcd(kMaxSampleRate_hz, 60)
constexpr std::size_t kHalfTable = kMaxTable / 2 + 1;

// The board's properties, fixed at start-up.
struct Hardware {
  std::int32_t sample_rate_hz = 8000;  // whole multiple of 1000, up to kMaxSampleRate_hz
  std::int32_t nominal_hz = 50;        // 50 or 60
  float counts_per_pu = 21845.0f;      // ADC counts at the nominal amplitude (peak)
  // False: the sample clock does not come from the crystal. A clock error of 1 % makes healthy
  // mains look as if their frequency were below f^B, at which the outlet switches off. Without a
  // crystal the outlet therefore measures no frequency and only obeys commands.
  bool has_crystal = true;
};

struct FrontEndConfig {
  std::uint16_t samples_per_ms = 0;
  std::uint16_t table_length = 0;  // samples until the nominal phase repeats
  float pu_per_count = 0.0f;
  // × 16384, for the first half of the period; the second half mirrors it.
  std::int16_t cosine[kHalfTable] = {};
  std::int16_t sine[kHalfTable] = {};
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
  float voltage_pu = 0.0f;  // RMS of the whole voltage, per unit of the nominal RMS
  bool complete = false;    // the filter is full
};

// Returns false if the hardware is not supported: sample rate, nominal frequency or scale.
bool make_front_end(const Hardware& hardware, FrontEndConfig& config);

// Takes up to `count` samples, but none beyond the end of the current report. Returns the number
// taken. Sets `ready` when the report is due: read it with phasor().
std::size_t feed(const FrontEndConfig& config, FrontEndState& state, const std::int16_t* samples,
                 std::size_t count, bool& ready);

Phasor phasor(const FrontEndState& state);

}  // namespace gs::outlet
