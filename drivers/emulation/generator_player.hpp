// The output stage of an emulated generator: what its terminals carry at each step.
#pragma once

#include "generator_waveform.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include <emulation/generator.hpp>

namespace gsbench::emulation {

// Settings, as the output stage needs them.
struct Playback {
  bool relay_on = false;
  GeneratorFunction function = GeneratorFunction::kSine;
  std::shared_ptr<const GeneratorWaveform> waveform;  // of kArbitrary; null: 0 V
  Between between = Between::kHold;
  double cycles_per_step = 0;  // steps of true time: with the error of the instrument's clock
  double phase = 0;            // in cycles, 0 … 1
  double duty = 0.5;
  double symmetry = 0.5;
  double centre_v = 0;  // at the terminals
  double half_v = 0;    // at the terminals; of +1; negative: inverted
  bool burst = false;
  double burst_cycles = 1;
  std::int64_t period_steps = 0;  // of bursts that repeat by themselves; 0: by trigger
  std::optional<double> idle;     // between bursts, −1 … 1; none: where a burst starts
};

class GeneratorPlayer {
 public:
  explicit GeneratorPlayer(const TrueTime& time) : time_(time) {}

  // Takes effect at max(end of what is rendered, now). `restart`: plays from the start; in burst
  // mode, waits for a trigger.
  void change(const Playback& playback, bool restart);
  // Starts a burst, unless one is being played.
  void trigger();
  // Ends a burst.
  void abort();

  void render(std::int64_t first_step, std::size_t count, float* volts);

  // When the burst ends that is being played now; now if none is. Does not end: max().
  std::int64_t burst_end() const;
  bool is_playing() const { return burst_end() > time_.now(); }

 private:
  enum class Kind : std::uint8_t { kChange, kRestart, kTrigger, kAbort };
  struct Event {
    std::int64_t step;
    Kind kind;
    Playback playback;  // of kChange and kRestart
  };
  // What is played, from a step on.
  struct Cursor {
    Playback playback;
    std::int64_t origin_step = 0;
    double origin_cycles = 0;
    bool triggered = false;

    double position(std::int64_t step) const;  // in cycles
    bool in_burst(std::int64_t step) const;
    void apply(const Event& event);
    void fill(std::int64_t first_step, std::int64_t end_step, float* volts) const;
  };

  void add(Kind kind, const Playback& playback);

  const TrueTime time_;
  mutable std::mutex mutex_;
  Cursor cursor_;
  std::deque<Event> events_;  // not yet rendered, by step
  std::int64_t rendered_end_ = std::numeric_limits<std::int64_t>::min();  // min(): never rendered
};

}  // namespace gsbench::emulation
