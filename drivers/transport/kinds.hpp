// The two transports: a serial port through libserialport (raw, 8N1, locked against other
// programs), and a TCP connection to an emulated outlet or a serial device server.
#pragma once

#include <transport/transport.hpp>

namespace gsbench::transport {

std::unique_ptr<Transport> make_serial(const std::string& port, int baud);

// An error if `port` is not of the form tcp://host:port.
drivers::Status check_address(const std::string& port);
std::unique_ptr<Transport> make_tcp(const std::string& port);

}  // namespace gsbench::transport
