#include "physical_slots.hpp"

#include "port_keys.hpp"
#include "station_kind.hpp"

#include <map>

#include <fmt/format.h>

#include <station/station_lock.hpp>

namespace gsbench::station {
namespace {

constexpr std::size_t kMostSlots = 64;

// Refuses a value that another slot has.
class Uniqueness {
 public:
  explicit Uniqueness(std::string key) : key_(std::move(key)) {}

  void require(const keys::Table& slot, const std::string& value) { require(slot, value, value); }
  // `identity`: the same for two values that mean one thing.
  void require(const keys::Table& slot, const std::string& value, const std::string& identity) {
    const auto [first, is_new] = seen_.emplace(identity, value);
    if (is_new) {
      return;
    }
    slot.refuse(key_,
                first->second == value
                    ? fmt::format("{} is \"{}\" for two outlets; it must be unique", key_, value)
                    : fmt::format("{} is \"{}\" and \"{}\" for two outlets, which are the "
                                  "same; it must be unique",
                                  key_, first->second, value));
  }

 private:
  std::string key_;
  std::map<std::string, std::string> seen_;  // first value of each identity
};

void check_relay(const keys::Table& slot, const RelayKind* relay, const std::string& channel) {
  if (relay == nullptr) {
    slot.refuse("relay", "relay is given, but the station has no relay sense; add [relay]");
  }
  if (!relay->is_channel(channel)) {
    slot.refuse("relay", fmt::format("relay is \"{}\"; for a relay sense of kind \"{}\" it must be "
                                     "{}",
                                     channel, relay->name, relay->channel));
  }
}

}  // namespace

keys::Key slot_keys() {
  std::string forms;
  for (const RelayKind& kind : relay_kinds()) {
    forms += (forms.empty() ? "" : "; ") + kind.channel;
  }
  return keys::tables(
      "outlet",
      "The slots of the station, at most 64: places with one outlet each. An outlet of a profile "
      "gets the slot with its id as `serial_number`, else the next free one. If a profile has more "
      "outlets than the station, each group is reduced.",
      {keys::id("place", kLongestId, "name of the place, as on its label; unique")
           .require("the name of the place, e.g. place = \"socket-1\""),
       keys::id(
           "serial_number", kLongestId,
           "id of the outlet at this place; unique. An outlet on a port that reports another id "
           "is at fault")
           .or_else("`place`; required with `link = \"mqtt\"`"),
       keys::text("link",
                  "connection of the outlet: its port, or `mqtt`: by its serial number at the "
                  "broker of `[mqtt]`")
           .permits("device path, `tcp://host:port` or `mqtt`")
           .or_else("none: a contact-only device, tested by its contact alone"),
       keys::text("relay", "channel of the relay sense that sees the contact of the outlet")
           .permits(forms)
           .or_else("none: contact not sensed; required without `link`")});
}

std::vector<PhysicalSlot> read_slots(const keys::Table& top, const RelayKind* relay,
                                     const std::string& source_port) {
  std::vector<PhysicalSlot> slots;
  Uniqueness places("place");
  Uniqueness serial_numbers("serial_number");
  Uniqueness links("link");
  Uniqueness channels("relay");
  for (const keys::Table& table : top.tables("outlet")) {
    PhysicalSlot slot;
    slot.place = table.text("place");
    slot.serial_number = table.find_text("serial_number").value_or(slot.place);
    slot.has_serial_number = table.has("serial_number");
    slot.link = table.find_text("link").value_or("");
    slot.relay = table.find_text("relay").value_or("");
    places.require(table, slot.place);
    serial_numbers.require(table, slot.serial_number);
    if (slot.link == kByBroker) {
      if (!slot.has_serial_number) {
        table.refuse_missing("serial_number", "the id of the outlet at the broker");
      }
      if (!top.has("mqtt")) {
        table.refuse("link", "link is \"mqtt\", but the station has no broker; add [mqtt]");
      }
    } else if (!slot.link.empty()) {
      require_port(table, "link");
      if (device_of(slot.link) == device_of(source_port)) {
        table.refuse("link", fmt::format("link is \"{}\", which is the port of the source; an "
                                         "outlet needs a port of its own",
                                         slot.link));
      }
      links.require(table, slot.link, device_of(slot.link));
    }
    if (!slot.relay.empty()) {
      check_relay(table, relay, slot.relay);
      channels.require(table, slot.relay, relay->identity(slot.relay));
    }
    if (slot.link.empty() && slot.relay.empty()) {
      table.refuse_missing("relay",
                           "the channel that senses its contact, or its link: without both, "
                           "nothing can be measured");
    }
    slots.push_back(slot);
  }
  if (slots.size() > kMostSlots) {
    top.refuse("outlet",
               fmt::format("{} outlets; at most {} are possible", slots.size(), kMostSlots));
  }
  return slots;
}

}  // namespace gsbench::station
