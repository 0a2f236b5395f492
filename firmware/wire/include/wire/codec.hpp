// Messages as bytes: one CBOR array each,
//   from the outlet  [kind, sequence, sample, field, …]
//   to the outlet    [kind, sequence, field, …]
// with the fields of fields.hpp. A reader passes over what stands behind the fields it knows, so
// that later versions can add some; what is missing or of another type makes a message malformed.
// Settings are one field, a map by the keys of outlet/settings.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <wire/messages.hpp>

namespace gs::wire {

// What any version may say at most, and what a link must carry; the settings with all their rows
// are this version's longest.
constexpr std::size_t kLongestMessage = 560;
constexpr std::size_t kLongestOfThisVersion = 482;
static_assert(kLongestOfThisVersion <= kLongestMessage, "");

enum class Decoded : std::uint8_t {
  kOk = 0,
  kMalformed = 1,    // no array of the right items
  kUnknownKind = 2,  // well-formed, of a kind that is none of ours
};

// Returns the number of bytes, at most kLongestMessage; 0 where `capacity` is too small.
std::size_t encode(const Uplink& message, std::uint32_t sequence, std::uint8_t* out,
                   std::size_t capacity);
std::size_t encode(const Downlink& message, std::uint32_t sequence, std::uint8_t* out,
                   std::size_t capacity);

// What is not kOk leaves `message` in no particular state. A settings message that decodes is
// well-formed, not sensible: outlet::validate says that.
Decoded decode(const std::uint8_t* bytes, std::size_t size, Uplink& message,
               std::uint32_t& sequence);
Decoded decode(const std::uint8_t* bytes, std::size_t size, Downlink& message,
               std::uint32_t& sequence);

// Settings alone, as an outlet keeps them: their map. A key that is not known makes them malformed.
std::size_t encode(const outlet::Settings& settings, std::uint8_t* out, std::size_t capacity);
Decoded decode(const std::uint8_t* bytes, std::size_t size, outlet::Settings& settings);

}  // namespace gs::wire
