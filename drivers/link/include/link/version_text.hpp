// A firmware's version for people: "0.1.0" of major·10⁶ + minor·10³ + patch.
#pragma once

#include <cstdint>
#include <string>

namespace gsbench::link {

inline std::string version_text(std::uint32_t version) {
  return std::to_string(version / 1000000) + "." + std::to_string(version / 1000 % 1000) + "." +
         std::to_string(version % 1000);
}

}  // namespace gsbench::link
