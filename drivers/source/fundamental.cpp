#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <source/fundamental.hpp>

namespace gsbench::source {
namespace {

constexpr double kTau = 6.283185307179586;

}  // namespace

std::int64_t repeats_after(std::int64_t sample_rate_hz, int nominal_hz) {
  return sample_rate_hz / std::gcd(sample_rate_hz, std::int64_t{nominal_hz});
}

std::complex<double> fundamental_pu(const Stimulus& stimulus, std::int64_t tick) {
  const std::int64_t rate_hz = stimulus.sample_rate_hz();
  const std::int64_t total = stimulus.total_ticks();
  const std::int64_t longest = repeats_after(rate_hz, stimulus.nominal_hz());
  const std::int64_t first = std::max<std::int64_t>(tick - longest, 0);
  std::vector<float> voltage_pu(static_cast<std::size_t>(std::min(longest, total - first)));
  stimulus.render(first, voltage_pu.size(), voltage_pu.data());
  const auto step_rad = [&](std::int64_t at) {
    return kTau * stimulus.frequency_hz(std::min(at, total - 1)) / static_cast<double>(rate_hz);
  };
  double angle_rad = 0.0;  // relative to `tick`
  for (std::int64_t at = first; at < tick; ++at) {
    angle_rad -= step_rad(at);
  }
  // v ≈ Re(z·e) with the smallest squared error: z·Σe² + z*·n = 2·Σv·e.
  std::complex<double> squares;
  std::complex<double> products;
  for (std::size_t n = 0; n < voltage_pu.size(); ++n) {
    const std::complex<double> turned = std::polar(1.0, angle_rad);
    squares += turned * turned;
    products += turned * static_cast<double>(voltage_pu[n]);
    angle_rad += step_rad(first + static_cast<std::int64_t>(n));
  }
  const auto count = static_cast<double>(voltage_pu.size());
  const double determinant = count * count - std::norm(squares);
  return determinant > 0.0
             ? 2.0 * (count * std::conj(products) - std::conj(squares) * products) / determinant
             : 0.0;
}

double soft(double part) {
  return 0.5 - 0.5 * std::cos(0.5 * kTau * std::clamp(part, 0.0, 1.0));
}

}  // namespace gsbench::source
