// Messages as bytes: [kind u8] [number u32] [field] …, little-endian, without gaps. Frames on the
// serial line are those of wire/frame.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include <head/messages.hpp>

namespace gs::head {

// Lengths in bytes.
constexpr std::size_t kHeadLength = 5;
constexpr std::size_t kLongestMessage = kHeadLength + 10 + 2 * kLongestSamples;
constexpr std::size_t kLongestUplink = 80;  // of the messages from the head

struct Header {
  Kind kind = Kind::kStop;
  std::uint32_t number = 0;
};

// Returns false if the bytes are too short for a header. The kind may be an unknown one.
[[nodiscard]] bool decode_header(const std::uint8_t* bytes, std::size_t size, Header& header);

// Returns the number of bytes; 0 if `capacity` is too small, or the message has more than
// kLongestSamples samples. For all message types of messages.hpp.
template <class Message>
std::size_t encode(const Message& message, std::uint32_t number, std::uint8_t* out,
                   std::size_t capacity);

// Returns false, and leaves `message` unspecified, if the bytes are of another kind, are too short
// or too long, or a field is out of its range. Exception: after the protocol version of an identify
// and of another version's hello, any bytes may follow.
template <class Message>
[[nodiscard]] bool decode(const std::uint8_t* bytes, std::size_t size, Message& message);

}  // namespace gs::head
