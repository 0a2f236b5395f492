// What Mosquitto reads: its certificate, configuration, passwords and access list.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <emulation/private_broker.hpp>

namespace gsbench::emulation {

constexpr const char* kBenchUser = "bench";

// Of a certificate authority that signs one server certificate and is then forgotten.
struct Certificates {
  std::string ca_file;
  std::string server_file;
  std::string server_key_file;
};

// For 127.0.0.1, elliptic curve P-256, with the openssl program.
drivers::Result<Certificates> make_certificates(const std::string& folder);

std::string new_password();

// Files `passwords` and `access` in `folder`.
drivers::Status write_logins(const std::string& folder, const std::vector<Login>& logins);

// File `mosquitto.conf` in `folder`.
drivers::Status write_configuration(const std::string& folder, std::uint16_t port,
                                    const std::optional<Certificates>& certificates);

}  // namespace gsbench::emulation
