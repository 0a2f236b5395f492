#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <emulated/desk.hpp>

namespace gsbench::emulated {

namespace fs = std::filesystem;
using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

// In memory where that is possible: samples pass through files here.
std::string new_folder() {
  std::error_code error;
  const fs::path place =
      fs::is_directory("/dev/shm", error) ? fs::path("/dev/shm") : fs::temp_directory_path(error);
  std::string pattern = (place / "gsbench-desk-XXXXXX").string();
  return mkdtemp(pattern.data()) == nullptr ? std::string() : pattern;
}

}  // namespace

Result<std::unique_ptr<Desk>> Desk::set_up(const DeskOptions& options) {
  std::unique_ptr<Desk> desk(new Desk(options));
  const Status status = desk->set_up();
  if (!status.ok()) {
    return Error{status.error()};
  }
  return desk;
}

Desk::~Desk() {
  for (process::Child& child : processes_) {
    child.stop();
  }
  cables_.clear();
  broker_.reset();
  mains_.reset();
  std::error_code ignored;
  if (!folder_.empty()) {
    fs::remove_all(folder_, ignored);
  }
}

Status Desk::set_up() {
  folder_ = new_folder();
  if (folder_.empty()) {
    return Error{std::string("emulated outlets: no folder for their files: ") +
                 std::strerror(errno)};
  }
  MainsOptions mains;
  mains.folder = folder_;
  mains.sample_rate_hz = options_.sample_rate_hz;
  mains.nominal_hz = options_.nominal_hz;
  mains.real_time = options_.real_time;
  for (const DeskOutlet& outlet : options_.outlets) {
    mains.outlets.push_back({outlet.id, outlet.crystal_ppm});
  }
  auto made = Mains::create(mains);
  if (!made.ok()) {
    return Error{made.error()};
  }
  mains_ = made.take();
  if (!mqtt_ids().empty()) {
    auto started = broker::PrivateBroker::start({folder_ + "/broker", mqtt_ids(), true});
    if (!started.ok()) {
      return Error{started.error()};
    }
    broker_ = std::make_unique<broker::PrivateBroker>(started.take());
  }
  for (std::size_t i = 0; i < options_.outlets.size(); ++i) {
    const Status plugged = plug_in(i);
    if (!plugged.ok()) {
      return plugged;
    }
  }
  return Done{};
}

Status Desk::plug_in(std::size_t outlet) {
  const DeskOutlet& it = options_.outlets[outlet];
  cables_.emplace_back();
  if (it.connection == Connection::kSerial) {
    auto cable = it.board == Board::kHost ? NullModem::between_terminals()
                                          : NullModem::to_socket(folder_ + "/" + it.id + ".line");
    if (!cable.ok()) {
      return Error{cable.error()};
    }
    cables_.back() = std::make_unique<NullModem>(cable.take());
  }
  const auto command = command_of(outlet);
  if (!command.ok()) {
    return Error{command.error()};
  }
  auto child = process::Child::start(command.value());
  if (!child.ok()) {
    return Error{child.error()};
  }
  processes_.push_back(child.take());
  return Done{};
}

Status Desk::restart_outlet(std::size_t outlet) {
  const auto command = command_of(outlet);
  if (!command.ok()) {
    return Error{command.error()};
  }
  auto child = process::Child::start(command.value());
  if (!child.ok()) {
    return Error{child.error()};
  }
  processes_.at(outlet) = child.take();
  return Done{};
}

Result<process::Command> Desk::command_of(std::size_t outlet) const {
  const DeskOutlet& it = options_.outlets[outlet];
  const std::string& terminals = mains_->terminal_path(outlet);
  const std::string& doorbell = mains_->doorbell_path(outlet);
  process::Command command;
  command.output = folder_ + "/" + it.id + ".log";
  if (it.board == Board::kMps2An386) {
    if (it.connection != Connection::kSerial) {
      return Error{"outlet " + it.id + ": the emulated board has no radio: its link is serial"};
    }
    command.words = {"qemu-system-arm",
                     "-M",
                     "mps2-an386,memory-backend=psram",
                     "-object",
                     "memory-backend-file,id=psram,size=16M,share=on,mem-path=" + terminals,
                     "-kernel",
                     options_.image,
                     "-display",
                     "none",
                     "-monitor",
                     "none",
                     "-nodefaults",
                     "-chardev",
                     "socket,id=line,path=" + cables_[outlet]->outlet_end(),
                     "-chardev",
                     "socket,id=bell,path=" + doorbell,
                     "-serial",
                     "chardev:line",
                     "-serial",
                     "chardev:bell"};
    return command;
  }
  command.words = {options_.host_program, "--terminals", terminals, "--doorbell", doorbell};
  if (it.connection == Connection::kSerial) {
    command.words.insert(command.words.end(), {"--serial", cables_[outlet]->outlet_end()});
    return command;
  }
  // Not on the command line, where everybody can read it.
  const std::string password_file = folder_ + "/" + it.id + ".password";
  std::ofstream(password_file) << broker_->outlet(it.id).password << '\n';
  command.words.insert(command.words.end(),
                       {"--mqtt", broker_->url(), "--ca", broker_->ca_file(), "--user",
                        broker_->outlet(it.id).user, "--password-file", password_file});
  return command;
}

std::vector<std::string> Desk::serial_ports() const {
  std::vector<std::string> ports;
  for (const auto& cable : cables_) {
    if (cable != nullptr) {
      ports.push_back(cable->bench_end());
    }
  }
  return ports;
}

std::vector<std::string> Desk::mqtt_ids() const {
  std::vector<std::string> ids;
  for (const DeskOutlet& outlet : options_.outlets) {
    if (outlet.connection == Connection::kMqtt) {
      ids.push_back(outlet.id);
    }
  }
  return ids;
}

}  // namespace gsbench::emulated
