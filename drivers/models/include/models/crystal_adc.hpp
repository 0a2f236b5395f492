// An outlet's ADC on its own crystal: the source's samples, read where the outlet's clock has its
// own. Between samples a cubic through the four nearest, right within
// 1e-5 of the amplitude at the 10th harmonic of 50 Hz and 8 kHz.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <models/noise.hpp>

namespace gsbench::models {

class CrystalAdc {
 public:
  // `ppm`: by how much the crystal is fast. Noise is the outlet's own, drawn for each of its
  // samples.
  CrystalAdc(double ppm, float counts_per_pu, float noise_rms_pu, Stream noise);

  // Takes the source's next samples; appends the outlet's own that they make.
  void take(const float* voltage_pu, std::size_t count, std::vector<std::int16_t>& samples);

  // Where on the source's ticks the outlet's n-th sample is, from the first that take() gave.
  double tick_of(double sample) const { return sample / rate_; }

 private:
  double rate_;  // samples a tick
  float counts_per_pu_;
  float noise_rms_pu_;
  Stream noise_;
  std::int64_t made_ = 0;        // samples so far
  std::int64_t first_held_ = 0;  // tick of held_[0]
  std::vector<float> held_;      // the source's samples that are still needed
  std::vector<float> volts_;
};

}  // namespace gsbench::models
