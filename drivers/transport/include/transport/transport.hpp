// A stream of bytes to one outlet or instrument: a serial port or a TCP connection. Errors name the
// port, what it was asked and what it said. One thread at a time.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::transport {

using Clock = std::chrono::steady_clock;

constexpr int kBaud =
    921600;  // of serial ports: 8 data bits, no parity, 1 stop bit, no flow control

class Transport {
 public:
  explicit Transport(std::string port) : port_(std::move(port)) {}
  virtual ~Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  const std::string& port() const { return port_; }  // as it was given

  // Forgets what had come before. Blocks for half a second at most, besides looking up a host.
  [[nodiscard]] virtual drivers::Status open() = 0;
  virtual void close() noexcept = 0;
  // For poll() over several; -1: not open.
  virtual int descriptor() const = 0;
  bool is_open() const { return descriptor() >= 0; }

  // All of them. An error: the port is gone, or takes nothing for a tenth of a second.
  [[nodiscard]] drivers::Status send(const std::vector<std::uint8_t>& bytes);
  // Blocks until something has come or the deadline has passed, and appends what is there; nothing:
  // the far end is silent. An error: the port is gone.
  [[nodiscard]] drivers::Status receive(std::vector<std::uint8_t>& bytes, Clock::time_point until);

 protected:
  // Neither blocks. How many were taken, or why none ever will be.
  virtual drivers::Result<std::size_t> write_some(const std::uint8_t* bytes, std::size_t count) = 0;
  // Appends. An error also where the far end has hung up.
  virtual drivers::Status read_some(std::vector<std::uint8_t>& bytes) = 0;
  drivers::Error failure(const std::string& doing, const std::string& why) const {
    return {port_ + ": " + doing + ": " + why};
  }

 private:
  std::string port_;
};

// "tcp://127.0.0.1:5000", or a serial port: "/dev/ttyUSB0".
std::unique_ptr<Transport> make_transport(const std::string& port, int baud = kBaud);

// Whether there is something to open: a device that may be read and written, or a host and a port
// to connect to.
[[nodiscard]] drivers::Status check_port(const std::string& port);

// The serial ports of this machine.
std::vector<std::string> serial_ports();

}  // namespace gsbench::transport
