// Voltage samples of a signal, sample n a pure function of n: however a run is cut into blocks, and
// on however many threads, the samples are the same to the last bit.
//
// An instant (of a step or a jump) takes effect with the first sample at or after it; one within a
// nanosecond of a sample is at that sample, so that 0.1 s + 0.2 s is 0.3 s.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <waveform/reference_signal.hpp>

namespace gsbench::waveform {

struct Harmonic {
  int order;             // 2 … 50, each at most once, below half of the sample rate
  double amplitude_pct;  // of the fundamental's amplitude; 0 … 100
  double phase_deg;      // at the fundamental's zero phase
};

// From at_s on, the amplitude is `level_pct` of what it was, for duration_s (infinity: to the end).
// Several at once multiply. 0 % is an interruption. Harmonics go with the fundamental.
struct AmplitudeStep {
  double at_s;        // >= 0
  double duration_s;  // > 0
  double level_pct;   // 0 … 1000
};

// From at_s on, the fundamental's phase is that much further on, harmonic k's k times as much.
struct PhaseJump {
  double at_s;  // >= 0
  double degrees;
};

struct SignalSpec {
  std::vector<Harmonic> harmonics;
  std::vector<AmplitudeStep> amplitude_steps;
  std::vector<PhaseJump> phase_jumps;
  double dc_offset_pct = 0.0;  // of the nominal amplitude (peak); −100 … 100, never scaled
  double initial_phase_deg = 0.0;
};

class Synthesizer {
 public:
  // sample_rate_hz: a whole multiple of 1000 up to 1 000 000, so that 1 ms and 16 ms are whole
  // numbers of samples. Throws std::invalid_argument otherwise, or where a spec value is out of
  // range or not finite.
  Synthesizer(std::shared_ptr<const ReferenceSignal> reference, const SignalSpec& spec,
              std::int64_t sample_rate_hz);

  // Samples first_tick … first_tick+count−1 into out, per unit of the nominal amplitude (peak).
  // first_tick >= 0, or std::invalid_argument. Cheapest in whole blocks of 16 ms.
  // Noise is not added here: each source adds it (drivers/source), since a source may have a
  // channel for each outlet. Thread-safe: const and without shared mutable state.
  void render(std::int64_t first_tick, std::size_t count, float* out) const;

  // Of the fundamental, per unit of nominal: the recording's times the amplitude steps.
  double amplitude_pu(std::int64_t tick) const;

  std::int64_t sample_rate_hz() const;
  const ReferenceSignal& reference() const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

// The first tick at or after t_s, an instant within a nanosecond of a sample being at that sample;
// the largest one for times past the end of counting.
std::int64_t tick_at(double t_s, std::int64_t sample_rate_hz);

}  // namespace gsbench::waveform
