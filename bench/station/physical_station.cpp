#include "physical_station.hpp"

#include "outlet_links.hpp"
#include "physical_slots.hpp"
#include "port_keys.hpp"
#include "station_kind.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::station {
namespace {

class NoRelaySense final : public relay::RelaySense {
 public:
  relay::Alignment alignment() const override { return {}; }
  drivers::Status poll(std::vector<relay::Edge>&) override { return drivers::Done{}; }
};

// The content of a station file with [source].
struct Wiring {
  std::string name;
  std::string port;  // of the source
  SourceFactory make_source;
  SourceSettings source;
  const RelayKind* relay = nullptr;
  std::vector<PhysicalSlot> slots;
  PhysicalOutlets links;
};

std::unique_ptr<Station> make_physical_station(const Wiring& wiring, const profile::Plan& plan) {
  PhysicalParts parts;
  parts.name = wiring.name;
  parts.boot_s = wiring.source.boot_s;
  parts.make_link = [links = wiring.links] { return make_link(links); };
  parts.ports = {wiring.port};
  SourceSettings settings = wiring.source;
  settings.tolerances = plan.stimulus.tolerances;
  parts.source = wiring.make_source(wiring.port, settings);
  parts.source.sample_rate_hz = plan.stimulus.sample_rate_hz;
  std::vector<std::string> channels;
  for (const PhysicalSlot& slot : wiring.slots) {
    Slot& made = parts.slots.emplace_back();
    made.place = slot.place;
    made.serial_number = slot.serial_number;
    made.requires_serial_number = slot.has_serial_number;
    if (!slot.link.empty()) {
      made.link_id = slot.link == kByBroker ? slot.serial_number : slot.link;
    }
    if (!slot.relay.empty()) {
      channels.push_back(slot.relay);
    }
  }
  std::size_t channel = 0;
  for (std::size_t i = 0; i < wiring.slots.size(); ++i) {
    if (!wiring.slots[i].relay.empty()) {
      parts.slots[i].relay_name = wiring.slots[i].relay;
      parts.slots[i].relay_channel = wiring.relay->number_of(channels, channel++);
    }
  }
  if (!channels.empty()) {
    parts.relay_sense = wiring.relay->make(channels, parts.source);
    parts.relay_aligned_by = wiring.relay->aligned_by;
  }
  for (const std::string& used : channels) {
    parts.ports.push_back(wiring.relay->port_of(used));
  }
  parts.ports.insert(parts.ports.end(), wiring.links.serial.ports.begin(),
                     wiring.links.serial.ports.end());
  for (const std::string& outlet : wiring.links.mqtt.outlets) {
    parts.ports.push_back(fmt::format("{}/{}", wiring.links.mqtt.url, outlet));
  }
  return std::make_unique<PhysicalStation>(std::move(parts));
}

// The links of [[outlet]] complete those of [serial] and [mqtt].
void add_links(const keys::Table& top, const std::vector<PhysicalSlot>& slots,
               PhysicalOutlets& links) {
  if (top.has("serial") && top.table("serial").has("ports")) {
    top.table("serial").refuse(
        "ports", "ports is given beside [[outlet]]; give each port as the link of its [[outlet]]");
  }
  if (!links.mqtt.outlets.empty()) {
    top.table("mqtt").refuse(
        "outlets",
        "outlets is given beside [[outlet]]; give each as an [[outlet]] with link = \"mqtt\"");
  }
  for (const PhysicalSlot& slot : slots) {
    if (slot.link == kByBroker) {
      links.mqtt.outlets.push_back(slot.serial_number);
    } else if (!slot.link.empty()) {
      links.serial.ports.push_back(slot.link);
    }
  }
  if (links.mqtt.outlets.empty()) {
    links.mqtt = {};  // a broker that no slot uses is not connected to
    links.ca_file_at.clear();
    links.password_file.clear();
  }
}

const RelayKind* read_relay(const keys::Table& top, const std::string& source_kind) {
  if (!top.has("relay")) {
    return nullptr;
  }
  const keys::Table table = top.table("relay");
  const RelayKind& kind = read_relay_kind(table);
  if (!kind.of_source.empty() && kind.of_source != source_kind) {
    table.refuse("kind", fmt::format("kind is \"{}\", which needs a source of kind \"{}\"",
                                     kind.name, kind.of_source));
  }
  return &kind;
}

void read_physical(const keys::Table& top, StationFile& file) {
  PhysicalOutlets links = read_links(top, file.path);
  std::string source_kind;
  Wiring wiring;
  wiring.name = file.name;
  if (top.has("source")) {
    const keys::Table source = top.table("source");
    source_kind = source.text("kind");
    require_port(source, "port");
    wiring.port = source.text("port");
    wiring.source = read_source_settings(source);
    wiring.make_source = read_source_factory(source, file.path);
  }
  wiring.relay = read_relay(top, source_kind);
  wiring.slots = read_slots(top, wiring.relay, wiring.port);
  if (!wiring.slots.empty()) {
    add_links(top, wiring.slots, links);
    file.outlets = wiring.slots.size();
  } else if (top.has("source")) {
    top.refuse_missing("outlet", "at least one [[outlet]], a place with an outlet");
  } else if (links.serial.ports.empty() && links.mqtt.url.empty()) {
    if (top.has("serial")) {
      top.table("serial").refuse_missing("ports", "the ports, e.g. ports = [\"/dev/ttyUSB0\"]");
    }
    top.refuse_missing("outlet",
                       "the outlets: [[outlet]], or only their links, [serial] or [mqtt]");
  }
  if (!links.serial.ports.empty() || !links.mqtt.url.empty()) {
    file.reachable = links;
  }
  wiring.links = std::move(links);
  if (!top.has("source")) {
    file.make_station = [path = file.path](const profile::Plan&,
                                           const SimulatedOptions&) -> std::unique_ptr<Station> {
      throw profile::ConfigurationError(
          path +
          ": this station has no source, so nothing can be played to its outlets; add [source] "
          "and [[outlet]]. Without them only `gsbench devices` and `gsbench monitor` work on it");
    };
    return;
  }
  file.source_port = wiring.port;
  file.make_source = [wiring] {
    SourceSettings settings = wiring.source;
    settings.make_safe_s = 0.0;
    return wiring.make_source(wiring.port, settings).source;
  };
  file.make_station = [wiring](const profile::Plan& plan, const SimulatedOptions&) {
    return make_physical_station(wiring, plan);
  };
}

std::vector<keys::Key> physical_keys() {
  std::vector<keys::Key> source = source_keys();
  source.insert(source.begin() + 1,
                keys::text("port", "port of the source")
                    .permits("`tcp://host:port` or a device path")
                    .require("the port of the source, e.g. port = \"tcp://192.168.1.5:5025\""));
  std::vector<keys::Key> all = {
      keys::table("source",
                  "The source: the instrument that plays the mains voltage. Without it, `run` "
                  "refuses the station.",
                  source),
      keys::table("relay", "The relay sense: the input that sees the contacts of the outlets.",
                  relay_keys()),
      slot_keys()};
  for (keys::Key& key : link_keys()) {
    all.push_back(std::move(key));
  }
  return all;
}

}  // namespace

StationKind physical_kind() {
  return {"physical", "existing outlets that the bench connects to", physical_keys(),
          read_physical};
}

PhysicalStation::PhysicalStation(PhysicalParts parts) : parts_(std::move(parts)) {
  if (parts_.relay_sense == nullptr) {
    parts_.relay_sense = std::make_shared<NoRelaySense>();
  }
}

link::Link& PhysicalStation::link() {
  if (link_ == nullptr) {
    link_ = parts_.make_link();
  }
  return *link_;
}

std::chrono::milliseconds PhysicalStation::answers_within() const {
  return std::chrono::milliseconds(std::llround(1e3 * parts_.boot_s));
}

}  // namespace gsbench::station
