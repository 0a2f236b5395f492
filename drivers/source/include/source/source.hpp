// A source plays the mains voltage: simulated, emulated or an instrument. One source feeds all
// outlets of a run. Used by one thread at a time.
//
// Order of calls: check → prepare → energise → hold … → start → advance … → stop; make_safe at any
// time. The base class checks the order and the limits for all drivers; a driver implements the
// protected functions. All errors are returned.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <source/interrupt.hpp>
#include <source/stimulus.hpp>

namespace gsbench::source {

enum class Kind {
  kStreamed,  // receives samples while playing
  kLoaded,    // receives the whole waveform before playing
  kStepped    // plays a list of steps of frequency and voltage
};

struct Limits {
  std::string name;  // "simulated source", or maker and model; starts each error message
  Kind kind = Kind::kStreamed;
  double full_scale_pu = 0.0;  // largest voltage, per unit of nominal peak
  double longest_s = std::numeric_limits<double>::infinity();  // of a stimulus
  std::vector<std::int64_t> sample_rates_hz;  // supported rates of a stimulus, ascending
  std::vector<int> nominal_hz;
  bool noise_per_outlet = false;   // true: independent noise for each outlet; false: the same
  double nominal_peak_v = 0.0;     // 1 pu at the outlets, for messages; 0: there are no volts
  std::string full_scale_is = {};  // for messages: "the voltage limit"; empty: the hardware's
  // What is known before the start of the uncertainty of host_clock(), ±.
  double host_clock_uncertainty_s = 0.0;
};

// How a stimulus would be played, and the largest deviations of the played voltage from the
// stimulus, without noise. The largest deviation of the voltage is voltage_pu + amplitude_pu: the
// first is that of the planned waveform, by resampling and resolution, and the second comes from
// the amplitude that the instrument sets.
struct Played {
  double frequency_hz = 0.0;  // over windows of 200 ms; includes the error of the source's clock
  double voltage_pu = 0.0;    // of a sample; for kStepped, of the amplitude
  double time_s = 0.0;        // early or late
  std::vector<std::string> how = {};  // for people: "720 000 points at 16 kSa/s", …
  double amplitude_pu = 0.0;  // accuracy of the amplitude, ±, at the stimulus's peak; 0: not stated
};

// The source's ticks on this machine's steady clock: tick n is n · tick_s after tick_0.
struct HostClock {
  std::chrono::steady_clock::time_point tick_0;
  double tick_s = 0.0;
  double uncertainty_s = 0.0;  // of the time of any tick of the stimulus, ±
};

using Progress = std::function<void(double part)>;  // 0 … 1

class Source {
 public:
  virtual ~Source() = default;
  virtual Limits limits() const = 0;

  // Once `*stop` is true, the calls from prepare() to advance() are refused. One of them or stop()
  // that is blocking ends with an error, within 0.1 s and the time of a few commands. make_safe()
  // ignores it. `stop` must live until it is replaced. nullptr, the default: no call is ended.
  void end_calls_if(const std::atomic<bool>* stop) { interrupt_.heed(stop); }
  // Whether the last call failed because of it, and not by a fault.
  bool was_interrupted() const { return interrupt_.noticed(); }

  // Checks whether the stimulus can be played, and how accurately. Does not touch the output.
  // Renders the whole stimulus, which blocks for about 1 s for each 10 min of stimulus.
  drivers::Result<Played> check(const Stimulus& stimulus) const;

  // Refuses what check() refuses, and uploads the stimulus if the source can be loaded. Blocks
  // until the upload is done. A kStreamed source refuses samples beyond full scale only in
  // advance(). `stimulus` must live until make_safe().
  drivers::Result<Played> prepare(const Stimulus& stimulus, const Progress& progress = {});

  // Raises the voltage softly to nominal and keeps it there until start(), so that outlets power
  // up. Blocks until the voltage is nominal, about 1 s.
  drivers::Status energise();

  // Keeps the voltage nominal between energise() and start(), and after the stop() of a kStreamed
  // source. Must be called at least every 50 ms there: a source that hears nothing from the bench
  // switches off. An error if the output is no longer as it was set.
  drivers::Status hold();

  // Starts the stimulus. A kLoaded source, whose waveform includes the time for outlets to boot,
  // blocks until that time is over.
  drivers::Status start();

  // For a relay sense that has this machine's clock. Valid from start() on. nullopt: the source
  // plays in virtual time, or does not know yet.
  virtual std::optional<HostClock> host_clock() const { return std::nullopt; }

  // Plays up to `until_tick` (excluded), which must be after the tick reached and not after the end
  // of the stimulus. Blocks while the source has no room for more. Returns the tick reached: at
  // least `until_tick`; later if the source plays on its own.
  drivers::Result<std::int64_t> advance(std::int64_t until_tick);

  // Stops the stimulus, at its end or earlier. Outlets keep their supply, except from a kLoaded
  // source, whose waveform ends with the output off.
  drivers::Status stop();

  // Output off, verified if the source can be asked. May be called at any time, more than once, and
  // after a failure. An error means that the state of the output is unknown.
  drivers::Status make_safe() noexcept;

 protected:
  // Called only with a stimulus within limits().
  virtual drivers::Result<Played> deviation(const Stimulus& stimulus) const = 0;
  virtual drivers::Status upload(const Progress&) { return drivers::Done{}; }
  virtual drivers::Status power_up() = 0;
  virtual drivers::Status keep_up() { return drivers::Done{}; }
  virtual drivers::Status begin() = 0;
  virtual drivers::Result<std::int64_t> play_until(std::int64_t until_tick) = 0;
  virtual drivers::Status end() { return drivers::Done{}; }
  virtual drivers::Status switch_off() noexcept = 0;

  // What a driver that blocks must ask. It may return any error then.
  Interrupt& interrupt() { return interrupt_; }
  // Valid from prepare() on.
  const Stimulus& stimulus() const { return *stimulus_; }
  // The next tick to play.
  std::int64_t tick() const { return tick_; }
  // Samples of the stimulus, per unit of nominal peak, valid until the next call. They contain the
  // stimulus's noise if limits().noise_per_outlet is false. An error if one is beyond full scale: a
  // source never clips.
  drivers::Result<const float*> samples(std::int64_t first_tick, std::int64_t count);

 private:
  enum class State { kOff, kPrepared, kEnergised, kPlaying, kStopped, kFailed };

  drivers::Result<Played> preview(const Stimulus& stimulus) const;
  drivers::Status expect(const char* call, State needed);
  // The same; also an error if interrupted.
  drivers::Status ready_to(const char* call, State needed);
  // Enters `next`, or kFailed if `answer` is an error; then only make_safe() is allowed.
  drivers::Status enter(State next, drivers::Status answer);

  State state_ = State::kOff;
  const Stimulus* stimulus_ = nullptr;
  Limits limits_;  // from prepare() on
  std::int64_t tick_ = 0;
  std::vector<float> samples_;
  Interrupt interrupt_;
};

}  // namespace gsbench::source
