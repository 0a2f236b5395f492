// How a head plays a stimulus: amplitude, and the deviation from the stimulus.
#pragma once

#include <head_driver/head.hpp>

#include <cstdint>
#include <string>

#include <drivers/result.hpp>
#include <head/interpolator.hpp>
#include <source/source.hpp>

namespace gsbench::head {

// The stream is sent this long before it is played. Less than the head's watchdog, 0.2 s: a bench
// that is silent for longer has lost its output in any case.
constexpr double kAhead_s = 0.15;
constexpr double kRamp_s = 0.5;
constexpr std::int64_t kRampSamples = static_cast<std::int64_t>(kRamp_s * gs::head::kSampleRate_hz);

// Between volts at the outlets, per unit of the nominal peak, and samples of the stream.
class Amplitude {
 public:
  explicit Amplitude(const HeadOptions& options);

  double nominal_peak_v() const { return nominal_peak_v_; }
  // Largest voltage: what the DAC can play, or the voltage limit if that is less.
  double full_scale_pu() const;
  double dac_full_scale_pu() const { return dac_full_scale_pu_; }
  double voltage_limit_pu() const { return voltage_limit_pu_; }
  double step_pu() const { return 16.0 / samples_per_pu_; }  // of the DAC
  double samples_per_pu() const { return samples_per_pu_; }
  // Only up to full_scale_pu().
  std::int16_t sample(double voltage_pu) const;

 private:
  double nominal_peak_v_;
  double dac_full_scale_pu_;
  double voltage_limit_pu_;
  double samples_per_pu_;
};

// An error if an option is out of its range, or nominal voltage is beyond full scale.
drivers::Status check(const HeadOptions& options);

// Computes all codes of the DAC with the firmware's own interpolator.
source::Played deviation(const HeadOptions& options, const source::Stimulus& stimulus);

}  // namespace gsbench::head
