#include "faults.hpp"
#include "run_steps.hpp"
#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <link/version_text.hpp>
#include <link/wait_for_outlets.hpp>

namespace gsbench::station {
namespace {

constexpr std::int64_t kBeforeTheRun = -1;

// Of another version's hello, only the first two fields are known.
void note_identity(const gs::wire::Hello& hello, record::OutletRecord& record) {
  record.protocol_version = hello.protocol_version;
  if (hello.protocol_version != gs::wire::kProtocolVersion) {
    return;
  }
  record.board = hello.board;
  record.instance = hello.instance;
  record.firmware = link::version_text(hello.firmware_version);
  record.build = fmt::format("{:08x}", hello.build);
}

void send_settings(const profile::Plan& plan, const profile::Outlet& planned,
                   const link::OutletPresence& outlet, link::Link& link,
                   record::OutletRecord& record) {
  const gs::wire::Hello& hello = outlet.hello;
  if (hello.sample_rate_hz != plan.stimulus.sample_rate_hz ||
      hello.nominal_hz != static_cast<std::int32_t>(std::lround(plan.grid.nominal_hz))) {
    note(record, "samples at " + std::to_string(hello.sample_rate_hz) + " Hz for " +
                     std::to_string(hello.nominal_hz) + " Hz mains; the profile requires " +
                     std::to_string(plan.stimulus.sample_rate_hz) + " Hz and " +
                     std::to_string(std::lround(plan.grid.nominal_hz)) + " Hz");
    return;
  }
  record.took_part = true;
  // An outlet rejects settings with an older version than its own.
  gs::wire::Downlink message;
  message.kind = gs::wire::DownlinkKind::kSettings;
  message.settings = control_centre::outlet_settings(
      plan.grid, planned.settings, gs::outlet::next_version(hello.settings_version));
  record.settings = control_centre::described(message.settings);
  record.settings["tracker_delay_s"] = static_cast<double>(hello.tracker_delay_s);
  record.settings["voltage_delay_s"] = static_cast<double>(hello.voltage_delay_s);
  const auto send = [&] {
    record.reports.sent.push_back(sent(message, kBeforeTheRun));
    require(link.send(outlet.id, message));
  };
  send();
  message.kind = gs::wire::DownlinkKind::kAskSelfTest;
  send();
}

// Waits for the outlets of all slots that have a link. Keeps the order of the slots.
std::vector<link::OutletPresence> present_outlets(const std::vector<Slot>& slots, Station& station,
                                                  Boot& boot) {
  std::vector<std::string> named;
  for (const Slot& slot : slots) {
    if (slot.link_id) {
      named.push_back(*slot.link_id);
    }
  }
  auto present = link::wait_on_open_link(station.link(), named, station.answers_within(), {},
                                         [&boot](std::size_t joined) { return boot.hold(joined); });
  return require(station.source(), std::move(present));
}

// " within 30 s", for an outlet that did not join.
std::string waited(const link::OutletPresence& outlet, const Station& station) {
  const double waited_s = std::chrono::duration<double>(station.answers_within()).count();
  return outlet.where.empty() && waited_s > 0.0 ? fmt::format(" (waited {:.3g} s for it)", waited_s)
                                                : "";
}

bool is_another_than_required(const link::OutletPresence& outlet, const Slot& slot) {
  return slot.requires_serial_number && outlet.fault.empty() && outlet.id != slot.serial_number;
}

// An outlet may report what is the name of another slot, whose own outlet did not answer or has no
// link. Then the latter is named with its place: a record has each id once.
void make_unique(const std::vector<Slot>& slots, std::vector<record::OutletRecord>& records) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    const bool is_shared =
        std::count_if(records.begin(), records.end(), [&](const record::OutletRecord& other) {
          return other.id == records[i].id;
        }) > 1;
    if (is_shared && (records[i].link.empty() || !records[i].took_part)) {
      records[i].id += " at " + slots[i].place;
    }
  }
}

}  // namespace

std::vector<Slot> assign(const std::vector<profile::Outlet>& outlets,
                         const std::vector<Slot>& slots) {
  const auto is_named = [&](const Slot& slot) {
    return std::any_of(outlets.begin(), outlets.end(), [&](const profile::Outlet& outlet) {
      return outlet.id == slot.serial_number;
    });
  };
  std::vector<Slot> assigned;
  auto free = slots.begin();
  for (const profile::Outlet& outlet : outlets) {
    const auto own = std::find_if(slots.begin(), slots.end(), [&](const Slot& slot) {
      return slot.serial_number == outlet.id;
    });
    free = std::find_if_not(free, slots.end(), is_named);
    if (own != slots.end()) {
      assigned.push_back(*own);
    } else if (free != slots.end()) {
      assigned.push_back(*free++);
    }
  }
  return assigned;
}

std::vector<record::OutletRecord> claim(const profile::Plan& plan, const std::vector<Slot>& slots,
                                        Station& station, Boot& boot) {
  if (slots.size() < plan.outlets.size()) {
    throw BenchFault("the profile needs " + std::to_string(plan.outlets.size()) +
                     " outlets; the station has " + std::to_string(slots.size()));
  }
  const std::vector<link::OutletPresence> present = present_outlets(slots, station, boot);
  auto next = present.begin();
  std::vector<record::OutletRecord> records;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    record::OutletRecord& record = records.emplace_back();
    record.id = slots[i].serial_number;
    record.group = plan.outlets[i].group;
    record.relay_sensed = slots[i].relay_channel.has_value();
    if (!slots[i].link_id) {
      record.took_part = true;
      continue;
    }
    const link::OutletPresence& outlet = *next++;
    record.link = outlet.where.empty() ? slots[i].place : outlet.where;
    boot.keep_up(slots.size());
    if (is_another_than_required(outlet, slots[i])) {
      note(record,
           fmt::format("is not at its place: the station names serial_number \"{}\" for {}, "
                       "the outlet there reports \"{}\"",
                       slots[i].serial_number, slots[i].place, outlet.id));
      continue;
    }
    if (!outlet.where.empty()) {
      record.id = outlet.id;
      note_identity(outlet.hello, record);
    }
    if (outlet.fault.empty()) {
      send_settings(plan, plan.outlets[i], outlet, station.link(), record);
    } else {
      note(record, outlet.fault + waited(outlet, station));
    }
  }
  make_unique(slots, records);
  return records;
}

}  // namespace gsbench::station
