// Adapters for the conformance suite of drivers of instruments: an emulated instrument with faults,
// and sources that drive it. A driver joins with a rig and a line in conformance_test.cpp.
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

class InstrumentRig {
 public:
  virtual ~InstrumentRig() = default;
  // Another source for the same instrument, as of another bench process. Its time for outlets to
  // boot is 0, and make_safe() tries for about a second.
  virtual std::unique_ptr<source::Source> make_source() = 0;

  virtual bool output_is_on() = 0;
  virtual std::size_t commands() = 0;  // received so far
  virtual void set_answers(Answers answers) = 0;
  // The connection is lost instead of the n-th command from now on (1: the next); it can be opened
  // again at once.
  virtual void lose_connection_at(int command) = 0;
  virtual void unplug() = 0;
  virtual void plug_in() = 0;
  // Cuts the power and switches on again. Does not wait.
  virtual void reset(std::chrono::milliseconds starting_up) = 0;
  // Answers as another model from now on.
  virtual void become_another_model() = 0;
};

// Makes all calls of a run in their order. Returns the first error, or nothing. `before`: called
// before each of them with its name: "prepare", "energise", "hold", "start", "advance", "stop".
std::string first_error_of_run(source::Source& source, const source::Stimulus& stimulus,
                               const std::function<void(const std::string&)>& before = {});

std::unique_ptr<InstrumentRig> sdg1032x();
std::unique_ptr<InstrumentRig> sdg2042x();
std::unique_ptr<InstrumentRig> dg1062z();
std::unique_ptr<InstrumentRig> k33522b();

}  // namespace gsbench::test
