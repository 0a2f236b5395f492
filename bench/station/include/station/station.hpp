// A station: the drivers a run uses, and what they can get wrong.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <profile/plan.hpp>
#include <relay/relay_sense.hpp>
#include <source/source.hpp>

namespace gsbench::station {

// Where an outlet is, and what the bench can reach of it.
struct Slot {
  std::string place;                         // for people
  std::string serial_number;                 // of the outlet in it
  std::optional<std::string> link_id;        // none: it offers nothing but its contact
  std::optional<std::size_t> relay_channel;  // of the station's relay sense; none: not watched
};

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
