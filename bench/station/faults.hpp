// Faults in a run. A fault of the bench ends the run. A fault of one outlet is noted in its record,
// and the run continues with the others.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <drivers/result.hpp>
#include <record/run_record.hpp>
#include <source/source.hpp>

namespace gsbench::station {

// Caught in run().
struct BenchFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Thrown when RunOptions::stop ended the run. Caught in run().
struct Stopped {};

// Returns the value. Throws BenchFault if `result` is an error.
template <class T>
T require(drivers::Result<T> result) {
  if (!result.ok()) {
    throw BenchFault(result.error());
  }
  return result.take();
}

// The same for `result` of the last call of `source`. Throws Stopped if the call was interrupted.
template <class T>
T require(const source::Source& source, drivers::Result<T> result) {
  if (!result.ok() && source.was_interrupted()) {
    throw Stopped{};
  }
  return require(std::move(result));
}

// Keeps only the first fault of an outlet, because later faults often follow from it. `fault` is a
// sentence without its subject, the outlet: "refused its settings".
inline void note(record::OutletRecord& outlet, const std::string& fault) {
  if (outlet.fault.empty()) {
    outlet.fault = fault;
  }
}

}  // namespace gsbench::station
