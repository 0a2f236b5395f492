// Stations of emulated outlets: the firmware's image runs in an emulator process.
#pragma once

#include "emulated_instrument.hpp"

#include <chrono>
#include <memory>
#include <optional>
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

// Emulated outlets, reached through the same links as physical ones, and fed directly or by an
// emulated instrument.
class EmulatedStation final : public Station {
 public:
  // Completes `options` from the plan and the build. Throws std::runtime_error if the set-up fails.
  EmulatedStation(std::string name, emulation::HardwareOptions options, const profile::Plan& plan,
                  const std::optional<InstrumentOptions>& instrument = std::nullopt);
  ~EmulatedStation() override;

  std::string name() const override { return name_; }
  source::Source& source() override {
    return instrument_ ? instrument_->source() : hardware_->source();
  }
  link::Link& link() override { return *link_; }
  relay::RelaySense& relay_sense() override {
    return instrument_ ? instrument_->relay_sense() : hardware_->relay_sense();
  }
  std::vector<Slot> slots() const override { return slots_; }
  std::chrono::milliseconds answers_within() const override { return answers_within_; }
  bool outlets_count_ticks() const override { return false; }
  std::string source_accuracy() const override {
    return instrument_ ? "not calibrated; from the instrument's table" : "";
  }
  std::string relay_aligned_by() const override {
    return instrument_ ? instrument_->relay_aligned_by() : Station::relay_aligned_by();
  }
  double block_s() const override { return 0.016; }

  emulation::Hardware& hardware() { return *hardware_; }
  EmulatedInstrument& instrument() { return *instrument_; }  // only if there is one

 private:
  std::string name_;
  std::chrono::milliseconds answers_within_;
  std::unique_ptr<emulation::Hardware> hardware_;
  std::unique_ptr<EmulatedInstrument> instrument_;  // none: the outlets are fed directly
  std::vector<Slot> slots_;
  std::unique_ptr<link::Link> link_;
};

}  // namespace gsbench::station
