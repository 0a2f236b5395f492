// Stations of emulated outlets: the firmware's image runs in an emulator process.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <emulation/hardware.hpp>
#include <keys/table.hpp>
#include <link/link.hpp>
#include <profile/plan.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// Reads the outlets and the firmware image from a station file. Relative paths are relative to
// `file_path`.
emulation::HardwareOptions read_emulated(const keys::Table& top, const std::string& file_path);

// Emulated outlets, reached through the same links as physical ones.
class EmulatedStation final : public Station {
 public:
  // Completes `options` from the plan and the build. Throws std::runtime_error if the set-up fails.
  EmulatedStation(std::string name, emulation::HardwareOptions options, const profile::Plan& plan);
  ~EmulatedStation() override;

  std::string name() const override { return name_; }
  source::Source& source() override { return hardware_->source(); }
  link::Link& link() override { return *link_; }
  relay::RelaySense& relay_sense() override { return hardware_->relay_sense(); }
  std::vector<Slot> slots() const override { return slots_; }
  // The emulator processes start slowly on a busy machine.
  std::chrono::milliseconds answers_within() const override { return std::chrono::seconds(10); }
  bool outlets_count_ticks() const override { return false; }
  double block_s() const override { return 0.016; }

  emulation::Hardware& hardware() { return *hardware_; }

 private:
  std::string name_;
  std::unique_ptr<emulation::Hardware> hardware_;
  std::vector<Slot> slots_;
  std::unique_ptr<link::Link> link_;
};

}  // namespace gsbench::station
