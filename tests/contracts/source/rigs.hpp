// Adapters for the suite: a source with one outlet.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <source/source.hpp>

namespace gsbench::test {

struct Reading {
  std::int64_t tick;  // of the stimulus, corrected for the outlet's delay
  double frequency_hz;
  double voltage_pu;
};

class SourceRig {
 public:
  virtual ~SourceRig() = default;
  virtual source::Source& source() = 0;
  // The firmware's measurements since the first start.
  virtual std::vector<Reading> readings() = 0;
};

std::unique_ptr<SourceRig> simulated_source();
std::unique_ptr<SourceRig> emulated_mains();
std::unique_ptr<SourceRig> head_source();
std::unique_ptr<SourceRig> scpi_source();
// Not drivers: models of the other two kinds of source.
std::unique_ptr<SourceRig> loaded_source();
std::unique_ptr<SourceRig> stepped_source();

}  // namespace gsbench::test
