// What gsbench monitor shows, as text or as JSON lines.
#pragma once

#include "patient_output.hpp"

#include <chrono>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <link/link.hpp>

namespace gsbench::cli {

class MonitorOutput {
 public:
  // `only`: the id of the outlet to show; empty: all. `quiet`: without measurements.
  MonitorOutput(int descriptor, bool json, bool quiet, std::string only);

  // Two outlets with the same id have the fault that gsbench devices reports, and are not shown
  // until one of them has left. Does not block.
  void show(const link::Happenings& happenings);
  // Of an outlet, or of a place (a port) whose outlet is not known: it cannot be monitored. Empty:
  // not known.
  void show_fault(const std::string& id, const std::string& where, const std::string& fault);

  // Whether an outlet with this id or at this place has ever joined.
  bool knows(const std::string& name) const { return names_.count(name) > 0; }
  // Whether an outlet that is shown cannot be monitored now, other than because it has left.
  bool has_fault() const { return !at_fault_.empty(); }

  // True from the first answer of an outlet that is shown and has no fault.
  bool has_answered() const { return has_answered_; }

  void flush() { output_.flush(); }
  void finish(std::chrono::milliseconds patience) { output_.finish(patience); }
  int error() const { return output_.error(); }

 private:
  struct Known {
    std::string id;
    std::string where;
    bool is_twin = false;  // of another outlet with the same id
  };

  bool wanted(const std::string& id) const { return only_.empty() || only_ == id; }
  bool is_twin(const std::string& id) const;
  void join(const link::OutletPresence& outlet);
  void show_joined(const link::OutletPresence& outlet);
  void show_message(const link::Received& received);
  void show_change(const link::Change& change);
  void show_left(const link::Fault& left);
  void show_reason(const char* event, const link::Fault& fault, bool with_place);
  void put_arrival(nlohmann::ordered_json& object, std::int64_t arrival_ns) const;
  void put_text(const std::string& id, const std::string& text, std::size_t indent);
  void put_json(const nlohmann::ordered_json& object);
  std::string notice(std::uint64_t lines) const;

  const bool json_;
  const bool quiet_;
  const std::string only_;
  PatientOutput output_;
  std::vector<Known> known_;
  std::set<std::string> names_;     // ids and places of all that have joined
  std::set<std::string> at_fault_;  // ids; places, where the id is not known
  std::size_t id_columns_;
  bool has_answered_ = false;
  bool has_version_ = false;  // the JSON, in its first object
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace gsbench::cli
