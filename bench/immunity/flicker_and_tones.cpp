#include "draws.hpp"

#include <algorithm>
#include <cmath>

#include <profile/en50160.hpp>

namespace gsbench::immunity {
namespace {

constexpr double kShortest_s = 0.1;
constexpr double kLongest_s = 4.0;
constexpr int kMostPulses = 8;
constexpr double kShortestPulse_s = 0.02;
constexpr double kLongestPulse_s = 1.0;
constexpr double kLeastHarmonic_pct = 0.01;
constexpr int kOneInAtLimits = 3;  // every third case has all harmonics at their limits

// Within ± 180.
double within_turn_deg(double degrees) {
  return rounded(std::remainder(degrees, 360.0), kPerDegree);
}

}  // namespace

// The voltage alternates between nominal and nominal less the depth.
void add_rectangular_flicker(Draws& draws, Disturbance& d) {
  const double depth_pct = draws.uniform(kLeastFlicker_pct, kMostFlicker_pct, kPerPercent);
  const double half_s = rounded(
      0.5 / draws.logarithmic(kSlowestFlicker_hz, kFastestFlicker_hz, kPerHertz), kPerSecond);
  const double duration_s = draws.uniform(kShortest_s, kLongest_s, kPerSecond);
  for (int n = 0; d.end_s < d.begin_s + duration_s; ++n) {
    const double at_s = rounded(d.begin_s + 2.0 * half_s * n, kPerSecond);
    d.signal.amplitude_steps.push_back({at_s, half_s, 100.0 - depth_pct});
    d.end_s = at_s + half_s;
  }
}

// Amplitude modulation with the depth 2·m from peak to peak, as its side bands:
// sin θ·m·sin(ω·τ + ψ) = m/2·cos(θ − ω·τ − ψ) − m/2·cos(θ + ω·τ + ψ), τ from the beginning.
void add_sinusoidal_flicker(Draws& draws, double nominal_hz, Disturbance& d) {
  const double side_band_pct =
      draws.uniform(0.25 * kLeastFlicker_pct, 0.25 * kMostFlicker_pct, kPerPercent);
  const double frequency_hz = draws.logarithmic(kSlowestFlicker_hz, kFastestFlicker_hz, kPerHertz);
  const double duration_s = draws.uniform(kShortest_s, kLongest_s, kPerSecond);
  const double modulation_deg = draws.phase_deg();
  const double mains_deg = 360.0 * std::remainder(nominal_hz * d.begin_s, 1.0);
  d.signal.tones.push_back({d.begin_s, duration_s, rounded(nominal_hz - frequency_hz, kPerHertz),
                            side_band_pct, within_turn_deg(mains_deg - modulation_deg + 90.0)});
  d.signal.tones.push_back({d.begin_s, duration_s, rounded(nominal_hz + frequency_hz, kPerHertz),
                            side_band_pct, within_turn_deg(mains_deg + modulation_deg - 90.0)});
  d.end_s += duration_s;
}

// Each order up to its limit of EN 50160, at any phase.
void add_harmonics(Draws& draws, double nominal_hz, Disturbance& d) {
  const double duration_s = draws.uniform(kShortest_s, kLongest_s, kPerSecond);
  const bool at_limits = draws.one_in(kOneInAtLimits);
  for (const waveform::Harmonic& harmonic : profile::en50160_harmonics()) {
    const double amplitude_pct =
        at_limits ? harmonic.amplitude_pct
                  : draws.uniform(kLeastHarmonic_pct, harmonic.amplitude_pct, kPerPercent);
    d.signal.tones.push_back(
        {d.begin_s, duration_s, nominal_hz * harmonic.order, amplitude_pct, draws.phase_deg()});
  }
  d.end_s += duration_s;
}

// A telegram of ripple control: pulses and gaps of the same length.
void add_mains_signalling(Draws& draws, Disturbance& d) {
  const double frequency_hz =
      draws.logarithmic(kLowestSignalling_hz, kHighestSignalling_hz, kPerHertz);
  const double amplitude_pct =
      draws.uniform(kLeastSignalling_pct, kMostSignalling_pct, kPerPercent);
  const double pulse_s = draws.logarithmic(kShortestPulse_s, kLongestPulse_s, kPerSecond);
  const int pulses =
      draws.whole(1, std::clamp(static_cast<int>(kLongest_s / (2.0 * pulse_s)), 1, kMostPulses));
  for (int n = 0; n < pulses; ++n) {
    const double at_s = rounded(d.begin_s + 2.0 * pulse_s * n, kPerSecond);
    d.signal.tones.push_back({at_s, pulse_s, frequency_hz, amplitude_pct, draws.phase_deg()});
    d.end_s = at_s + pulse_s;
  }
}

}  // namespace gsbench::immunity
