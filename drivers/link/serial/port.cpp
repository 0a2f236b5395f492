#include "port.hpp"

#include <libserialport.h>
#include <poll.h>

#include <algorithm>
#include <filesystem>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

constexpr int kWriteMs = 100;

}  // namespace

Error Port::failure(const std::string& doing) const {
  char* said = sp_last_error_message();
  const std::string why = said != nullptr && *said != '\0' ? said : "no such port";
  sp_free_error_message(said);
  return Error{path_ + ": " + doing + ": " + why};
}

Status Port::open() {
  close();
  // libserialport knows devices by their own names only; those under /dev/serial/by-id are links.
  std::error_code none;
  const std::filesystem::path device = std::filesystem::canonical(path_, none);
  if (sp_get_port_by_name(none ? path_.c_str() : device.c_str(), &port_) != SP_OK) {
    port_ = nullptr;
    return failure("cannot be found");
  }
  if (sp_open(port_, SP_MODE_READ_WRITE) != SP_OK) {
    const Error error = failure("cannot be opened");
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

Status Port::configure() {
  if (sp_set_baudrate(port_, baud_) != SP_OK || sp_set_bits(port_, 8) != SP_OK ||
      sp_set_parity(port_, SP_PARITY_NONE) != SP_OK || sp_set_stopbits(port_, 1) != SP_OK ||
      sp_set_flowcontrol(port_, SP_FLOWCONTROL_NONE) != SP_OK) {
    return failure("cannot be set to " + std::to_string(baud_) + " baud, 8N1");
  }
  sp_flush(port_, SP_BUF_BOTH);
  if (sp_get_port_handle(port_, &descriptor_) != SP_OK) {
    return failure("has no handle");
  }
  return Done{};
}

void Port::close() noexcept {
  if (port_ != nullptr) {
    sp_close(port_);
    sp_free_port(port_);
    port_ = nullptr;
    descriptor_ = -1;
  }
}

bool Port::read(std::vector<std::uint8_t>& bytes) {
  // The far end's death reads as "nothing there"; only asking for the number tells it.
  const sp_return waiting = sp_input_waiting(port_);
  if (waiting < 0) {
    return false;
  }
  const std::size_t before = bytes.size();
  bytes.resize(before + static_cast<std::size_t>(waiting));
  const sp_return taken =
      sp_nonblocking_read(port_, bytes.data() + before, static_cast<std::size_t>(waiting));
  bytes.resize(before + static_cast<std::size_t>(std::max<int>(taken, 0)));
  return taken >= 0;
}

bool Port::write(const std::vector<std::uint8_t>& bytes) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const sp_return taken =
        sp_nonblocking_write(port_, bytes.data() + written, bytes.size() - written);
    if (taken < 0) {
      return false;
    }
    written += static_cast<std::size_t>(taken);
    pollfd ready{descriptor_, POLLOUT, 0};
    if (written < bytes.size() && ::poll(&ready, 1, kWriteMs) <= 0) {
      return false;
    }
  }
  return true;
}

}  // namespace gsbench::link
