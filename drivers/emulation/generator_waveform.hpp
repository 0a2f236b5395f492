// The points of an arbitrary waveform, as the DAC of an emulated generator plays them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <emulation/generator.hpp>

namespace gsbench::emulation {

class GeneratorWaveform {
 public:
  // Plays (codes[i] − zero) · scale, −1 … 1. `name`: in the maker's spelling.
  GeneratorWaveform(std::string name, std::vector<std::int16_t> codes, double zero, double scale);

  const std::string& name() const { return name_; }
  std::size_t points() const { return codes_.size(); }
  const std::vector<std::int16_t>& codes() const { return codes_; }
  double value(std::size_t point) const { return (codes_[point] - zero_) * scale_; }

  // The integral from position `from` to `to`, in cycles of the whole waveform, from ≤ to, 0 ≤
  // from. Exact for held and for joined points, so that a mean over any time is exact.
  double integral(double from, double to, Between between) const;

  // The waveform without the bits that the DAC does not have.
  GeneratorWaveform without_bits(int dropped) const;
  // The waveform in a table of `points`: some points are repeated, or left out if it has more.
  GeneratorWaveform in_table(std::size_t points) const;

 private:
  double code_at(std::size_t point) const { return codes_[point == codes_.size() ? 0 : point]; }
  // Of the codes, from `from` to `to` in points, within one cycle.
  double area(double from, double to, Between between) const;

  std::string name_;
  std::vector<std::int16_t> codes_;
  std::vector<std::int64_t> sums_;  // sums_[i]: of the first i codes
  double zero_;
  double scale_;
};

}  // namespace gsbench::emulation
