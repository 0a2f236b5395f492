#include "monitor_output.hpp"

#include "commands.hpp"
#include "message_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kFewestIdColumns = 20;
constexpr std::size_t kFaultIndent = 4;
constexpr std::size_t kMessageIndent = 13;  // after the id, and the space behind it

}  // namespace

MonitorOutput::MonitorOutput(int descriptor, bool json, bool quiet, std::string only)
    : json_(json),
      quiet_(quiet),
      only_(std::move(only)),
      output_(descriptor, [this](std::uint64_t lines) { return notice(lines); }),
      id_columns_(kFewestIdColumns) {}

void MonitorOutput::show(const link::Happenings& happenings) {
  // The messages may be of an outlet that then left, or of one that had joined before.
  const auto& changes = happenings.changes;
  const auto after_joins = std::find_if(changes.rbegin(), changes.rend(), [](const auto& change) {
                             return std::holds_alternative<link::OutletPresence>(change);
                           }).base();
  std::for_each(changes.begin(), after_joins, [&](const auto& change) { show_change(change); });
  for (const link::Received& received : happenings.messages) {
    const bool measurement = received.message.kind == gs::wire::UplinkKind::kMeasurement;
    if (wanted(received.id) && !is_twin(received.id) && !(quiet_ && measurement)) {
      show_message(received);
    }
  }
  std::for_each(after_joins, changes.end(), [&](const auto& change) { show_change(change); });
  for (const link::Fault& fault : happenings.faults) {
    if (wanted(fault.id)) {
      show_reason("fault", fault, false);
    }
  }
}

void MonitorOutput::show_change(const link::Change& change) {
  if (const auto* const joined = std::get_if<link::OutletPresence>(&change)) {
    return join(*joined);
  }
  const auto& left = std::get<link::Fault>(change);
  return left.excluded ? show_fault(left.id, left.where, left.what) : show_left(left);
}

void MonitorOutput::show_left(const link::Fault& left) {
  known_.erase(std::remove_if(
                   known_.begin(), known_.end(),
                   [&](const Known& one) { return one.id == left.id && one.where == left.where; }),
               known_.end());
  std::vector<Known*> others;
  for (Known& one : known_) {
    if (one.id == left.id) {
      others.push_back(&one);
    }
  }
  if (others.size() < 2) {  // more of them are twins still
    at_fault_.erase(left.id);
  }
  if (others.size() == 1) {
    others[0]->is_twin = false;
  }
  if (wanted(left.id)) {
    show_reason("left", left, false);
  }
}

void MonitorOutput::show_fault(const std::string& id, const std::string& where,
                               const std::string& fault) {
  if (id.empty() || wanted(id)) {
    at_fault_.insert(id.empty() ? where : id);
    show_reason("fault", {id, fault, where}, true);
  }
}

bool MonitorOutput::is_twin(const std::string& id) const {
  return std::any_of(known_.begin(), known_.end(),
                     [&](const Known& one) { return one.is_twin && one.id == id; });
}

void MonitorOutput::join(const link::OutletPresence& outlet) {
  const auto same_id = [&](const Known& one) { return one.id == outlet.id; };
  const auto again = std::find_if(known_.begin(), known_.end(), [&](const Known& one) {
    return same_id(one) && one.where == outlet.where;
  });
  if (again == known_.end()) {
    known_.push_back({outlet.id, outlet.where, false});
  }
  names_.insert({outlet.id, outlet.where});
  at_fault_.erase(outlet.where);
  at_fault_.erase(outlet.id);
  const auto twin = std::find_if(known_.begin(), known_.end(), [&](const Known& one) {
    return same_id(one) && one.where != outlet.where;
  });
  if (twin == known_.end()) {
    return show_joined(outlet);
  }
  const auto show_twin = [&](const std::string& where, const std::string& other) {
    show_fault(outlet.id, where, link::same_id_fault(other));
  };
  if (!twin->is_twin) {
    show_twin(twin->where, outlet.where);
  }
  show_twin(outlet.where, twin->where);
  for (Known& one : known_) {
    one.is_twin = one.is_twin || same_id(one);
  }
}

