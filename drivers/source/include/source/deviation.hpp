// Measures how far a played voltage deviates from the stimulus, before anything is played.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <source/source.hpp>

namespace gsbench::source {

// Measures the phase of both voltages once a nominal period, as the Fourier coefficient at nominal
// frequency with a Hann window of two periods. The frequency deviation over 200 ms is the slope of
// the least-squares line through the phase differences. A voltage below 5 % of nominal has no
// phase; windows of 200 ms with such a voltage are left out.
class DeviationMeter {
 public:
  DeviationMeter(std::int64_t sample_rate_hz, int nominal_hz);

  // The next `count` ticks of both voltages, per unit of nominal peak.
  void add(const float* ideal_pu, const float* played_pu, std::size_t count);

  // Largest deviations so far, of frequency and voltage; the time is 0.
  Played largest() const { return largest_; }

 private:
  // Each period is the rising half of one Hann window and the falling half of the one before.
  struct Coefficient {
    std::complex<double> rising;
    std::complex<double> falling;
    std::complex<double> rising_before;

    void add(double voltage_pu, std::complex<double> carrier, double weight) {
      rising += voltage_pu * weight * carrier;
      falling += voltage_pu * (1.0 - weight) * carrier;
    }
    std::complex<double> end_period();
  };

  void end_period();

  std::int64_t period_ticks_;
  double period_s_;
  double step_rad_;
  std::int64_t tick_ = 0;  // within the period
  Coefficient ideal_;
  Coefficient played_;
  std::vector<double> difference_rad_;  // of the newest periods, at most a window
  Played largest_;
};

}  // namespace gsbench::source
