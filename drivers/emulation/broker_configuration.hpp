// Mosquitto's files: certificate, configuration, passwords and access list.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <emulation/private_broker.hpp>

namespace gsbench::emulation {

constexpr const char* kBenchUser = "bench";

// Writes `ca.pem`, `server.pem` and `server.key` to `folder` with the openssl program. The CA signs
// one certificate, for 127.0.0.1; then the key of the CA is deleted.
constexpr const char* kCaFile = "/ca.pem";
drivers::Status make_certificates(const std::string& folder);

std::string new_password();

// Writes `passwords` and `access` to `folder`.
drivers::Status write_logins(const std::string& folder, const std::vector<Login>& logins);

// Writes `mosquitto.conf` to `folder`.
drivers::Status write_configuration(const std::string& folder, std::uint16_t port);

// The content of a file; empty if it cannot be read.
std::string text_of(const std::string& file);

}  // namespace gsbench::emulation
