// Adapters for the suite: a relay sense with two contacts.
#pragma once

#include <cstdint>
#include <memory>

#include <relay/relay_sense.hpp>

namespace gsbench::test {

class RelayRig {
 public:
  virtual ~RelayRig() = default;
  virtual relay::RelaySense& sense() = 0;
  // Changes the coil of a contact now.
  virtual void turn(std::size_t channel, bool closed) = 0;
  virtual void advance(std::int64_t until_tick) = 0;  // advances the source
  // The uncertainty must be below this. 1 ms is a tenth of the operate time to be measured.
  virtual double most_uncertain_ticks() const { return 8.0; }
};

std::unique_ptr<RelayRig> simulated_sense();
std::unique_ptr<RelayRig> emulated_sense();
std::unique_ptr<RelayRig> head_sense();
std::unique_ptr<RelayRig> modem_line_sense();
std::unique_ptr<RelayRig> modem_line_sense_of_a_generator();
std::unique_ptr<RelayRig> terminal_sense();
// Not a driver: a model of a relay sense with its own clock, to test alignment.
std::unique_ptr<RelayRig> counter_sense();

}  // namespace gsbench::test
