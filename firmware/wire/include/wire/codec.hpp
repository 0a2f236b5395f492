// Messages as bytes. Each message is one CBOR array:
//   from the outlet  [kind, sequence, sample, start_number, field, …]
//                    but hello: [1, sequence, sample, field, …]
//   to the outlet    [kind, sequence, session, field, …]
// fields.hpp lists the fields. A reader ignores items after the fields it knows, so that later
// versions can add fields. A message with a field missing or of another type is malformed. Settings
// are one field: a map with the keys of outlet/settings.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <wire/messages.hpp>

namespace gs::wire {

// Lengths in bytes. A link must carry kLongestMessage, the limit for messages of any version; a
// longer message is malformed. The longest message of this version is settings with all their rows.
constexpr std::size_t kLongestMessage = 560;
constexpr std::size_t kLongestOfThisVersion = 537;  // of any values; 535 of those in range
static_assert(kLongestOfThisVersion <= kLongestMessage, "");

enum class Decoded : std::uint8_t {
  kOk = 0,
  kMalformed = 1,    // not an array of the required items, or too long
  kUnknownKind = 2,  // well-formed, but of a kind that is not listed
};

// Returns the number of bytes, at most kLongestMessage; 0 if `capacity` is too small.
std::size_t encode(const Uplink& message, std::uint32_t sequence, std::uint8_t* out,
                   std::size_t capacity);
std::size_t encode(const Downlink& message, std::uint32_t sequence, std::uint8_t* out,
                   std::size_t capacity);

// If the kind is unknown, only the head is set: sequence, and session or sample and start_number.
// If malformed, all is unspecified. Values of a decoded settings message can be out of range: check
// them with outlet::validate.
Decoded decode(const std::uint8_t* bytes, std::size_t size, Uplink& message,
               std::uint32_t& sequence);
Decoded decode(const std::uint8_t* bytes, std::size_t size, Downlink& message,
               std::uint32_t& sequence);

// The settings' map alone, as an outlet stores it. An unknown key makes it malformed.
std::size_t encode(const outlet::Settings& settings, std::uint8_t* out, std::size_t capacity);
Decoded decode(const std::uint8_t* bytes, std::size_t size, outlet::Settings& settings);

}  // namespace gs::wire
