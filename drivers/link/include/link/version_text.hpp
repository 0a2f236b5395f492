// Versions as text.
#pragma once

#include <cstdint>
#include <string>

#include <wire/messages.hpp>

namespace gsbench::link {

// Text such as "0.1.0". `version` is major·10⁶ + minor·10³ + patch.
inline std::string version_text(std::uint32_t version) {
  return std::to_string(version / 1000000) + "." + std::to_string(version / 1000 % 1000) + "." +
         std::to_string(version % 1000);
}

// The fault of an outlet with another protocol version than the bench; empty: same version. With
// another version, only the identity in a hello can be read (wire/README.md).
inline std::string protocol_fault(const gs::wire::Hello& hello) {
  if (hello.protocol_version == gs::wire::kProtocolVersion) {
    return {};
  }
  return "uses protocol version " + std::to_string(hello.protocol_version) + ", not " +
         std::to_string(gs::wire::kProtocolVersion);
}

}  // namespace gsbench::link
