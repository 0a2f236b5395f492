#include "resample.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gsbench::scpi {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kHalfWidth = 32;
constexpr double kBeta = 11.0;
constexpr int kMostPhases = 64;
// Part of the half of the new rate that is kept when it is the lower one.
constexpr double kKept = 0.9;

double bessel_i0(double x) {
  double sum = 1.0;
  double term = 1.0;
  for (int k = 1; term > 1e-12 * sum; ++k) {
    term *= (0.5 * x / k) * (0.5 * x / k);
    sum += term;
  }
  return sum;
}

// At `x` samples from the middle.
double windowed_sinc(double x) {
  if (std::fabs(x) >= kHalfWidth) {
    return 0.0;
  }
  const double part = x / kHalfWidth;
  const double window = bessel_i0(kBeta * std::sqrt(1.0 - part * part)) / bessel_i0(kBeta);
  const double sinc = x == 0.0 ? 1.0 : std::sin(kPi * x) / (kPi * x);
  return sinc * window;
}

// Weights of in[first], in[first + 1], … for one position.
struct Weights {
  std::int64_t first = 0;
  std::vector<float> values;
};

Weights weights_at(double position, double cutoff) {
  const double reach = kHalfWidth / cutoff;
  Weights weights;
  weights.first = static_cast<std::int64_t>(std::ceil(position - reach));
  const auto last = static_cast<std::int64_t>(std::floor(position + reach));
  std::vector<double> exact;
  double sum = 0.0;
  for (std::int64_t i = weights.first; i <= last; ++i) {
    exact.push_back(windowed_sinc((static_cast<double>(i) - position) * cutoff));
    sum += exact.back();
  }
  // A constant stays exactly the same.
  for (const double value : exact) {
    weights.values.push_back(static_cast<float>(value / sum));
  }
  return weights;
}

float weighted(const std::vector<float>& in, std::int64_t first, const std::vector<float>& values) {
  const auto size = static_cast<std::int64_t>(in.size());
  const std::int64_t from = std::max<std::int64_t>(0, -first);
  const std::int64_t to =
      std::min<std::int64_t>(static_cast<std::int64_t>(values.size()), size - first);
  float sum[4] = {};
  std::int64_t i = from;
  for (; i + 4 <= to; i += 4) {
    for (std::int64_t k = 0; k < 4; ++k) {
      sum[k] +=
          values[static_cast<std::size_t>(i + k)] * in[static_cast<std::size_t>(first + i + k)];
    }
  }
  for (; i < to; ++i) {
    sum[0] += values[static_cast<std::size_t>(i)] * in[static_cast<std::size_t>(first + i)];
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

// Number of positions after which the fractions repeat; 0: more than kMostPhases.
int phases_of(double step) {
  for (int phases = 1; phases <= kMostPhases; ++phases) {
    const double whole = phases * step;
    if (whole == std::round(whole)) {
      return phases;
    }
  }
  return 0;
}

// The third difference of a step is up to twice the step; that of 1 % of the 40th harmonic at 8 kHz
// is 0.03.
constexpr float kThirdDifference = 0.1F;

// Indices i of steps between in[i] and in[i + 1].
std::vector<std::size_t> steps_in(const std::vector<float>& in) {
  std::vector<std::size_t> steps;
  for (std::size_t i = 1; i + 2 < in.size(); ++i) {
    // Twice a step in the middle of four values, once on either side.
    if (std::fabs(in[i + 2] - 3.0F * in[i + 1] + 3.0F * in[i] - in[i - 1]) > kThirdDifference) {
      steps.push_back(i);
    }
  }
  return steps;
}

void straighten_beside_steps(const std::vector<float>& in, double offset, double step,
                             std::vector<float>& out) {
  const std::vector<std::size_t> steps = steps_in(in);
  auto next = steps.begin();
  for (std::size_t n = 0; n < out.size() && next != steps.end(); ++n) {
    const double position = offset + static_cast<double>(n) * step;
    while (next != steps.end() && position > static_cast<double>(*next + kHalfWidth)) {
      ++next;
    }
    if (next == steps.end() || position + kHalfWidth < static_cast<double>(*next)) {
      continue;
    }
    const auto before = static_cast<std::size_t>(std::max(position, 0.0));
    if (before + 1 >= in.size()) {
      break;
    }
    const bool at_step = std::binary_search(next, steps.end(), before);
    const auto part = static_cast<float>(position - static_cast<double>(before));
    out[n] = at_step ? in[part > 0.5F ? before + 1 : before]
                     : in[before] + part * (in[before + 1] - in[before]);
  }
}

}  // namespace

std::vector<float> band_limited(const std::vector<float>& in, double offset, double step,
                                std::size_t count) {
  const double cutoff = step > 1.0 ? kKept / step : 1.0;
  std::vector<float> out(count);
  if (const int phases = phases_of(step); phases > 0) {
    const auto advance = static_cast<std::int64_t>(std::llround(phases * step));
    for (int phase = 0; phase < phases; ++phase) {
      const Weights weights = weights_at(offset + phase * step, cutoff);
      std::int64_t first = weights.first;
      for (auto n = static_cast<std::size_t>(phase); n < count;
           n += static_cast<std::size_t>(phases)) {
        out[n] = weighted(in, first, weights.values);
        first += advance;
      }
    }
    return out;
  }
  // Fractions that do not repeat are rounded to 1/kPlaces of a sample: at 50 Hz and 8 kHz a time
  // error of 1e-8 s, 3e-6 of the amplitude.
  constexpr int kPlaces = 8192;
  std::vector<Weights> of_fraction(kPlaces + 1);
  for (std::size_t n = 0; n < count; ++n) {
    const double position = offset + static_cast<double>(n) * step;
    const auto whole = static_cast<std::int64_t>(std::floor(position));
    const auto place =
        static_cast<std::size_t>(std::lround((position - static_cast<double>(whole)) * kPlaces));
    Weights& weights = of_fraction[place];
    const double fraction = static_cast<double>(place) / kPlaces;
    if (weights.values.empty()) {
      weights = weights_at(fraction, cutoff);
    }
    out[n] = weighted(in, whole + weights.first, weights.values);
  }
  return out;
}

std::vector<float> resampled(const std::vector<float>& in, double offset, double step,
                             std::size_t count) {
  std::vector<float> out = band_limited(in, offset, step, count);
  if (step <= 1.0) {
    straighten_beside_steps(in, offset, step, out);
  }
  return out;
}

}  // namespace gsbench::scpi
