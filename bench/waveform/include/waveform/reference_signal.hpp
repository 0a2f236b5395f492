// The frequency that is played, as an exact function of time. Everything measured is compared with
// this and with nothing else.
#pragma once

#include <memory>
#include <vector>

#include <grid/sfr_model.hpp>
#include <recording/trace.hpp>

namespace gsbench::waveform {

class ReferenceSignal {
 public:
  virtual ~ReferenceSignal() = default;
  virtual double nominal_hz() const = 0;
  virtual double frequency_hz(double t_s) const = 0;
  virtual double rocof_hz_s(double t_s) const = 0;
  // ∫ (f − nominal) dt from t = 0, in cycles; exact, so that phase never drifts.
  virtual double excess_cycles(double t_s) const = 0;
  // Amplitude that the recording itself prescribes, per unit of nominal; 1 where it prescribes
  // none. Continuous, and linear between corners.
  virtual double voltage_pu(double t_s) const = 0;
  // Times at which f or one of its derivatives jumps, ascending: interpolation must not reach
  // across them. f itself is continuous; rocof_hz_s at a corner is the right-hand limit.
  virtual std::vector<double> corners_s() const = 0;
};

// A negative time in a loss list is a loss before the start: phase still counts from t = 0.
std::unique_ptr<ReferenceSignal> reference_from_losses(grid::SfrModel model,
                                                       std::vector<grid::PowerChange> losses);

// Monotone cubic interpolation (Fritsch–Carlson, with the slopes of Fritsch and Butland as in
// MATLAB's and SciPy's pchip): it passes through each point and overshoots none. Held constant
// before the first and after the last. Throws std::invalid_argument where there is no point, times
// do not ascend, or a value is not finite and positive; a voltage may be zero, and is interpolated
// linearly.
std::unique_ptr<ReferenceSignal> reference_from_points(double nominal_hz,
                                                       std::vector<recording::TracePoint> points);

}  // namespace gsbench::waveform
