#include "claim.hpp"

#include "faults.hpp"
#include <control_centre/outlet_settings.hpp>

#include <cmath>

#include <link/version_text.hpp>

namespace gsbench::station {
namespace {

record::OutletRecord claim(const profile::Plan& plan, std::size_t i,
                           const link::OutletPresence& present, link::Link& link) {
  const gs::wire::Hello& hello = present.hello;
  record::OutletRecord record;
  record.id = present.id;
  record.group = plan.outlets[i].group;
  record.link = present.where;
  if (!present.fault.empty()) {
    note(record, present.fault);
    return record;
  }
  record.firmware = link::version_text(hello.firmware_version);
  if (hello.sample_rate_hz != plan.stimulus.sample_rate_hz ||
      hello.nominal_hz != static_cast<std::int32_t>(std::lround(plan.grid.nominal_hz))) {
    note(record, "samples at " + std::to_string(hello.sample_rate_hz) + " Hz for mains of " +
                     std::to_string(hello.nominal_hz) + " Hz, which is not the profile's");
    return record;
  }
  record.took_part = true;
  // An outlet takes no settings that are older than those it has.
  gs::wire::Downlink message;
  message.kind = gs::wire::DownlinkKind::kSettings;
  message.settings = control_centre::outlet_settings(plan.grid, plan.outlets[i].settings,
                                                     hello.settings_version + 1);
  record.settings = control_centre::described(message.settings);
  record.settings["tracker_delay_s"] = static_cast<double>(hello.tracker_delay_s);
  record.settings["voltage_delay_s"] = static_cast<double>(hello.voltage_delay_s);
  require(link.send(i, message));
  message.kind = gs::wire::DownlinkKind::kAskSelfTest;
  require(link.send(i, message));
  return record;
}

}  // namespace

std::vector<record::OutletRecord> claim(const profile::Plan& plan, link::Link& link) {
  const auto present = link.open();
  if (!present.ok()) {
    throw BenchFault(present.error());
  }
  if (present.value().size() < plan.outlets.size()) {
    throw BenchFault("the profile needs " + std::to_string(plan.outlets.size()) +
                     " outlets; the station has " + std::to_string(present.value().size()));
  }
  std::vector<record::OutletRecord> records;
  for (std::size_t i = 0; i < plan.outlets.size(); ++i) {
    records.push_back(claim(plan, i, present.value()[i], link));
  }
  return records;
}

}  // namespace gsbench::station
