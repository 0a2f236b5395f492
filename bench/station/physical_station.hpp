// A station of physical outlets: an instrument plays the voltage, and outlets are reached by their
// links, their contacts, or both.
#pragma once

#include "source_kind.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <relay/relay_sense.hpp>
#include <station/station.hpp>

namespace gsbench::station {

struct PhysicalParts {
  std::string name;
  BuiltSource source;
  std::shared_ptr<relay::RelaySense> relay_sense;  // null: no contact is sensed
  std::string relay_aligned_by;
  // Called by the first link(), so that a dry run needs no password file.
  std::function<std::unique_ptr<link::Link>()> make_link;
  std::vector<Slot> slots;
  double boot_s = 0.0;
  std::vector<std::string> ports;  // of the source, the relay sense and the outlets
};

class PhysicalStation final : public Station {
 public:
  explicit PhysicalStation(PhysicalParts parts);

  std::string name() const override { return parts_.name; }
  source::Source& source() override { return *parts_.source.source; }
  // The first call throws keys::ConfigurationError if the password file cannot be read.
  link::Link& link() override;
  relay::RelaySense& relay_sense() override { return *parts_.relay_sense; }
  std::vector<Slot> slots() const override { return parts_.slots; }
  std::chrono::milliseconds answers_within() const override;
  bool outlets_count_ticks() const override { return false; }
  std::string source_accuracy() const override {
    return "not calibrated; from the instrument's table";
  }
  std::string relay_aligned_by() const override { return parts_.relay_aligned_by; }
  std::vector<std::string> ports() const override { return parts_.ports; }
  double block_s() const override { return 0.016; }

 private:
  PhysicalParts parts_;
  std::unique_ptr<link::Link> link_;
};

}  // namespace gsbench::station
