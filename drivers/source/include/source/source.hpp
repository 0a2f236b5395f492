// What plays the mains voltage: simulated, or an instrument. One source feeds all outlets of a run.
//
// check → prepare → energise → start → advance … → stop; make_safe at any time. What a call needs
// is checked here, once for all drivers; a driver implements the protected functions.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <source/stimulus.hpp>

namespace gsbench::source {

enum class Kind {
  kStreamed,  // takes samples while it plays
  kLoaded,    // takes the whole waveform before it plays
  kStepped    // plays a list of steps of frequency and voltage
};

struct Limits {
  std::string name;  // "simulated source", or maker and model; errors begin with it
  Kind kind = Kind::kStreamed;
  double full_scale_pu = 0.0;  // largest voltage it can play, per unit of nominal peak
  double longest_s = std::numeric_limits<double>::infinity();
  std::vector<std::int64_t> sample_rates_hz;  // of the stimuli that it takes, ascending
  std::vector<int> nominal_hz;
  bool noise_per_outlet = false;  // each outlet gets noise of its own; else all get the same
};

// By how much what is played is off the stimulus at worst, noise aside.
struct Played {
  double frequency_hz = 0.0;
  double voltage_pu = 0.0;  // of a sample where samples are played, else of the amplitude
  double time_s = 0.0;      // early or late
};

using Progress = std::function<void(double part)>;  // 0 … 1

class Source {
 public:
  virtual ~Source() = default;
  virtual Limits limits() const = 0;

  // What would be played, or why not. Touches no output. Renders the whole stimulus: takes a
  // second for each ten minutes of it, or so.
  drivers::Result<Played> check(const Stimulus& stimulus) const;

  // Refuses what check() refuses, and uploads what can be uploaded before the run. Blocks for so
  // long; a source that streams refuses what is beyond full scale in advance() only.
  // `stimulus` lives until make_safe().
  drivers::Result<Played> prepare(const Stimulus& stimulus, const Progress& progress = {});

  // Nominal voltage: outlets power up. It stays until start().
  drivers::Status energise();

  // The stimulus's tick 0 is now.
  drivers::Status start();

  // Plays up to `until_tick` (excluded), later than what has been played and not after the
  // stimulus's end. Blocks while the source has no room for more. Returns the tick that is really
  // played up to: not before `until_tick`; after it where the source runs on its own.
  drivers::Result<std::int64_t> advance(std::int64_t until_tick);

  // Ends the playing, at the stimulus's end or before it; outlets keep their supply.
  drivers::Status stop();

  // Output off. May be called at any time, more than once, and after a failure.
  drivers::Status make_safe() noexcept;

 protected:
  // For a stimulus within the limits.
  virtual drivers::Result<Played> deviation(const Stimulus& stimulus) const = 0;
  virtual drivers::Status upload(const Progress&) { return drivers::Done{}; }
  virtual drivers::Status power_up() = 0;
  virtual drivers::Status begin() = 0;
  virtual drivers::Result<std::int64_t> play_until(std::int64_t until_tick) = 0;
  virtual drivers::Status end() { return drivers::Done{}; }
  virtual drivers::Status switch_off() noexcept = 0;

  // From prepare() on.
  const Stimulus& stimulus() const { return *stimulus_; }
  // Played up to here (excluded).
  std::int64_t tick() const { return tick_; }
  // Of the stimulus, valid until the next call; an error where one is beyond full scale: a source
  // never clips.
  drivers::Result<const float*> samples(std::int64_t first_tick, std::int64_t count);

 private:
  enum class State { kOff, kPrepared, kEnergised, kPlaying, kStopped, kFailed };

  drivers::Result<Played> preview(const Stimulus& stimulus) const;
  drivers::Status expect(const char* call, State needed) const;
  // The driver's answer; after a failure only make_safe() is left.
  drivers::Status enter(State next, drivers::Status answer);

  State state_ = State::kOff;
  const Stimulus* stimulus_ = nullptr;
  Limits limits_;  // from prepare() on
  std::int64_t tick_ = 0;
  std::vector<float> samples_;
};

}  // namespace gsbench::source
