// What Mosquitto reads: its certificate, configuration, passwords and access list.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <emulation/private_broker.hpp>

namespace gsbench::emulation {

constexpr const char* kBenchUser = "bench";

// The files `ca.pem`, `server.pem` and `server.key` in `folder`, with the openssl program: of a
// certificate authority that signs one certificate, for 127.0.0.1, and is then forgotten.
constexpr const char* kCaFile = "/ca.pem";
drivers::Status make_certificates(const std::string& folder);

std::string new_password();

// Files `passwords` and `access` in `folder`.
drivers::Status write_logins(const std::string& folder, const std::vector<Login>& logins);

// File `mosquitto.conf` in `folder`.
drivers::Status write_configuration(const std::string& folder, std::uint16_t port);

std::string text_of(const std::string& file);

}  // namespace gsbench::emulation
