// What goes wrong in a run. With the bench: the run ends. With one outlet: it is that outlet's
// fault, and the others go on.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <record/run_record.hpp>
#include <wire/messages.hpp>

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
void require_an_outlet(const std::vector<record::OutletRecord>& outlets);  // one without a fault

// The first fault of an outlet stands; later ones often follow from it.
void note(record::OutletRecord& outlet, const std::string& fault);

// "outlet x does not answer" of the first that has a fault; empty: none has.
std::string first_fault(const std::vector<record::OutletRecord>& outlets);

// Bits of gs::wire::SelfTestPart as words, all but the ADC, which may have had no input yet.
std::string failed_parts(std::uint32_t failed);

// Errors an outlet reports of itself that make its run worthless. That it did not understand the
// bench shows in what it then does not do.
bool spoils_a_run(gs::wire::ErrorCode error);

}  // namespace gsbench::station
