// The truth between two instants without a corner in between, as polynomials: evaluating the truth
// itself at every sample would cost more than everything else together.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <waveform/truth.hpp>

namespace gsbench::waveform {

// Over positions start … start+length, in samples from the block's first one; u runs from 0 to 1.
// The quintic takes phase, frequency and ROCOF of the truth at both ends. Between break points,
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

// Cuts blocks of samples at the truth's corners.
class ExcessPhase {
 public:
  ExcessPhase(const Truth& truth, std::int64_t sample_rate_hz);  // `truth` must outlive this

  // An instant that a piece begins or ends at. At a corner ROCOF differs on its two sides.
  struct Edge {
    double position;  // in samples, from the block's first one
    double t_s;
    double before_s;  // where the truth's left-hand limit is to be had
    double after_s;   // the right-hand one
  };

  Edge edge_at(std::int64_t tick, std::int64_t block_tick) const;

  // The corner that comes next after `edge`, or the end of the block.
  Edge next_edge(const Edge& edge, std::int64_t block_tick, std::int64_t block_end_tick) const;

  SmoothPiece piece(const Edge& from, const Edge& to) const;

 private:
  // Truth's corners that fall on one position once it is rounded.
  struct Corner {
    double position;  // in samples from tick 0
    double first_s;
    double last_s;
  };

  Edge edge_at(const Corner& corner, std::int64_t block_tick) const;

  const Truth& truth_;
  double sample_rate_hz_;
  std::vector<Corner> corners_;
};

}  // namespace gsbench::waveform
