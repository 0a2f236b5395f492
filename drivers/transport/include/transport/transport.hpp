// A byte stream to one outlet or instrument: a serial port or a TCP connection. Errors name the
// port, the operation and the reason. Used by one thread at a time.
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

// Default rate of serial ports; 8 data bits, no parity, 1 stop bit, no flow control.
constexpr int kBaud = 921600;

class Transport {
 public:
  explicit Transport(std::string port) : port_(std::move(port)) {}
  virtual ~Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  const std::string& port() const { return port_; }  // as given to make_transport()

  // Opens the port and discards bytes received earlier. Blocks for 0.5 s at most for each address
  // tried, plus the time to look up a host name.
  [[nodiscard]] virtual drivers::Status open() = 0;
  virtual void close() noexcept = 0;
  // For poll(); -1: not open.
  virtual int descriptor() const = 0;
  bool is_open() const { return descriptor() >= 0; }

  // Sends all bytes. An error if the port is gone, or accepts no data for `patience`.
  [[nodiscard]] drivers::Status send(
      const std::vector<std::uint8_t>& bytes,
      std::chrono::milliseconds patience = std::chrono::milliseconds(100));
  // Blocks until bytes arrive or the deadline `until` passes. Appends the bytes; none if the far
  // end is silent. Returns an error if the port is gone.
  [[nodiscard]] drivers::Status receive(std::vector<std::uint8_t>& bytes, Clock::time_point until);

 protected:
  // Returns the number of bytes accepted, or an error if the port is gone. Does not block.
  virtual drivers::Result<std::size_t> write_some(const std::uint8_t* bytes, std::size_t count) = 0;
  // Appends the bytes that have arrived. Does not block. Returns an error if the port is gone or
  // the far end has hung up.
  virtual drivers::Status read_some(std::vector<std::uint8_t>& bytes) = 0;
  drivers::Error failure(const std::string& doing, const std::string& why) const {
    return {port_ + ": " + doing + ": " + why};
  }

 private:
  std::string port_;
};

// `port`: "tcp://127.0.0.1:5000" and other forms of transport::read_address(), or a serial port:
// "/dev/ttyUSB0".
std::unique_ptr<Transport> make_transport(const std::string& port, int baud = kBaud);

// Whether `port` begins with tcp://, in upper or lower case.
bool is_tcp(const std::string& port);

// The same text for all forms of a TCP address: "tcp://host:5000". Other ports as they are.
std::string in_one_form(const std::string& port);

// An error if `port` is neither of the form tcp://host:port nor the absolute path of a device.
// Looks at nothing but the text.
[[nodiscard]] drivers::Status check_form(const std::string& port);

// An error if `port` is neither a device that may be read and written nor of the form
// tcp://host:port. Does not open it.
[[nodiscard]] drivers::Status check_port(const std::string& port);

// The addresses that the name of a host leads to: "127.0.0.1", "::1"; the name itself if it cannot
// be looked up. An IPv6 address may have brackets. Blocks for the look-up.
std::vector<std::string> addresses_of(const std::string& host);

// The serial ports of this machine.
std::vector<std::string> serial_ports();

}  // namespace gsbench::transport
