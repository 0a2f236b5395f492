#include "emulated_station.hpp"

#include "outlet_links.hpp"
#include "run_steps.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <installation/installation.hpp>
#include <station/source_check.hpp>

namespace gsbench::station {
namespace {

// Without an instrument, outlets are waited for so long: the emulator processes start slowly on a
// busy machine.
constexpr auto kSlowestStart = std::chrono::seconds(10);

}  // namespace

EmulatedStation::EmulatedStation(std::string name, emulation::HardwareOptions options,
                                 const profile::Plan& plan,
                                 const std::optional<InstrumentOptions>& instrument)
    : name_(std::move(name)), answers_within_(kSlowestStart) {
  options.sample_rate_hz = plan.stimulus.sample_rate_hz;
  options.nominal_hz = static_cast<int>(std::lround(plan.grid.nominal_hz));
  options.image_folder = installation::shipped("firmware").string();
  options.host_program = installation::program("gs-outlet").string();
  auto hardware = emulation::Hardware::set_up(options);
  if (!hardware.ok()) {
    throw std::runtime_error("station " + name_ + ": " + hardware.error());
  }
  hardware_ = hardware.take();
  std::size_t on_cable = 0;
  for (const emulation::HardwareOutlet& outlet : options.outlets) {
    if (outlet.connection == emulation::Connection::kNone) {
      slots_.push_back({outlet.board, outlet.id, std::nullopt, slots_.size()});
      continue;
    }
    // A serial port does not identify its outlet: only the outlet's messages do.
    const bool by_broker = outlet.connection == emulation::Connection::kMqtt;
    const std::string place =
        by_broker ? hardware_->broker()->url() : hardware_->serial_ports()[on_cable++];
    slots_.push_back({place, outlet.id, by_broker ? outlet.id : place, slots_.size()});
  }
  PhysicalOutlets reached;
  reached.serial.ports = hardware_->serial_ports();
  if (const emulation::PrivateBroker* const broker = hardware_->broker(); broker != nullptr) {
    reached.mqtt = {broker->url(), broker->ca_file(), broker->bench().user,
                    broker->bench().password, hardware_->mqtt_ids()};
  }
  link_ = make_link(reached);
  if (!instrument && std::none_of(slots_.begin(), slots_.end(),
                                  [](const Slot& slot) { return slot.link_id.has_value(); })) {
    answers_within_ = {};  // a device without a link is emulated in this process
  }
  if (instrument) {
    answers_within_ = std::chrono::milliseconds(std::llround(1e3 * instrument->settings.boot_s));
    instrument_ = std::make_unique<EmulatedInstrument>(
        *instrument, plan, signal_of(plan, assign(plan.outlets, slots_), *this), *hardware_);
  }
}

// The link must close its ports before the hardware removes them.
EmulatedStation::~EmulatedStation() {
  link_->close();
}

}  // namespace gsbench::station
