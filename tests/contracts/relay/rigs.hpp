// Relay senses at two contacts each: what the suite needs beside their interface.
#pragma once

#include <cstdint>
#include <memory>

#include <relay/relay_sense.hpp>

namespace gsbench::test {

class RelayRig {
 public:
  virtual ~RelayRig() = default;
  virtual relay::RelaySense& sense() = 0;
  // The coil of a contact changes now.
  virtual void turn(std::size_t channel, bool closed) = 0;
  virtual void advance(std::int64_t until_tick) = 0;  // of the source
};

std::unique_ptr<RelayRig> simulated_sense();
std::unique_ptr<RelayRig> emulated_sense();
// No driver, but one whose clock is its own: a counter that runs before the source does.
std::unique_ptr<RelayRig> counter_sense();

}  // namespace gsbench::test
