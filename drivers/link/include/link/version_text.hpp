// Versions for people.
#pragma once

#include <cstdint>
#include <string>

#include <wire/messages.hpp>

namespace gsbench::link {

// "0.1.0" of major·10⁶ + minor·10³ + patch.
inline std::string version_text(std::uint32_t version) {
  return std::to_string(version / 1000000) + "." + std::to_string(version / 1000 % 1000) + "." +
         std::to_string(version % 1000);
}

// Of another protocol's hello nothing is known but who says it (wire/README.md). Empty: it is ours.
inline std::string protocol_fault(const gs::wire::Hello& hello) {
  if (hello.protocol_version == gs::wire::kProtocolVersion) {
    return {};
  }
  return "speaks protocol " + std::to_string(hello.protocol_version) + ", not " +
         std::to_string(gs::wire::kProtocolVersion);
}

}  // namespace gsbench::link
