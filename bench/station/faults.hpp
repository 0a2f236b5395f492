// What goes wrong in a run. With the bench: the run ends. With one outlet: it is that outlet's
// fault, and the others go on.
#pragma once

#include <stdexcept>
#include <string>

#include <drivers/result.hpp>
#include <record/run_record.hpp>

namespace gsbench::station {

// Never leaves run().
struct BenchFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws BenchFault.
template <class T>
T require(drivers::Result<T> result) {
  if (!result.ok()) {
    throw BenchFault(result.error());
  }
  return result.take();
}

// The first fault of an outlet stands; later ones often follow from it.
inline void note(record::OutletRecord& outlet, const std::string& fault) {
  if (outlet.fault.empty()) {
    outlet.fault = fault;
  }
}

}  // namespace gsbench::station
