#include "draws.hpp"

#include <algorithm>

namespace gsbench::immunity {
namespace {

constexpr double kEarliest_s = kSettled_s + 0.05;
constexpr double kLatest_s = kSettled_s + 0.45;
constexpr double kLongestPart_s = 1.0;  // of two dips or stages, and of a phase step that returns
constexpr double kShortestOscillation_s = 0.1;
constexpr double kLongestOscillation_s = 12.0;
constexpr double kPerPhaseStepDegree = 10.0;
constexpr double kPerOscillationHertz = 1e4;
constexpr int kMostHalfCycles = 6;

double phase_step_deg(Draws& draws) {
  return draws.uniform(-kLargestPhaseStep_deg, kLargestPhaseStep_deg, kPerPhaseStepDegree);
}

// Appends a dip at the end of the disturbance.
void add_dip(Draws& draws, double level_pct, double longest_s, Disturbance& d) {
  const double duration_s = draws.logarithmic(kShortestDip_s, longest_s, kPerSecond);
  d.signal.amplitude_steps.push_back({d.end_s, duration_s, level_pct});
  d.end_s += duration_s;
}

double residual_pct(Draws& draws) {
  return draws.uniform(kDeepestDip_pct, kShallowestDip_pct, kPerPercent);
}

void add_two_dips(Draws& draws, Disturbance& d) {
  add_dip(draws, residual_pct(draws), kLongestPart_s, d);
  d.end_s += draws.logarithmic(kShortestDip_s, kLongestPart_s, kPerSecond);
  add_dip(draws, residual_pct(draws), kLongestPart_s, d);
}

// A fault that develops, or that is cleared at one end of the line first.
void add_dip_in_stages(Draws& draws, Disturbance& d) {
  add_dip(draws, residual_pct(draws), kLongestPart_s, d);
  add_dip(draws, residual_pct(draws), kLongestPart_s, d);
}

// The phase returns as it went, stays, or steps by another angle.
void add_dip_with_phase_steps(Draws& draws, Disturbance& d) {
  const double degrees = phase_step_deg(draws);
  d.signal.phase_jumps.push_back({d.begin_s, degrees});
  add_dip(draws, residual_pct(draws), kLongestDip_s, d);
  const int way = draws.whole(0, 3);
  if (way < 3) {
    d.signal.phase_jumps.push_back({d.end_s, way < 2 ? -degrees : phase_step_deg(draws)});
  }
}

void add_returning_phase_step(Draws& draws, Disturbance& d) {
  const double degrees = phase_step_deg(draws);
  d.signal.phase_jumps.push_back({d.begin_s, degrees});
  d.end_s += draws.logarithmic(kShortestDip_s, kLongestPart_s, kPerSecond);
  d.signal.phase_jumps.push_back({d.end_s, -degrees});
}

// A soft oscillation begins and ends without a step of the frequency; an abrupt one anywhere.
void add_oscillation(Draws& draws, bool abrupt, Disturbance& d) {
  waveform::Oscillation oscillation;
  oscillation.at_s = d.begin_s;
  oscillation.frequency_hz =
      draws.logarithmic(kSlowestOscillation_hz, kFastestOscillation_hz, kPerHertz);
  oscillation.amplitude_hz =
      draws.uniform(kLeastOscillation_hz, kLargestOscillation_hz, kPerOscillationHertz);
  if (abrupt) {
    oscillation.phase_deg = draws.phase_deg();
    oscillation.duration_s =
        draws.logarithmic(kShortestOscillation_s, kLongestOscillation_s, kPerSecond);
  } else {
    oscillation.phase_deg = draws.one_in(2) ? 0.0 : 180.0;
    const double half_cycle_s = 0.5 / oscillation.frequency_hz;
    const int most =
        std::min(kMostHalfCycles, static_cast<int>(kLongestOscillation_s / half_cycle_s));
    oscillation.duration_s = rounded(half_cycle_s * draws.whole(1, most), kPerSecond);
  }
  d.oscillations.push_back(oscillation);
  d.end_s += oscillation.duration_s;
}

}  // namespace

Disturbance draw(double nominal_hz, std::uint64_t seed, std::uint32_t number) {
  Draws draws(seed, number);
  Disturbance d;
  d.kind = kKinds[number % kKinds.size()].kind;
  d.begin_s = draws.uniform(kEarliest_s, kLatest_s, kPerSecond);
  d.end_s = d.begin_s;
  switch (d.kind) {
    case Kind::kDip:
      add_dip(draws, residual_pct(draws), kLongestDip_s, d);
      break;
    case Kind::kTwoDips:
      add_two_dips(draws, d);
      break;
    case Kind::kDipInStages:
      add_dip_in_stages(draws, d);
      break;
    case Kind::kDipWithPhaseSteps:
      add_dip_with_phase_steps(draws, d);
      break;
    case Kind::kInterruption:
      add_dip(draws, 0.0, kLongestDip_s, d);
      break;
    case Kind::kPhaseStep:
      d.signal.phase_jumps.push_back({d.begin_s, phase_step_deg(draws)});
      break;
    case Kind::kReturningPhaseStep:
      add_returning_phase_step(draws, d);
      break;
    case Kind::kRectangularFlicker:
      add_rectangular_flicker(draws, d);
      break;
    case Kind::kSinusoidalFlicker:
      add_sinusoidal_flicker(draws, nominal_hz, d);
      break;
    case Kind::kHarmonics:
      add_harmonics(draws, nominal_hz, d);
      break;
    case Kind::kMainsSignalling:
      add_mains_signalling(draws, d);
      break;
    case Kind::kOscillation:
      add_oscillation(draws, false, d);
      break;
    case Kind::kAbruptOscillation:
      add_oscillation(draws, true, d);
      break;
  }
  return d;
}

}  // namespace gsbench::immunity
