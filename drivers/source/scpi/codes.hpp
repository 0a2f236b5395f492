// From voltage to the codes of a DAC and to bytes.
#pragma once

#include <source_scpi/instrument.hpp>

#include <cstdint>
#include <vector>

namespace gsbench::scpi {

struct Quantised {
  std::vector<std::int32_t> codes;
  std::int32_t largest_nudge = 0;  // of codes moved off a forbidden byte, in codes
};

// `full_scale`: the voltage of the highest code, in the unit of `voltage`. Voltages are within it.
Quantised quantised(const std::vector<float>& voltage, double full_scale,
                    const Instrument& instrument);

// The voltage of a code, if the highest has 1.
double level_of(std::int32_t code, const Instrument& instrument);

// Two bytes a code, in the instrument's order.
std::vector<std::uint8_t> bytes_of(const std::int32_t* codes, std::size_t count,
                                   const Instrument& instrument);

}  // namespace gsbench::scpi
