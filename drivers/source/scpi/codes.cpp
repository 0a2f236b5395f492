#include "codes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gsbench::scpi {
namespace {

constexpr std::uint32_t kNewline = 0x0A;

std::uint32_t word_of(std::int32_t code) {
  return static_cast<std::uint32_t>(code) & 0xFFFFU;
}

bool has_newline(std::int32_t code) {
  const std::uint32_t word = word_of(code);
  return (word & 0xFFU) == kNewline || (word >> 8U) == kNewline;
}

struct CodeRange {
  std::int32_t lowest;
  std::int32_t highest;
  std::int32_t step;
};

CodeRange range_of(const Instrument& instrument) {
  const std::int32_t step = instrument.code_step();
  if (instrument.format.codes == Codes::kUnsigned) {
    return {0, (1 << instrument.format.bits) - 1, step};
  }
  const std::int32_t highest = 32767 / step * step;
  return {-highest, highest, step};
}

// The permitted code that is nearest to `ideal`.
std::int32_t off_newline(double ideal, std::int32_t code, const CodeRange& range) {
  const std::int32_t towards = ideal < code ? -range.step : range.step;
  for (std::int32_t moved = 0; moved <= range.highest - range.lowest; moved += range.step) {
    const std::int32_t steps = moved / range.step;
    for (const std::int32_t candidate : {code + steps * towards, code - steps * towards}) {
      if (candidate >= range.lowest && candidate <= range.highest && !has_newline(candidate)) {
        return candidate;
      }
    }
  }
  return code;
}

}  // namespace

Quantised quantised(const std::vector<float>& voltage, double full_scale,
                    const Instrument& instrument) {
  const CodeRange range = range_of(instrument);
  const double middle = instrument.middle_code();
  const double codes_per_unit = instrument.full_scale_code() / full_scale;
  const bool avoid = instrument.has(Quirk::kAvoidNewline);
  Quantised result;
  result.codes.reserve(voltage.size());
  for (const float value : voltage) {
    const double ideal = middle + static_cast<double>(value) * codes_per_unit;
    // The highest code may be a part of a step below full scale.
    const auto nearest = static_cast<std::int32_t>(
        std::clamp(std::round(ideal / range.step) * range.step, static_cast<double>(range.lowest),
                   static_cast<double>(range.highest)));
    const std::int32_t code =
        avoid && has_newline(nearest) ? off_newline(ideal, nearest, range) : nearest;
    result.largest_nudge = std::max(result.largest_nudge, std::abs(code - nearest));
    result.codes.push_back(code);
  }
  return result;
}

double level_of(std::int32_t code, const Instrument& instrument) {
  return (code - instrument.middle_code()) / instrument.full_scale_code();
}

std::vector<std::uint8_t> bytes_of(const std::int32_t* codes, std::size_t count,
                                   const Instrument& instrument) {
  const bool little = instrument.format.byte_order == ByteOrder::kLittle;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t word = word_of(codes[i]);
    const auto low = static_cast<std::uint8_t>(word & 0xFFU);
    const auto high = static_cast<std::uint8_t>(word >> 8U);
    bytes.push_back(little ? low : high);
    bytes.push_back(little ? high : low);
  }
  return bytes;
}

}  // namespace gsbench::scpi
