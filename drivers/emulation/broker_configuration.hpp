// What Mosquitto reads: its configuration, passwords and access list.
#pragma once

#include "broker_certificates.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <emulation/private_broker.hpp>

namespace gsbench::emulation {

constexpr const char* kBenchUser = "bench";

std::string new_password();

// Files `passwords` and `access` in `folder`.
drivers::Status write_logins(const std::string& folder, const std::vector<Login>& logins);

// File `mosquitto.conf`, returned.
drivers::Result<std::string> write_configuration(const std::string& folder, std::uint16_t port,
                                                 const std::optional<Certificates>& certificates);

}  // namespace gsbench::emulation
