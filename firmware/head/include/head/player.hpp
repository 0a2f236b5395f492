// Plays the stream: state, buffer, watchdog and the codes for the DAC. protocol.md describes them.
//
// The main loop calls arm, put, play, feed and switch_off; the interrupt of the DAC calls
// next_codes and fail. The main loop changes the state only from kOff or to kOff. So it never
// undoes a change by an interrupt, except by switching off.
#pragma once

#include <cstddef>
#include <cstdint>

#include <queues/queues.hpp>

#include <head/interpolator.hpp>
#include <head/messages.hpp>

namespace gs::head {

constexpr std::uint32_t kWatchdogCodes = kCodeRate_hz / 1000 * kWatchdog_ms;

class Player {
 public:
  // ---- main loop

  State state() const { return state_; }
  Fault fault() const { return fault_; }
  void feed() { fed_ = true; }  // restarts the watchdog
  void switch_off();
  // Only if off.
  void arm();
  std::size_t room() const { return samples_.room(); }
  // Only as many as there is room for.
  void put(const std::int16_t* samples, std::size_t count) { samples_.put(samples, count); }
  // Begins with the first call of next_codes() that finds this many samples, at least 1.
  void play(std::uint16_t prefill) { prefill_ = prefill; }
  // Forgets the stream. Only if off.
  void forget();

  // Samples given to the DAC.
  std::uint64_t position() const;
  bool has_begun() const { return has_begun_; }
  // When sample 0 was at the output. Only if the stream has begun.
  std::uint64_t begin_count() const { return begin_count_; }
  // Codes made since start-up, modulo 2^32.
  std::uint32_t codes() const { return codes_; }
  // Changes whenever next_codes() or fail() changes the state.
  std::uint32_t changes() const { return changes_; }
  std::uint32_t underruns() const { return underruns_; }
  std::uint32_t watchdog_trips() const { return watchdog_trips_; }

  // ---- interrupt

  // `first_count`: when the first of the codes will be at the output.
  void next_codes(std::uint64_t first_count, std::uint16_t* out, std::size_t count);
  // Without effect unless armed or playing.
  void fail(Fault fault);

 private:
  bool is_active() const { return state_ == State::kArmed || state_ == State::kPlaying; }
  void begin(std::uint64_t count);
  void watch();
  std::uint16_t next_code();
  void enter(State state);

  queues::Ring<std::int16_t, kBufferSamples> samples_;
  Interpolator interpolator_;
  std::uint32_t silent_codes_ = 0;  // since the watchdog was last fed

  volatile State state_ = State::kOff;
  volatile Fault fault_ = Fault::kNone;
  volatile bool fed_ = false;
  volatile bool has_begun_ = false;
  volatile std::uint16_t prefill_ = 0;  // 0: not to be played
  volatile std::uint64_t position_ = 0;
  volatile std::uint64_t begin_count_ = 0;  // written before has_begun_
  volatile std::uint32_t codes_ = 0;
  volatile std::uint32_t changes_ = 0;
  volatile std::uint32_t underruns_ = 0;
  volatile std::uint32_t watchdog_trips_ = 0;
};

}  // namespace gs::head
