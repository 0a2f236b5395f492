// Stations of emulated outlets.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <emulation/hardware.hpp>
#include <link/link.hpp>
#include <profile/plan.hpp>
#include <station/station.hpp>
#include <station/station_file.hpp>

namespace gsbench::station {

// Emulated outlets and the links to them, the same as to real ones.
class EmulatedStation final : public Station {
 public:
  // Throws std::runtime_error where it cannot be set up.
  // `image`: of the boards in qemu; empty: those that were built.
  EmulatedStation(std::string name, const std::vector<emulation::HardwareOutlet>& outlets,
                  const std::string& image, const profile::Plan& plan);
  ~EmulatedStation() override;

  std::string name() const override { return name_; }
  source::Source& source() override { return hardware_->source(); }
  link::Link& link() override { return *link_; }
  relay::RelaySense& relay_sense() override { return hardware_->relay_sense(); }
  std::vector<Slot> slots() const override { return slots_; }
  // Outlets in a busy machine's processes take their time to come up.
  std::chrono::milliseconds answers_within() const override { return std::chrono::seconds(10); }
  record::BenchUncertainty uncertainty() override;
  bool outlets_count_ticks() const override { return false; }
  double block_s() const override { return 0.016; }

  emulation::Hardware& hardware() { return *hardware_; }

 private:
  std::string name_;
  double sample_rate_hz_;
  std::unique_ptr<emulation::Hardware> hardware_;
  std::vector<Slot> slots_;
  std::unique_ptr<link::Link> link_;
};

// A file that describes one.
class EmulatedFile final : public StationFile {
 public:
  std::optional<std::size_t> outlets() const override { return hardware.size(); }
  std::unique_ptr<Station> make_station(const profile::Plan& plan,
                                        const SimulatedOptions& simulated) const override;

  std::vector<emulation::HardwareOutlet> hardware;
  std::string image;  // of the boards in qemu; empty: those that were built
};

}  // namespace gsbench::station
