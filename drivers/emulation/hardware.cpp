#include "scratch_folder.hpp"

#include <fstream>

#include <boards/boards.hpp>
#include <emulation/hardware.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

Hardware::Hardware(const HardwareOptions& options) : options_(options) {}

Result<std::unique_ptr<Hardware>> Hardware::set_up(const HardwareOptions& options) {
  std::unique_ptr<Hardware> hardware(new Hardware(options));
  if (const Status status = hardware->set_up(); !status.ok()) {
    return Error{status.error()};
  }
  return hardware;
}

Hardware::~Hardware() = default;

Status Hardware::set_up() {
  if (Status made = ScratchFolder::create().move_to(folder_); !made.ok()) {
    return made;
  }
  MainsOptions mains{
      folder_->path(), {}, options_.sample_rate_hz, options_.nominal_hz, options_.real_time};
  for (const HardwareOutlet& outlet : options_.outlets) {
    mains.outlets.push_back({outlet.id, outlet.crystal_ppm, outlet.frequency_relay});
  }
  if (Status made = Mains::create(mains).move_to(mains_); !made.ok()) {
    return made;
  }
  if (!mqtt_ids().empty()) {
    auto started = PrivateBroker::start({folder_->path() + "/broker", mqtt_ids()});
    if (!started.ok()) {
      return Error{started.error()};
    }
    broker_ = std::make_unique<PrivateBroker>(started.take());
  }
  for (std::size_t i = 0; i < options_.outlets.size(); ++i) {
    cables_.emplace_back();
    processes_.emplace_back();
    if (options_.outlets[i].frequency_relay) {
      continue;
    }
    if (options_.outlets[i].connection == Connection::kSerial) {
      if (Status made = NullModem::create().move_to(cables_.back()); !made.ok()) {
        return made;
      }
    }
    auto child = start_process(i);
    if (!child.ok()) {
      return Error{child.error()};
    }
    processes_.back() = child.take();
  }
  return Done{};
}

Status Hardware::restart_outlet(std::size_t outlet) {
  return start_process(outlet).move_to(processes_.at(outlet));
}

Result<Child> Hardware::start_process(std::size_t outlet) const {
  const HardwareOutlet& it = options_.outlets[outlet];
  const std::string& terminals = mains_->terminal_path(outlet);
  const std::string& doorbell = mains_->doorbell_path(outlet);
  const std::string cable_port =
      cables_[outlet] == nullptr ? "" : std::to_string(cables_[outlet]->outlet_end());
  Command command;
  command.output = folder_->path() + "/" + it.id + ".log";
  const gs::boards::Board* board = gs::boards::find(it.board.c_str());
  if (board == nullptr || !gs::boards::is_emulated(*board)) {
    return Error{"outlet " + it.id + ": the board \"" + it.board + "\" cannot be emulated"};
  }
  if (it.connection == Connection::kMqtt && !board->has_radio) {
    return Error{"outlet " + it.id + ": the board " + it.board +
                 " has no radio; use a serial link"};
  }
  if (!gs::boards::is_process(*board)) {
    command.words = {"qemu-system-arm",
                     "-M",
                     board->machine,
                     "-object",
                     "memory-backend-file,id=psram,size=16M,share=on,mem-path=" + terminals,
                     "-kernel",
                     options_.image.empty()
                         ? options_.image_folder + "/gs-outlet-" + board->folder + ".elf"
                         : options_.image,
                     "-display",
                     "none",
                     "-monitor",
                     "none",
                     "-nodefaults",
                     "-chardev",
                     "socket,id=line,host=127.0.0.1,nodelay=on,port=" + cable_port,
                     "-chardev",
                     "socket,id=bell,path=" + doorbell,
                     "-serial",
                     "chardev:line",
                     "-serial",
                     "chardev:bell"};
    return Child::start(command);
  }
  command.words = {options_.host_program, "--terminals", terminals, "--doorbell", doorbell};
  if (it.connection == Connection::kSerial) {
    command.words.insert(command.words.end(), {"--tcp", "127.0.0.1:" + cable_port});
    return Child::start(command);
  }
  // Not on the command line, where other users can read it.
  const std::string password_file = folder_->path() + "/" + it.id + ".password";
  std::ofstream(password_file) << broker_->outlet(it.id).password << '\n';
  command.words.insert(command.words.end(),
                       {"--mqtt", broker_->url(), "--ca", broker_->ca_file(), "--user",
                        broker_->outlet(it.id).user, "--password-file", password_file});
  return Child::start(command);
}

const std::string& Hardware::folder() const {
  return folder_->path();
}

std::vector<std::string> Hardware::serial_ports() const {
  std::vector<std::string> ports;
  for (const auto& cable : cables_) {
    if (cable != nullptr) {
      ports.push_back(cable->bench_end());
    }
  }
  return ports;
}

std::vector<std::string> Hardware::mqtt_ids() const {
  std::vector<std::string> ids;
  for (const HardwareOutlet& outlet : options_.outlets) {
    if (outlet.connection == Connection::kMqtt) {
      ids.push_back(outlet.id);
    }
  }
  return ids;
}

}  // namespace gsbench::emulation
