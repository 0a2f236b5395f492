// The [[outlet]] slots of a physical station.
#pragma once

#include "relay_kind.hpp"

#include <string>
#include <vector>

#include <keys/table.hpp>

namespace gsbench::station {

struct PhysicalSlot {
  std::string place;
  std::string serial_number;  // the place if the file gives none
  bool has_serial_number = false;
  std::string link;   // a port, "mqtt", or empty: a contact-only device
  std::string relay;  // channel of the relay sense; empty: contact not sensed
};

constexpr const char* kByBroker = "mqtt";

keys::Key slot_keys();

// `relay`: of [relay]; null: the station has none. `source_port`: no outlet may have it. Throws
// keys::ConfigurationError.
std::vector<PhysicalSlot> read_slots(const keys::Table& top, const RelayKind* relay,
                                     const std::string& source_port);

}  // namespace gsbench::station
