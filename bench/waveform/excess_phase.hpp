// The phase of the samples: the phase of the nominal frequency plus the excess phase of the
// reference. The excess phase is the integral of the deviation from nominal frequency. Between
// corners (times at which the frequency or a derivative of it is discontinuous) it is approximated
// by polynomials, because evaluating the reference at every sample would cost more than the rest of
// the synthesis.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <waveform/reference_signal.hpp>

namespace gsbench::waveform {

// Phase of the nominal frequency at a tick. It is computed in integer arithmetic, so its error does
// not grow with time.
class NominalPhase {
 public:
  // A double is mantissa·2^exponent, so nominal/rate is a fraction of integers. nominal_hz >= 1.
  NominalPhase(double nominal_hz, std::int64_t sample_rate_hz) {
    int exponent = 0;
    const double mantissa = std::frexp(nominal_hz, &exponent);
    numerator_ = static_cast<std::uint64_t>(std::ldexp(mantissa, kMantissaBits));
    denominator_ = static_cast<Wide>(sample_rate_hz) << (kMantissaBits - exponent);
  }

  // The fraction of a cycle, exact up to the final rounding; within [0, 1]. tick >= 0.
  double cycles_at(std::int64_t tick) const {
    const Wide remainder = static_cast<Wide>(tick) * numerator_ % denominator_;
    return static_cast<double>(remainder) / static_cast<double>(denominator_);
  }

 private:
  using Wide = unsigned __int128;
  static constexpr int kMantissaBits = 53;

  Wide numerator_ = 0;    // < 2⁵³, so that the product with a tick fits in 128 bits
  Wide denominator_ = 1;  // < 2⁷³ for rates up to 1 MHz
};

// A piece without corners, from position start to start+length, in samples from tick 0. Along it, u
// runs from 0 to 1. The excess phase is a quintic in u, which has the phase, frequency and ROCOF of
// the reference at both ends. If the reference interpolates frequency points, f is a cubic and the
// quintic is exact. Otherwise the error is h⁶/46080·|d⁵f/dt⁵| for a piece of duration h. It is
// below 10⁻¹² cycles for h = 16 ms and time constants of about 1 s, which are those of a power
// system, and below 10⁻⁸ cycles for an oscillation of 1 Hz at 5 Hz.
struct SmoothPiece {
  double start;
  double length;
  double excess_at_start;        // cycles
  double cycles_at_start;        // its fraction, within [0, 1)
  std::array<double, 5> cycles;  // coefficients of u … u⁵, added to cycles_at_start
  double voltage_pu;             // at u = 0
  double voltage_slope_pu;       // per u
};

// Divides blocks of samples into pieces at the reference's corners.
class ExcessPhase {
 public:
  ExcessPhase(const ReferenceSignal& reference,
              std::int64_t sample_rate_hz);  // `reference` must outlive this

  // The start or end of a piece. At a corner, frequency or ROCOF differ on its two sides.
  struct Edge {
    double position;  // in samples from tick 0
    double t_s;
    double before_s;  // time for the left-hand limit of the reference
    double after_s;   // time for the right-hand limit
  };

  Edge edge_at(std::int64_t tick) const;

  // The next corner after `edge`, or the end of the block.
  Edge next_edge(const Edge& edge, std::int64_t block_end_tick) const;

  SmoothPiece piece(const Edge& from, const Edge& to) const;

 private:
  // One or more corners of the ReferenceSignal that have the same position after rounding.
  struct Corner {
    double position;  // in samples from tick 0
    double first_s;
    double last_s;
  };

  Edge edge_at(const Corner& corner) const;

  const ReferenceSignal& reference_;
  double sample_rate_hz_;
  std::vector<Corner> corners_;
};

}  // namespace gsbench::waveform
