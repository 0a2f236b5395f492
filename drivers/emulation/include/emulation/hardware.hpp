// The hardware of an emulated station: one process for each outlet (the firmware's Cortex-M4F image
// in qemu, or the firmware as a process of this machine), the mains or the wire from an instrument
// at their terminals, cables to outlets on serial lines, and a private broker for outlets on MQTT.
// All of these end with the Hardware object that owns them, also if the bench is killed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <emulation/child.hpp>
#include <emulation/mains.hpp>
#include <emulation/null_modem.hpp>
#include <emulation/private_broker.hpp>

namespace gsbench::emulation {

enum class Connection { kSerial, kMqtt, kNone };

struct HardwareOutlet {
  std::string id;
  std::string board = "host";  // an emulated board of boards/boards.hpp
  Connection connection = Connection::kSerial;
  double crystal_ppm = 0.0;  // positive: fast
  // A contact-only device in place of a board. It has no process, and connection is kNone.
  std::optional<FrequencyRelayOptions> frequency_relay = {};
};

struct HardwareOptions {
  std::vector<HardwareOutlet> outlets;
  std::int64_t sample_rate_hz = 8000;
  int nominal_hz = 50;
  bool real_time = true;
  std::string image;         // for all boards in qemu; empty: each board's own, in image_folder
  std::string image_folder;  // has gs-outlet-<board's folder>.elf
  std::string host_program;  // path of gs-outlet
};

class ScratchFolder;

class Hardware {
 public:
  // Call it from a thread that outlives the hardware (emulation/child.hpp).
  static drivers::Result<std::unique_ptr<Hardware>> set_up(const HardwareOptions& options);
  ~Hardware();
  Hardware(const Hardware&) = delete;
  Hardware& operator=(const Hardware&) = delete;

  // The folder of the outlets' files. It is removed with this object. After a kill of the bench,
  // the set-up of the next station removes it.
  const std::string& folder() const;

  source::Source& source() { return mains_->source(); }
  relay::RelaySense& relay_sense() { return mains_->relay_sense(); }

  // The bench's ends of the cables, as port names for transport/transport.hpp, in the order of the
  // outlets on serial lines.
  std::vector<std::string> serial_ports() const;
  // The outlets on MQTT, in the order of the options.
  std::vector<std::string> mqtt_ids() const;
  PrivateBroker* broker() { return broker_.get(); }  // null: no outlet needs one

  // For a wire from an instrument in place of source(); relay_sense() does not work then.
  Terminals& outlets() { return mains_->outlets(); }

  // For fault injection.
  Child& outlet_process(std::size_t outlet) { return processes_.at(outlet).value(); }
  drivers::Status restart_outlet(std::size_t outlet);
  NullModem& cable(std::size_t outlet) { return *cables_.at(outlet); }
  gs::shared_memory_io::SharedMemory& terminals(std::size_t outlet) {
    return mains_->terminals(outlet);
  }

 private:
  explicit Hardware(const HardwareOptions& options);
  drivers::Status set_up();
  drivers::Result<Child> start_process(std::size_t outlet) const;

  // The members are in the order of set-up. They are destroyed in reverse order.
  HardwareOptions options_;
  std::unique_ptr<ScratchFolder> folder_;
  std::unique_ptr<Mains> mains_;
  std::unique_ptr<PrivateBroker> broker_;
  std::vector<std::unique_ptr<NullModem>> cables_;  // null for outlets behind the broker
  std::vector<std::optional<Child>> processes_;     // none for contact-only devices
};

}  // namespace gsbench::emulation
