// Properties that must hold for any bytes received over a link or found in the storage of the
// settings. Each function returns what is wrong, or an empty string.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gsbench::fuzz {

// A stream of bytes from a serial line: messages that the frame reader finds can be framed again,
// there are at most as many frames as zeros, no buffer overflows, and a valid frame after the
// stream is found.
std::string wrong_with_stream(const std::uint8_t* bytes, std::size_t size);

// One message: what can be decoded is encoded into at most as many bytes and decoded to the same
// message again. An outlet that receives it continues and sends only messages that can be decoded.
std::string wrong_with_message(const std::uint8_t* bytes, std::size_t size);

// Encoded settings: decoded settings keep their digest; valid ones can be put into force.
std::string wrong_with_settings(const std::uint8_t* bytes, std::size_t size);

// A settings storage with these bytes in its two slots: loading is repeatable, and new settings can
// be stored whatever the contents.
std::string wrong_with_flash(const std::uint8_t* bytes, std::size_t size);

// Messages for a DAC head: a message that is not accepted has no effect on its output, stop always
// has one, and the head sends only messages that can be decoded.
std::string wrong_with_head(const std::uint8_t* bytes, std::size_t size);
std::vector<std::string> head_seeds();

// Each of the above with its seeds.
struct WireFuzzer {
  const char* name;
  std::string (*wrong_with)(const std::uint8_t* bytes, std::size_t size);
  std::vector<std::string> (*seeds)();  // real inputs
};

const std::vector<WireFuzzer>& wire_fuzzers();

}  // namespace gsbench::fuzz
