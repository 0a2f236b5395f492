// What must hold for any bytes that reach an outlet or the bench over a link, or that an outlet
// finds where it keeps its settings. Each says what is wrong; empty where all is right.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gsbench::fuzz {

// A stream of bytes from a serial line: what the frame reader finds is framed as such again, each
// frame costs zeros, nothing is written beyond a buffer, and a whole frame behind it is found.
std::string wrong_with_stream(const std::uint8_t* bytes, std::size_t size);

// One message: what decodes, encodes into no more bytes and decodes to the same again; an outlet
// that is sent it goes on and says nothing that cannot be read.
std::string wrong_with_message(const std::uint8_t* bytes, std::size_t size);

// Settings as they are kept: what decodes keeps its digest; what is valid besides can be followed.
std::string wrong_with_settings(const std::uint8_t* bytes, std::size_t size);

// A settings storage whose two slots hold these bytes: what it loads it loads again, and new
// settings can be kept whatever was there.
std::string wrong_with_flash(const std::uint8_t* bytes, std::size_t size);

// Each of the above with what to start from.
struct WireFuzzer {
  const char* name;
  std::string (*wrong_with)(const std::uint8_t* bytes, std::size_t size);
  std::vector<std::string> (*seeds)();  // real ones
};

const std::vector<WireFuzzer>& wire_fuzzers();

}  // namespace gsbench::fuzz
