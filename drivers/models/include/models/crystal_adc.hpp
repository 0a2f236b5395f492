// An outlet's ADC on its own crystal. It resamples the source's samples at the times of the
// outlet's clock. It interpolates with a cubic through the four nearest samples. At 8 kHz, for the
// 10th harmonic of 50 Hz, the error is below 1e-5 of the amplitude. It has no anti-aliasing filter:
// of a source with a higher rate, content above half the outlet's rate must be removed before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <models/noise.hpp>

namespace gsbench::models {

class CrystalAdc {
 public:
  // `ppm`: frequency error of the crystal, positive if fast. `noise_rms_pu`: RMS of the noise added
  // to the outlet's samples. The stream `noise` supplies the noise. `samples_per_tick`: sample rate
  // of the outlet, as nominal, over the rate of the source's samples.
  CrystalAdc(double ppm, float counts_per_pu, float noise_rms_pu, Stream noise,
             double samples_per_tick = 1.0);

  // Takes the next samples of the source and appends the resulting samples of the outlet.
  void take(const float* voltage_pu, std::size_t count, std::vector<std::int16_t>& samples);

  // Time of the outlet's sample number `sample`, in ticks of the source. Samples and ticks count
  // from 0.
  double tick_of(double sample) const { return sample / rate_; }

 private:
  double rate_;  // samples per tick
  float counts_per_pu_;
  float noise_rms_pu_;
  Stream noise_;
  std::int64_t made_ = 0;        // samples of the outlet so far
  std::int64_t first_held_ = 0;  // tick of held_[0]
  std::vector<float> held_;      // samples of the source that are still needed
  std::vector<float> volts_;
};

}  // namespace gsbench::models
