#include "monotone_cubic.hpp"

#include <algorithm>
#include <cmath>

namespace gsbench::waveform {
namespace {

bool same_sign(double a, double b) {
  return (a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0);
}

// Fritsch & Butland (1984): the weighted harmonic mean of the secants on both sides, zero at an
// extremum. It is at most three times the smaller secant, which Fritsch & Carlson (1980) require of
// a monotone piece.
double inner_slope(double width_left, double secant_left, double width_right, double secant_right) {
  if (!same_sign(secant_left, secant_right)) {
    return 0.0;
  }
  const double weight_left = 2.0 * width_right + width_left;
  const double weight_right = width_right + 2.0 * width_left;
  return (weight_left + weight_right) / (weight_left / secant_left + weight_right / secant_right);
}

// At an end: the slope of the parabola through three points, limited to the same bounds.
double end_slope(double width, double secant, double next_width, double next_secant) {
  const double slope =
      ((2.0 * width + next_width) * secant - width * next_secant) / (width + next_width);
  if (!same_sign(slope, secant)) {
    return 0.0;
  }
  if (!same_sign(secant, next_secant) && std::fabs(slope) > 3.0 * std::fabs(secant)) {
    return 3.0 * secant;
  }
  return slope;
}

std::vector<double> monotone_slopes(const std::vector<double>& widths,
                                    const std::vector<double>& secants) {
  const std::size_t pieces = widths.size();
  if (pieces == 0) {
    return {0.0};
  }
  if (pieces == 1) {
    return {secants[0], secants[0]};
  }
  std::vector<double> slopes;
  slopes.reserve(pieces + 1);
  slopes.push_back(end_slope(widths[0], secants[0], widths[1], secants[1]));
  for (std::size_t i = 1; i < pieces; ++i) {
    slopes.push_back(inner_slope(widths[i - 1], secants[i - 1], widths[i], secants[i]));
  }
  slopes.push_back(
      end_slope(widths[pieces - 1], secants[pieces - 1], widths[pieces - 2], secants[pieces - 2]));
  return slopes;
}

// Neumaier summation: the error does not grow with the number of terms.
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    lost_ += std::fabs(sum_) >= std::fabs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0.0;
  double lost_ = 0.0;
};

}  // namespace

MonotoneCubic::MonotoneCubic(const std::vector<Knot>& knots) {
  std::vector<double> widths;
  std::vector<double> secants;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    widths.push_back(knots[i + 1].x - knots[i].x);
    secants.push_back((knots[i + 1].y - knots[i].y) / widths.back());
  }
  const std::vector<double> slopes = monotone_slopes(widths, secants);

  CompensatedSum integral;
  pieces_.reserve(knots.size());
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const double h = widths[i];
    pieces_.push_back({knots[i].x, knots[i].y, slopes[i],
                       (3.0 * secants[i] - 2.0 * slopes[i] - slopes[i + 1]) / h,
                       (slopes[i] + slopes[i + 1] - 2.0 * secants[i]) / (h * h), integral.value()});
    integral.add(h *
                 (0.5 * (knots[i].y + knots[i + 1].y) + h * (slopes[i] - slopes[i + 1]) / 12.0));
  }
  pieces_.push_back({knots.back().x, knots.back().y, 0.0, 0.0, 0.0, integral.value()});
}

const MonotoneCubic::Piece* MonotoneCubic::piece_at(double x) const {
  const auto next = std::upper_bound(pieces_.begin(), pieces_.end(), x,
                                     [](double at, const Piece& piece) { return at < piece.x; });
  return next == pieces_.begin() ? nullptr : &*std::prev(next);
}

double MonotoneCubic::value(double x) const {
  const Piece* piece = piece_at(x);
  if (piece == nullptr) {
    return pieces_.front().y;
  }
  const double s = x - piece->x;
  return piece->y + s * (piece->slope + s * (piece->quadratic + s * piece->cubic));
}

double MonotoneCubic::slope(double x) const {
  const Piece* piece = piece_at(x);
  if (piece == nullptr) {
    return 0.0;
  }
  const double s = x - piece->x;
  return piece->slope + s * (2.0 * piece->quadratic + s * 3.0 * piece->cubic);
}

double MonotoneCubic::integral(double x) const {
  const Piece* piece = piece_at(x);
  if (piece == nullptr) {
    return (x - pieces_.front().x) * pieces_.front().y;
  }
  const double s = x - piece->x;
  return piece->integral_to_here +
         s * (piece->y +
              s * (piece->slope / 2.0 + s * (piece->quadratic / 3.0 + s * (piece->cubic / 4.0))));
}

}  // namespace gsbench::waveform
