// Disturbances of the voltage, and oscillations of the frequency, in a grid that loses no power.
// Each is drawn from (seed, number of the case) alone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <grid/sfr_model.hpp>
#include <waveform/oscillation.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::immunity {

enum class Kind : std::uint8_t {
  kDip,
  kTwoDips,
  kDipInStages,
  kDipWithPhaseSteps,
  kInterruption,
  kPhaseStep,
  kReturningPhaseStep,
  kRectangularFlicker,
  kSinusoidalFlicker,
  kHarmonics,
  kMainsSignalling,
  kOscillation,
  kAbruptOscillation,
};

struct KindRow {
  Kind kind;
  const char* name;
  bool is_dip;  // counts for the limit of false events
};

// All kinds. Case n has kind n modulo their number.
constexpr std::array<KindRow, 13> kKinds = {{
    {Kind::kDip, "dip", true},
    {Kind::kTwoDips, "two dips", true},
    {Kind::kDipInStages, "dip in two stages", true},
    {Kind::kDipWithPhaseSteps, "dip with phase steps", true},
    {Kind::kInterruption, "interruption", true},
    {Kind::kPhaseStep, "phase step", false},
    {Kind::kReturningPhaseStep, "phase step that returns", false},
    {Kind::kRectangularFlicker, "flicker, rectangular", false},
    {Kind::kSinusoidalFlicker, "flicker, sinusoidal", false},
    {Kind::kHarmonics, "harmonics switched on", false},
    {Kind::kMainsSignalling, "mains signalling", false},
    {Kind::kOscillation, "oscillation", false},
    {Kind::kAbruptOscillation, "abrupt oscillation", false},
}};

constexpr std::int64_t kSampleRate_hz = 8000;
constexpr double kSettled_s = 10.0;  // outlets have measured undisturbed mains until then

// Ranges of the drawn values. Durations and frequencies are uniform in their logarithm, all others
// are uniform. Each disturbance begins at a random instant, and so at any phase of the wave and of
// the outlet's reports.
constexpr double kDeepestDip_pct = 0.0;  // residual voltage
constexpr double kShallowestDip_pct = 95.0;
constexpr double kShortestDip_s = 0.005;
constexpr double kLongestDip_s = 3.0;  // two dips, or stages: 1 s each
constexpr double kLargestPhaseStep_deg = 60.0;
// Depth of modulation, ΔV/V from peak to peak; frequencies of the tables of IEC 61000-4-15.
constexpr double kLeastFlicker_pct = 0.2;
constexpr double kMostFlicker_pct = 10.0;
constexpr double kSlowestFlicker_hz = 0.5;
constexpr double kFastestFlicker_hz = 33.3;
// The largest level of EN 50160 for mains signalling, which it permits up to 500 Hz only.
constexpr double kLeastSignalling_pct = 0.5;
constexpr double kMostSignalling_pct = 9.0;
constexpr double kLowestSignalling_hz = 110.0;
constexpr double kHighestSignalling_hz = 3000.0;
constexpr double kSlowestOscillation_hz = 0.1;
constexpr double kFastestOscillation_hz = 1.0;
constexpr double kLeastOscillation_hz = 0.001;
constexpr double kLargestOscillation_hz = 0.060;

struct Disturbance {
  Kind kind = Kind::kDip;
  waveform::SignalSpec signal;
  std::vector<waveform::Oscillation> oscillations;
  std::vector<grid::PowerChange> losses;  // none of a drawn disturbance
  double begin_s = kSettled_s;            // kSettled_s or later
  double end_s = kSettled_s;              // of the last change
};

// The disturbance of a case. Its values have few decimals.
Disturbance draw(double nominal_hz, std::uint64_t seed, std::uint32_t number);

}  // namespace gsbench::immunity
