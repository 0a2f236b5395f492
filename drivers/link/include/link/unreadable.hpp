// Why a message from an outlet cannot be read, for those who write its firmware.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <wire/messages.hpp>

namespace gsbench::link {

// The fault of an outlet that has sent this message, which gs::wire::decode() refuses as malformed:
// "its hello cannot be read: nominal_hz is 55, not 50 or 60",
// "sent a message that cannot be read: status, cause is 9, not 0 … 3".
std::string unreadable_fault(const std::uint8_t* message, std::size_t size);

// The names of a message's fields in their order on the wire, as in wire/README.md; without its
// head.
std::vector<std::string> field_names(gs::wire::UplinkKind kind);

}  // namespace gsbench::link
