#include "emulated_station.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <emulation/hardware.hpp>

namespace gsbench::station {
namespace {

namespace fs = std::filesystem;

// Where the program's own companions are: beside it.
std::string companion(const std::string& name) {
  std::error_code error;
  return (fs::read_symlink("/proc/self/exe", error).parent_path() / name).string();
}

emulation::HardwareOptions options_of(const std::string& image, const profile::Plan& plan) {
  emulation::HardwareOptions options;
  options.sample_rate_hz = plan.stimulus.sample_rate_hz;
  options.nominal_hz = static_cast<int>(std::lround(plan.grid.nominal_hz));
  options.image = image;
  options.image_folder = GSBENCH_M4_IMAGE_FOLDER;
  options.host_program = companion("gs-outlet");
  return options;
}

}  // namespace

EmulatedStation::EmulatedStation(std::string name,
                                 const std::vector<emulation::HardwareOutlet>& outlets,
                                 const std::string& image, const profile::Plan& plan)
    : name_(std::move(name)), sample_rate_hz_(static_cast<double>(plan.stimulus.sample_rate_hz)) {
  emulation::HardwareOptions hardware_options = options_of(image, plan);
  hardware_options.outlets = outlets;
  auto hardware = emulation::Hardware::set_up(hardware_options);
  if (!hardware.ok()) {
    throw std::runtime_error("station " + name_ + ": " + hardware.error());
  }
  hardware_ = hardware.take();
  std::size_t on_cable = 0;
  for (const emulation::HardwareOutlet& outlet : outlets) {
    // On a cable it is known by its port: only what it says there shows who it is.
    const bool by_broker = outlet.connection == emulation::Connection::kMqtt;
    const std::string place =
        by_broker ? hardware_->broker()->url() : hardware_->serial_ports()[on_cable++];
    slots_.push_back({place, outlet.id, by_broker ? outlet.id : place, slots_.size()});
  }
  PhysicalOutlets reached;
  reached.serial_ports = hardware_->serial_ports();
  if (const emulation::PrivateBroker* const broker = hardware_->broker(); broker != nullptr) {
    reached.broker = {broker->url(),         broker->ca_file(),       broker->bench().user, "",
                      hardware_->mqtt_ids(), broker->bench().password};
  }
  link_ = make_link(reached, false);
}

// The link lets go of its ports before they are gone.
EmulatedStation::~EmulatedStation() {
  link_->close();
}

record::BenchUncertainty EmulatedStation::uncertainty() {
  record::BenchUncertainty uncertainty;
  uncertainty.relay_sense_ms =
      1e3 * hardware_->relay_sense().alignment().uncertainty_ticks / sample_rate_hz_;
  return uncertainty;
}

}  // namespace gsbench::station
