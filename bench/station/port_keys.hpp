// What all keys of ports and baud rates have in common.
#pragma once

#include <string>

#include <keys/table.hpp>

namespace gsbench::station {

// Refuse values that no port can have, with file, line and column. `key`: for the message; `at`: of
// the value.
void require_port(const keys::Table& table, const std::string& key, keys::Position at,
                  const std::string& port);
void require_port(const keys::Table& table, const std::string& key);
// Of a serial port: the rates of Linux.
int read_baud(const keys::Table& table);

}  // namespace gsbench::station
