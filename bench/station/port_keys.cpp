#include "port_keys.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <transport/transport.hpp>

namespace gsbench::station {
namespace {

constexpr int kBauds[] = {1200,    2400,    4800,    9600,    19200,   38400,   57600,
                          115200,  230400,  460800,  500000,  576000,  921600,  1000000,
                          1152000, 1500000, 2000000, 2500000, 3000000, 3500000, 4000000};

}  // namespace

void require_port(const keys::Table& table, const std::string& key, keys::Position at,
                  const std::string& port) {
  if (!transport::check_form(port).ok()) {
    table.refuse(at, fmt::format("{} is \"{}\"; it must be tcp://host:port, with a port from 1 to "
                                 "65535, or the path of a device such as /dev/ttyUSB0",
                                 key, port));
  }
}

void require_port(const keys::Table& table, const std::string& key) {
  require_port(table, key, table.at(key), table.text(key));
}

int read_baud(const keys::Table& table) {
  const auto baud = static_cast<int>(table.whole("baud"));
  if (std::find(std::begin(kBauds), std::end(kBauds), baud) == std::end(kBauds)) {
    table.refuse("baud", fmt::format("baud is {}, which no serial port has; it must be one of {}",
                                     baud, fmt::join(kBauds, ", ")));
  }
  return baud;
}

}  // namespace gsbench::station
