// Sources with an outlet at each: what the suite needs beside their interface.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <source/source.hpp>

namespace gsbench::test {

struct Reading {
  std::int64_t tick;  // of the stimulus: of the voltage that it is a measurement of
  double frequency_hz;
  double voltage_pu;
};

class SourceRig {
 public:
  virtual ~SourceRig() = default;
  virtual source::Source& source() = 0;
  // Of the firmware, since the first start.
  virtual std::vector<Reading> readings() = 0;
};

std::unique_ptr<SourceRig> simulated_source();
std::unique_ptr<SourceRig> emulated_mains();
// No drivers, but the other two kinds that the interface is for.
std::unique_ptr<SourceRig> loaded_source();
std::unique_ptr<SourceRig> stepped_source();

}  // namespace gsbench::test
