// Outlets on serial ports, one a port, in frames (wire/frame.hpp). A thread waits for bytes and
// stamps what they bring when it arrives; an outlet that was unplugged is told from one that is
// silent, and is listened to again when its port is back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>

namespace gsbench::link {

constexpr int kSerialBaud = 921600;  // 8 data bits, no parity, 1 stop bit, no flow control

struct SerialOptions {
  std::vector<std::string> ports;  // "/dev/ttyUSB0", in the order of the outlets
  std::vector<std::string> ids;    // whom a port without an answer is told for; none: the port
  int baud = kSerialBaud;
  double answer_s = 3.0;  // within which each outlet says who it is
  // A port without an outlet is left out instead of at fault: for looking what is there.
  bool skip_silent = false;
};

class SerialLink final : public Link {
 public:
  explicit SerialLink(SerialOptions options);
  ~SerialLink() override;

  std::string name() const override { return "serial"; }
  // A port that is not there is an error, unless it would be left out.
  [[nodiscard]] drivers::Result<std::vector<OutletPresence>> open() override;
  [[nodiscard]] drivers::Status send(std::size_t outlet,
                                     const gs::wire::Downlink& message) override;
  [[nodiscard]] drivers::Status poll(std::vector<Received>& messages,
                                     std::vector<Fault>& faults) override;
  void close() noexcept override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The serial ports of this machine.
std::vector<std::string> serial_ports();

}  // namespace gsbench::link
