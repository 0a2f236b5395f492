// The phase to play: that of the nominal frequency, and what the reference adds to it between two
// instants without a corner in between, as polynomials: evaluating the reference itself at every
// sample would cost more than everything else together.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <waveform/reference_signal.hpp>

namespace gsbench::waveform {

// Phase of the nominal frequency at a tick, by integers only: it is as exact after a thousand hours
// as at the start.
class NominalPhase {
 public:
  // A double is mantissa·2^exponent: nominal/rate is a fraction of integers. nominal_hz >= 1.
  NominalPhase(double nominal_hz, std::int64_t sample_rate_hz) {
    int exponent = 0;
    const double mantissa = std::frexp(nominal_hz, &exponent);
    numerator_ = static_cast<std::uint64_t>(std::ldexp(mantissa, kMantissaBits));
    denominator_ = static_cast<Wide>(sample_rate_hz) << (kMantissaBits - exponent);
  }

  // Within [0, 1], rounded from the exact fraction of a cycle. tick >= 0.
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

// Over positions start … start+length, in samples from tick 0; u runs from 0 to 1.
// The quintic takes phase, frequency and ROCOF of the reference at both ends. Between break points,
// where f is a cubic, that is exact; else its error is h⁶/46080·|d⁵f/dt⁵|: for h = 16 ms and the
// 1/s rates of a power system below 10⁻¹² cycles.
struct SmoothPiece {
  double start;
  double length;
  double cycles_at_start;        // excess, within [0, 1)
  std::array<double, 5> cycles;  // of u … u⁵, beyond cycles_at_start
  double voltage_pu;             // at u = 0
  double voltage_slope_pu;       // per u
};

// Cuts blocks of samples at the reference's corners.
class ExcessPhase {
 public:
  ExcessPhase(const ReferenceSignal& reference,
              std::int64_t sample_rate_hz);  // `reference` must outlive this

  // An instant that a piece begins or ends at. At a corner ROCOF differs on its two sides.
  struct Edge {
    double position;  // in samples from tick 0
    double t_s;
    double before_s;  // where the reference's left-hand limit is to be had
    double after_s;   // the right-hand one
  };

  Edge edge_at(std::int64_t tick) const;

  // The corner that comes next after `edge`, or the end of the block.
  Edge next_edge(const Edge& edge, std::int64_t block_end_tick) const;

  SmoothPiece piece(const Edge& from, const Edge& to) const;

 private:
  // ReferenceSignal's corners that fall on one position once it is rounded.
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
