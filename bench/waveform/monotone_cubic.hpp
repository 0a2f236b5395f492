// Piecewise cubic through given points, with its exact slope and integral. Between neighbouring
// points, it stays within the range of their values. It is constant before the first point and
// after the last.
#pragma once

#include <cstddef>
#include <vector>

namespace gsbench::waveform {

struct Knot {
  double x;
  double y;
};

class MonotoneCubic {
 public:
  // knots: at least one, x strictly increasing, all finite.
  explicit MonotoneCubic(const std::vector<Knot>& knots);

  double value(double x) const;
  double slope(double x) const;     // right-hand limit
  double integral(double x) const;  // from the first knot

 private:
  // The value at x is y + s·(slope + s·(quadratic + s·cubic)), with s = x − Piece::x. The last
  // piece is constant.
  struct Piece {
    double x, y, slope, quadratic, cubic, integral_to_here;
  };

  const Piece* piece_at(double x) const;  // nullptr if x is before the first knot

  std::vector<Piece> pieces_;
};

}  // namespace gsbench::waveform
