// Adapters for the conformance suite of drivers of instruments: an emulated instrument with faults,
// and sources that drive it. A driver joins with a rig and a line in conformance_test.cpp and
// every_command_test.cpp.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include <source/source.hpp>

namespace gsbench::test {

enum class Answers {
  kNormal,
  kSlow,     // late, but within the driver's patience
  kTooSlow,  // later than that
  kNone,
  kHalf,  // of the next one, then nothing any more
  kGarbage
};

// What differs between drivers.
struct Abilities {
  std::string other_model;    // what prepare() says of one
  std::string too_late;       // what energise() says of answers that come too late
  std::size_t prepare_sends;  // commands, at least
  std::size_t most_ahead;     // commands sent before the answer to the first of them is needed
  bool reconnects;  // a connection lost in prepare() or while playing does not end the run
  bool stop_asks_and_switches_off;        // else stop() leaves the output on, and may miss a fault
  std::chrono::milliseconds starting_up;  // make_safe() waits for an instrument that reboots
};

class InstrumentRig {
 public:
  virtual ~InstrumentRig() = default;
  virtual Abilities abilities() const = 0;
  // Another source for the same instrument, as of another bench process. Its time for outlets to
  // boot is 0, and make_safe() tries for 0.4 s or
  // more.
  virtual std::shared_ptr<source::Source> make_source() = 0;

  virtual bool output_is_on() = 0;
  virtual std::size_t commands() = 0;  // received so far
  virtual void set_answers(Answers answers) = 0;
  // The connection is lost at the n-th command from now on (1: the next), before its answer; it can
  // be opened again at once.
  virtual void lose_connection_at(int command) = 0;
  // Calls `then` when the n-th command from now on arrives (0: never), from a thread of the rig.
  virtual void at_command(int command, std::function<void()> then) = 0;
  virtual void unplug() = 0;
  virtual void plug_in() = 0;
  // Cuts the power and switches on again. Does not wait.
  virtual void reset(std::chrono::milliseconds starting_up) = 0;
  // Answers as another model from now on.
  virtual void become_another_model() = 0;
};

// Makes all calls of a run in their order. Returns the first error, or nothing. `before`: called
// before each of them with its name: "prepare", "energise", "hold", "start", "advance", "stop".
// "advance" comes several times.
std::string first_error_of_run(source::Source& source, const source::Stimulus& stimulus,
                               const std::function<void(const std::string&)>& before = {});

std::unique_ptr<InstrumentRig> sdg1032x();
std::unique_ptr<InstrumentRig> sdg2042x();
std::unique_ptr<InstrumentRig> dg1062z();
std::unique_ptr<InstrumentRig> k33522b();
std::unique_ptr<InstrumentRig> dac_head();
std::unique_ptr<InstrumentRig> serial_sdg2042x();

}  // namespace gsbench::test
