#include "sine.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gsbench::waveform {
namespace {

// To the nearest whole number, for |x| < 2⁵¹: the added constant leaves no bits for the fraction.
inline double nearest(double x) {
  constexpr double kShift = 0x1.8p52;
  return (x + kShift) - kShift;
}

// cos(2π·cycles): minimax polynomial of sin(2πz) on |z| <= ¼, error 1.4·10⁻¹¹.
inline double cosine_of_cycles(double cycles) {
  const double z = 0.25 - std::fabs(cycles - nearest(cycles));
  const double w = z * z;
  double p = -14.3370246264440495;
  p = p * w + 41.9999898165132834;
  p = p * w - 76.7036678269932695;
  p = p * w + 81.6052094310619772;
  p = p * w - 41.3417019297725149;
  p = p * w + 6.28318530648750495;
  return p * z;
}

inline double sine_of_cycles(double cycles) {
  return cosine_of_cycles(cycles - 0.25);
}

inline double progress(const Stretch& s, int sample) {
  return (static_cast<double>(sample) - s.start) * s.per_length;
}

inline double phase_cycles(const Stretch& s, int sample, double u) {
  const auto& c = s.cycles;
  const double excess = ((((c[4] * u + c[3]) * u + c[2]) * u + c[1]) * u + c[0]) * u;
  return s.base_cycles + static_cast<double>(sample) * s.cycles_per_sample + excess;
}

inline float scaled(const Stretch& s, double u, double value) {
  return static_cast<float>((s.amplitude + u * s.amplitude_slope) * value + s.offset);
}

// z·(d₁ + z·(d₂ + …)) by Horner's rule with z = e^(iθ). It is as stable as each term alone; the
// recurrence of cosines would lose digits near θ = 0. Each step adds one order to all samples.
constexpr int kBatch = 64;

void render_batch(const Stretch& stretch, const std::vector<Phasor>& series, int first, int count,
                  float* out) {
  double cosine[kBatch];
  double sine[kBatch];
  double real[kBatch];
  double imaginary[kBatch];
  for (int i = 0; i < count; ++i) {
    const double cycles = phase_cycles(stretch, first + i, progress(stretch, first + i));
    cosine[i] = cosine_of_cycles(cycles);
    sine[i] = sine_of_cycles(cycles);
    real[i] = series.back().real;
    imaginary[i] = series.back().imaginary;
  }
  for (std::size_t order = series.size() - 2; order > 0; --order) {
    const Phasor term = series[order];
    for (int i = 0; i < count; ++i) {
      const double turned = real[i] * cosine[i] - imaginary[i] * sine[i];
      imaginary[i] = real[i] * sine[i] + imaginary[i] * cosine[i] + term.imaginary;
      real[i] = turned + term.real;
    }
  }
  for (int i = 0; i < count; ++i) {
    const double value = real[i] * sine[i] + imaginary[i] * cosine[i];
    out[i] = scaled(stretch, progress(stretch, first + i), value);
  }
}

}  // namespace

double sine_of(double cycles) {
  return sine_of_cycles(cycles);
}

void render_sine(const Stretch& stretch, int first, int count, float* out) {
  const Stretch s = stretch;  // a local copy cannot alias `out`
  for (int i = 0; i < count; ++i) {
    const double u = progress(s, first + i);
    out[i] = scaled(s, u, sine_of_cycles(phase_cycles(s, first + i, u)));
  }
}

void render_harmonics(const Stretch& stretch, const std::vector<Phasor>& series, int first,
                      int count, float* out) {
  while (count > 0) {
    const int batch = std::min(count, kBatch);
    render_batch(stretch, series, first, batch, out);
    first += batch;
    out += batch;
    count -= batch;
  }
}

}  // namespace gsbench::waveform
