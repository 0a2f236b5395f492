#include "kinds.hpp"
#include "port_users.hpp"
#include <libserialport.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

namespace gsbench::transport {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

class Serial final : public Transport {
 public:
  Serial(const std::string& port, int baud) : Transport(port), baud_(baud) {}
  ~Serial() override { close(); }

  Status open() override {
    close();
    // libserialport does not accept symbolic links, such as those in /dev/serial/by-id.
    std::error_code none;
    const std::filesystem::path device = std::filesystem::canonical(port(), none);
    if (sp_get_port_by_name(none ? port().c_str() : device.c_str(), &port_) != SP_OK) {
      port_ = nullptr;
      return none ? failure("cannot be found", none.message())
                  : failure("cannot be opened", "is not a serial port");
    }
    if (sp_open(port_, SP_MODE_READ_WRITE) != SP_OK) {
      // A program may have claimed it with TIOCEXCL.
      const Error error = errno == EBUSY ? in_use(device) : last_error("cannot be opened");
      sp_free_port(port_);
      port_ = nullptr;
      return error;
    }
    Status configured = configure();
    if (!configured.ok()) {
      close();
    }
    return configured;
  }

  void close() noexcept override {
    if (port_ != nullptr) {
      sp_close(port_);
      sp_free_port(port_);
      port_ = nullptr;
      descriptor_ = -1;
    }
  }

  int descriptor() const override { return descriptor_; }

 private:
  Status read_some(std::vector<std::uint8_t>& bytes) override {
    // If the far end is gone, a read returns 0 bytes; only this call reports the error.
    const sp_return waiting = sp_input_waiting(port_);
    if (waiting < 0) {
      return last_error("cannot be read");
    }
    const std::size_t before = bytes.size();
    bytes.resize(before + static_cast<std::size_t>(waiting));
    const sp_return taken =
        sp_nonblocking_read(port_, bytes.data() + before, static_cast<std::size_t>(waiting));
    bytes.resize(before + static_cast<std::size_t>(std::max<int>(taken, 0)));
    if (taken < 0) {
      return last_error("cannot be read");
    }
    return Done{};
  }

  Result<std::size_t> write_some(const std::uint8_t* bytes, std::size_t count) override {
    const sp_return taken = sp_nonblocking_write(port_, bytes, count);
    if (taken < 0) {
      return last_error("cannot be sent to");
    }
    return static_cast<std::size_t>(taken);
  }

  Status configure() {
    if (sp_get_port_handle(port_, &descriptor_) != SP_OK) {
      return last_error("has no handle");
    }
    // Locked before any setting is changed: another program may use the port.
    std::error_code none;
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      return in_use(std::filesystem::canonical(port(), none));
    }
    if (sp_set_baudrate(port_, baud_) != SP_OK || sp_set_bits(port_, 8) != SP_OK ||
        sp_set_parity(port_, SP_PARITY_NONE) != SP_OK || sp_set_stopbits(port_, 1) != SP_OK ||
        sp_set_flowcontrol(port_, SP_FLOWCONTROL_NONE) != SP_OK) {
      return last_error("cannot be set to " + std::to_string(baud_) + " baud, 8N1");
    }
    sp_flush(port_, SP_BUF_BOTH);
    return Done{};
  }

  Error in_use(const std::filesystem::path& device) const {
    const std::string user = user_of(device, descriptor_);
    return failure("cannot be opened",
                   "another program has it open" + (user.empty() ? "" : ": " + user));
  }

  Error last_error(const std::string& doing) const {
    char* text = sp_last_error_message();
    const std::string why = text != nullptr && *text != '\0' ? text : "no such port";
    sp_free_error_message(text);
    return failure(doing, why);
  }

  int baud_;
  sp_port* port_ = nullptr;
  int descriptor_ = -1;
};

}  // namespace

std::unique_ptr<Transport> make_serial(const std::string& port, int baud) {
  return std::make_unique<Serial>(port, baud);
}

std::vector<std::string> serial_ports() {
  std::vector<std::string> paths;
  sp_port** ports = nullptr;
  if (sp_list_ports(&ports) != SP_OK) {
    return paths;
  }
  for (std::size_t i = 0; ports[i] != nullptr; ++i) {
    paths.emplace_back(sp_get_port_name(ports[i]));
  }
  sp_free_port_list(ports);
  return paths;
}

}  // namespace gsbench::transport
