// A station: the drivers that a run uses and their properties.
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

// The place of one outlet and its connections to the bench.
struct Slot {
  std::string place;                         // for messages
  std::string serial_number;                 // of the outlet at this place
  std::optional<std::string> link_id;        // none: the outlet has only its contact
  std::optional<std::size_t> relay_channel;  // of the relay sense; none: contact not sensed
  std::string relay_name = {};               // of the channel, for messages: "/dev/ttyUSB0 CTS"
  // An outlet here that reports another serial number is at fault. False: any outlet may be here.
  bool requires_serial_number = false;
};

class Station {
 public:
  virtual ~Station() = default;
  virtual std::string name() const = 0;
  virtual source::Source& source() = 0;
  virtual link::Link& link() = 0;
  virtual relay::RelaySense& relay_sense() = 0;
  virtual std::vector<Slot> slots() const = 0;
  // How long a run waits, at nominal voltage, for its outlets to boot and join; 0: they answer at
  // once or not at all. A device without a link, or a source of Kind::kLoaded, needs all of it.
  virtual std::chrono::milliseconds answers_within() const { return {}; }
  // True if the outlets' sample counts start at 0 with the source's first tick and stay in step
  // with it. If false, marker dips are played before and after the run.
  virtual bool outlets_count_ticks() const = 0;
  // Where the deviations that the source states come from, for reports; empty: it plays exactly.
  virtual std::string source_accuracy() const { return {}; }
  // How the times of the relay sense are aligned with the source's, for reports.
  virtual std::string relay_aligned_by() const { return "counts the source's ticks"; }
  // What only one bench at a time may use, as StationLock takes it.
  virtual std::vector<std::string> ports() const { return {}; }
  // Duration of one block of the signal. Short if the run is in real time, otherwise long.
  virtual double block_s() const = 0;
};

struct SimulatedOptions {
  bool real_time = false;
  std::size_t threads = 1;
  double block_s = 0.0;  // 0: the default; the record does not depend on it
};

// Outlets in this process that run the real firmware.
std::unique_ptr<Station> simulated_station(const profile::Plan& plan,
                                           const SimulatedOptions& options);

}  // namespace gsbench::station
