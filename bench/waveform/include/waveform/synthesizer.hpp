// Voltage samples of a signal. Sample n is a pure function of n: the samples are bit-identical for
// any division into blocks and any number of threads.
//
// A step takes effect with the first sample at or after its time. A time within a nanosecond of a
// sample counts as the time of that sample, so that 0.1 s + 0.2 s equals 0.3 s despite rounding.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <waveform/reference_signal.hpp>

namespace gsbench::waveform {

constexpr double kLowestOrder = 0.001;

// The phase of order k is k times that of the fundamental plus phase_deg. The fundamental's phase
// starts at the initial phase and counts all its cycles and phase steps, so that an order that is
// not whole (an interharmonic, a subharmonic) is continuous as well.
struct Harmonic {
  double order;  // at least kLowestOrder, not 1, each at most once, below half of the sample rate
  double amplitude_pct;  // of the fundamental's amplitude; 0 … 100
  double phase_deg;      // of a whole order: at the rising zero crossing of the fundamental
};

// Multiplies the amplitude by `level_pct` from at_s on, for duration_s (infinity: to the end).
// Overlapping steps multiply. 0 % is an interruption. Harmonics are scaled with the fundamental.
struct AmplitudeStep {
  double at_s;        // >= 0
  double duration_s;  // > 0
  double level_pct;   // 0 … 1000
};

// Advances the phase of the fundamental by `degrees` from at_s on, and the phase of harmonic k by k
// times as much.
struct PhaseJump {
  double at_s;  // >= 0
  double degrees;
};

// A stretch of time in which a tone is on: [from_s, to_s) after the tone's at_s.
struct Pulse {
  double from_s;  // >= 0
  double to_s;    // > from_s
};

// Adds a sine of a frequency of its own to the voltage in [at_s, at_s + duration_s) (infinity: to
// the end): mains signalling, an interharmonic, or with another tone the side bands of flicker.
// Amplitude steps, flicker and phase steps do not act on it.
struct Tone {
  double at_s;           // >= 0
  double duration_s;     // > 0
  double frequency_hz;   // > 0, below half of the sample rate
  double amplitude_pct;  // of the nominal peak amplitude; 0 … 100
  double phase_deg;      // at at_s; 0: rising from 0
  // Not empty: the tone is keyed, and is on in these alone. Its phase runs on between them.
  std::vector<Pulse> pulses = {};
};

// Modulates the amplitude in [at_s, at_s + duration_s) (infinity: to the end) by the factor
// 1 + depth/2·w(t), w a sine or a rectangle that begins with 1, both 1 at most. It acts on the
// fundamental and its harmonics; several multiply.
struct Flicker {
  double at_s;          // >= 0
  double duration_s;    // > 0
  double frequency_hz;  // > 0, below half of the sample rate; of two changes
  double depth_pct;     // ΔV/V from the lowest to the highest amplitude; 0 … 100
  bool rectangular;
};

struct SignalSpec {
  std::vector<Harmonic> harmonics;
  std::vector<AmplitudeStep> amplitude_steps;
  std::vector<PhaseJump> phase_jumps;
  std::vector<Tone> tones;
  std::vector<Flicker> flickers;
  double dc_offset_pct = 0.0;  // of the nominal peak amplitude; −100 … 100; not scaled by steps
  double initial_phase_deg = 0.0;
};

class Synthesizer {
 public:
  // sample_rate_hz: a multiple of 1000, at most 1 000 000, so that 1 ms and 16 ms are whole numbers
  // of samples. Throws std::invalid_argument otherwise, and if a value of spec is out of range or
  // not finite, or reference is null.
  Synthesizer(std::shared_ptr<const ReferenceSignal> reference, const SignalSpec& spec,
              std::int64_t sample_rate_hz);

  // Writes samples first_tick … first_tick+count−1 to out, per unit of the nominal peak amplitude.
  // Throws std::invalid_argument if first_tick < 0. Fastest in whole blocks of 16 ms. Noise is not
  // included: each source (drivers/source) adds it, because a source may have a channel for each
  // outlet. Thread-safe: const and without shared mutable state.
  void render(std::int64_t first_tick, std::size_t count, float* out) const;

  // Amplitude of the fundamental, per unit of nominal: recorded voltage times amplitude steps
  // and flicker.
  double amplitude_pu(std::int64_t tick) const;

  std::int64_t sample_rate_hz() const;
  const ReferenceSignal& reference() const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

// The first tick at or after t_s. A time within a nanosecond of a tick counts as that tick. Times
// beyond the range of ticks give the largest tick.
std::int64_t tick_at(double t_s, std::int64_t sample_rate_hz);

}  // namespace gsbench::waveform
