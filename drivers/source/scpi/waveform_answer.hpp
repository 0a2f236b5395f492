// An answer with a waveform: "…,LENGTH,<n>B,…,WAVEDATA,", n bytes, and a newline.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::scpi {

struct WaveformHeader {
  std::size_t data = 0;   // position of the first byte
  std::size_t bytes = 0;  // their number
};

// `received`: the beginning of an answer. nullopt: the header is not complete yet. An error if it
// is longer than 1000 bytes, or states no number of bytes.
drivers::Result<std::optional<WaveformHeader>> waveform_header(
    const std::vector<std::uint8_t>& received);

}  // namespace gsbench::scpi
