// The played frequency as an exact function of time. All measurements are compared with it.
#pragma once

#include <memory>
#include <vector>

#include <grid/sfr_model.hpp>
#include <recording/trace.hpp>
#include <waveform/oscillation.hpp>

namespace gsbench::waveform {

class ReferenceSignal {
 public:
  virtual ~ReferenceSignal() = default;
  virtual double nominal_hz() const = 0;
  virtual double frequency_hz(double t_s) const = 0;
  virtual double rocof_hz_s(double t_s) const = 0;
  // ∫ (f − nominal) dt from t = 0, in cycles; exact, so that phase never drifts.
  virtual double excess_cycles(double t_s) const = 0;
  // Recorded amplitude, per unit of nominal; 1 if no amplitude was recorded. It is continuous, and
  // linear between corners.
  virtual double voltage_pu(double t_s) const = 0;
  // Times at which f or a derivative of it is discontinuous, ascending. Interpolation must not span
  // them. At a corner, frequency_hz and rocof_hz_s are the right-hand limits. The phase is
  // continuous.
  virtual std::vector<double> corners_s() const = 0;
};

// The frequency after losses of power, from an equilibrium initial_deviation_hz away from nominal.
// A loss at a negative time occurs before the start of the signal; the excess phase still counts
// from t = 0.
std::unique_ptr<ReferenceSignal> reference_from_losses(grid::SfrModel model,
                                                       std::vector<grid::PowerChange> losses,
                                                       double initial_deviation_hz = 0.0);

// The frequency through given points, by monotone cubic interpolation (Fritsch–Carlson, with the
// slopes of Fritsch and Butland, as pchip in MATLAB and SciPy). The curve passes through each point
// without overshoot. It is constant before the first point and after the last. Voltages are
// interpolated linearly. Throws std::invalid_argument if there is no point, times do not increase,
// or a value is not finite and positive; a voltage may be zero.
std::unique_ptr<ReferenceSignal> reference_from_points(double nominal_hz,
                                                       std::vector<recording::TracePoint> points);

// `reference` with oscillations laid over its frequency: the sum of all. Throws
// std::invalid_argument if a value of an oscillation is out of range or not finite.
std::unique_ptr<ReferenceSignal> with_oscillations(std::unique_ptr<ReferenceSignal> reference,
                                                   std::vector<Oscillation> oscillations);

}  // namespace gsbench::waveform