void MonitorOutput::show_joined(const link::OutletPresence& outlet) {
  if (!wanted(outlet.id)) {
    return;
  }
  if (!outlet.fault.empty()) {
    at_fault_.insert(outlet.id);
  }
  has_answered_ = has_answered_ || outlet.fault.empty();
  if (json_) {
    Json object = {{"event", "joined"}};
    object.update(as_json(outlet, true));
    put_arrival(object, outlet.arrival_ns);
    object["start_number"] = outlet.start_number;
    object["sample"] = outlet.sample;
    return put_json(object);
  }
  if (!outlet.fault.empty()) {
    return show_fault(outlet.id, outlet.where, outlet.fault);
  }
  gs::wire::Uplink hello;
  hello.sample = outlet.sample;
  hello.hello = outlet.hello;
  show_message({outlet.id, hello});
}

void MonitorOutput::show_message(const link::Received& received) {
  const gs::wire::Uplink& message = received.message;
  if (!json_) {
    return put_text(received.id,
                    fmt::format("{:>10} {:<15} {}", message.sample,
                                gs::wire::to_string(message.kind), details(message)),
                    kMessageIndent);
  }
  Json object = {{"event", "message"}, {"id", received.id}};
  put_arrival(object, received.arrival_ns);
  object["start_number"] = message.start_number;
  object["sequence"] = received.sequence;
  object["sample"] = message.sample;
  object["kind"] = gs::wire::to_string(message.kind);
  object.update(fields_of(message));
  put_json(object);
}

void MonitorOutput::put_arrival(Json& object, std::int64_t arrival_ns) const {
  if (arrival_ns > 0) {
    const auto arrival =
        std::chrono::steady_clock::time_point(std::chrono::nanoseconds(arrival_ns));
    object["arrival_s"] =
        std::round(1e6 * std::chrono::duration<double>(arrival - started_).count()) / 1e6;
  }
}

// JSON has the place always.
void MonitorOutput::show_reason(const char* event, const link::Fault& fault, bool with_place) {
  if (!json_) {
    const bool both = with_place && !fault.id.empty() && !fault.where.empty();
    const std::string& name = fault.id.empty() ? fault.where : fault.id;
    return put_text(both ? fault.id + " at " + fault.where : name, "! " + fault.what, kFaultIndent);
  }
  Json object = {{"event", event}};
  for (const auto& [key, value] : {std::pair("id", fault.id), std::pair("where", fault.where)}) {
    if (!value.empty()) {
      object[key] = value;
    }
  }
  object["fault"] = fault.what;
  put_json(object);
}

// On a terminal a long line is wrapped; otherwise a line holds one message, so that scripts can
// filter them. The columns grow with the longest id.
void MonitorOutput::put_text(const std::string& id, const std::string& text, std::size_t indent) {
  constexpr std::size_t kMostIdColumns = gs::wire::kLongestId;
  id_columns_ = std::max(id_columns_, std::min(id.size(), kMostIdColumns));
  const std::string line = fmt::format("{:<{}} {}", id, id_columns_, text);
  output_.put(output_.writes_to_terminal()
                  ? render::wrapped(line, render::kLineColumns, indent + id_columns_)
                  : line);
}

void MonitorOutput::put_json(const Json& object) {
  if (!std::exchange(has_version_, true)) {
    Json first = object;
    first["format_version"] = kJsonFormatVersion;
    return put_json(first);
  }
  output_.put(object.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string MonitorOutput::notice(std::uint64_t lines) const {
  return json_ ? Json({{"event", "left out"}, {"count", lines}}).dump()
               : fmt::format("! {} {} left out here: the output was not read in time", lines,
                             lines == 1 ? "line was" : "lines were");
}

}  // namespace gsbench::cli
