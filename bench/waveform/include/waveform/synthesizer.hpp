// Voltage samples of a signal, sample n a pure function of n: however a run is cut into blocks, and
// on however many threads, the samples are the same to the last bit.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <waveform/truth.hpp>

namespace gsbench::waveform {

struct Harmonic {
  int order;              // 2 … 50
  double amplitude_pct;   // of the fundamental's amplitude
  double phase_deg;       // at the fundamental's zero phase
};

// From at_s on, the amplitude is `level_pct` of what it was, for duration_s (infinity: to the end).
// Several at once multiply. 0 % is an interruption.
struct AmplitudeStep {
  double at_s;
  double duration_s;
  double level_pct;
};

struct PhaseJump {
  double at_s;
  double degrees;
};

struct SignalSpec {
  std::vector<Harmonic> harmonics;
  std::vector<AmplitudeStep> amplitude_steps;
  std::vector<PhaseJump> phase_jumps;
  double dc_offset_pct = 0.0;     // of the nominal amplitude (peak)
  double initial_phase_deg = 0.0;
};

class Synthesizer {
 public:
  // sample_rate_hz: a whole multiple of 1000, so that 1 ms and 16 ms are whole numbers of samples.
  // Throws std::invalid_argument otherwise, or where a spec value is out of range or not finite.
  Synthesizer(std::shared_ptr<const Truth> truth, SignalSpec spec, std::int64_t sample_rate_hz);
  ~Synthesizer();

  // Samples first_tick … first_tick+count−1 into out, per unit of the nominal amplitude (peak).
  // Noise is not added here: each source adds it (drivers/source), since a source may have a
  // channel for each outlet. Thread-safe: const and without shared mutable state.
  void render(std::int64_t first_tick, std::size_t count, float* out) const;

  std::int64_t sample_rate_hz() const;
  const Truth& truth() const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace gsbench::waveform
