// An outlet's ADC on its own crystal: resamples the source's samples at the times of the outlet's
// clock. Interpolates with a cubic through the four nearest samples; the error is below 1e-5 of the
// amplitude at the 10th harmonic of 50 Hz and 8 kHz.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <models/noise.hpp>

namespace gsbench::models {

class CrystalAdc {
 public:
  // `ppm`: frequency error of the crystal, positive if fast. noise_rms_pu: noise added to each of
  // the outlet's samples, from the stream `noise`.
  CrystalAdc(double ppm, float counts_per_pu, float noise_rms_pu, Stream noise);

  // Takes the next samples of the source and appends the resulting samples of the outlet.
  void take(const float* voltage_pu, std::size_t count, std::vector<std::int16_t>& samples);

  // Position of the outlet's n-th sample, in ticks of the source, both from 0.
  double tick_of(double sample) const { return sample / rate_; }

 private:
  double rate_;  // samples per tick
  float counts_per_pu_;
  float noise_rms_pu_;
  Stream noise_;
  std::int64_t made_ = 0;        // samples so far
  std::int64_t first_held_ = 0;  // tick of held_[0]
  std::vector<float> held_;      // samples of the source that are still needed
  std::vector<float> volts_;
};

}  // namespace gsbench::models
