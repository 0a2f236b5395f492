#include "generator_waveform.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gsbench::emulation {

GeneratorWaveform::GeneratorWaveform(std::string name, std::vector<std::int16_t> codes, double zero,
                                     double scale)
    : name_(std::move(name)), codes_(std::move(codes)), zero_(zero), scale_(scale) {
  sums_.reserve(codes_.size() + 1);
  sums_.push_back(0);
  for (const std::int16_t code : codes_) {
    sums_.push_back(sums_.back() + code);
  }
}

double GeneratorWaveform::area(double from, double to, Between between) const {
  const std::size_t last = codes_.size() - 1;
  const std::size_t first_point = std::min(static_cast<std::size_t>(from), last);
  const std::size_t last_point = std::min(static_cast<std::size_t>(to), last);
  // Of the part a … b, 0 … 1, that follows a point.
  const auto part = [&](std::size_t point, double a, double b) {
    const double step = between == Between::kLine ? code_at(point + 1) - code_at(point) : 0.0;
    return code_at(point) * (b - a) + step * (b * b - a * a) / 2;
  };
  const double a = from - static_cast<double>(first_point);
  const double b = to - static_cast<double>(last_point);
  if (first_point == last_point) {
    return part(first_point, a, b);
  }
  double whole = static_cast<double>(sums_[last_point] - sums_[first_point + 1]);
  if (between == Between::kLine) {
    whole += (code_at(last_point) - code_at(first_point + 1)) / 2;
  }
  return part(first_point, a, 1.0) + whole + part(last_point, 0.0, b);
}

double GeneratorWaveform::integral(double from, double to, Between between) const {
  const double points = static_cast<double>(codes_.size());
  const double first_cycle = std::floor(from);
  const double last_cycle = std::floor(to);
  const double start = (from - first_cycle) * points;
  const double end = (to - last_cycle) * points;
  double codes = 0;
  if (first_cycle == last_cycle) {
    codes = area(start, end, between);
  } else {
    codes = area(start, points, between) + area(0, end, between) +
            (last_cycle - first_cycle - 1) * static_cast<double>(sums_.back());
  }
  return (codes / points - zero_ * (to - from)) * scale_;
}

GeneratorWaveform GeneratorWaveform::without_bits(int dropped) const {
  std::vector<std::int16_t> codes = codes_;
  const int step = 1 << dropped;
  for (std::int16_t& code : codes) {
    code = static_cast<std::int16_t>(code & ~(step - 1));
  }
  return {name_, std::move(codes), zero_, scale_};
}

GeneratorWaveform GeneratorWaveform::in_table(std::size_t points) const {
  std::vector<std::int16_t> codes(points);
  for (std::size_t i = 0; i < points; ++i) {
    codes[i] = codes_[i * codes_.size() / points];
  }
  return {name_, std::move(codes), zero_, scale_};
}

}  // namespace gsbench::emulation
