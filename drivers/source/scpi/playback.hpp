// What an instrument puts out for a list of codes, and how far it is from the stimulus.
#pragma once

#include "loaded_waveform.hpp"
#include <source_scpi/instrument.hpp>

#include <cstdint>
#include <vector>

#include <source/source.hpp>

namespace gsbench::scpi {

// Voltages are per unit of nominal peak, positions in points. All arguments must outlive it.
class Playback {
 public:
  Playback(const Instrument& instrument, double rate_hz, double full_scale_pu,
           const std::vector<std::int32_t>& codes)
      : instrument_(instrument), rate_hz_(rate_hz), full_scale_pu_(full_scale_pu), codes_(codes) {}

  // Of frequency and voltage, from the stimulus within `ideal`. The frequency is that of the
  // voltage itself, whatever samples it: each tick has the mean over the time around it. `points`:
  // the voltages that the codes stand for.
  source::Played deviation(const source::Stimulus& stimulus, const LoadedWaveform& ideal,
                           const std::vector<float>& points) const;

 private:
  double level(std::size_t point) const;
  double at(double position) const;
  double mean(double from, double to) const;
  double point_error(const std::vector<float>& points) const;

  const Instrument& instrument_;
  double rate_hz_;
  double full_scale_pu_;
  const std::vector<std::int32_t>& codes_;
};

}  // namespace gsbench::scpi
