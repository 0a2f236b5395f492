// A station: the drivers a run uses, and what they can get wrong.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <relay/relay_sense.hpp>
#include <source/source.hpp>
#include <station/slot.hpp>

namespace gsbench::station {

class Station {
 public:
  virtual ~Station() = default;
  virtual std::string name() const = 0;
  virtual source::Source& source() = 0;
  virtual link::Link& link() = 0;
  virtual relay::RelaySense& relay_sense() = 0;
  virtual std::vector<Slot> slots() const = 0;
  // For so long an outlet that was named is waited for; 0: outlets join at once or not at all.
  virtual std::chrono::milliseconds answers_within() const { return {}; }
  // Without the outlets' clocks: those are measured in each run.
  virtual record::BenchUncertainty uncertainty() = 0;
  // Does an outlet's sample count begin at 0 with the source's first tick, and keep step with it?
  // If not, markers are played around the run.
  virtual bool outlets_count_ticks() const = 0;
  // How much is played at a time: short where the wall clock paces, long where nothing does.
  virtual double block_s() const = 0;
};

struct SimulatedOptions {
  bool real_time = false;
  std::size_t threads = 1;
  double block_s = 0.0;  // 0: what suits the pace; the record does not depend on it
};

// Outlets in this process, with the real firmware.
std::unique_ptr<Station> simulated_station(const profile::Plan& plan,
                                           const SimulatedOptions& options);

}  // namespace gsbench::station
