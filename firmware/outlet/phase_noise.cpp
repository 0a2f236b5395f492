#include "phase_noise.hpp"

#include "followed_reports.hpp"

namespace gs::outlet {
namespace {

// The windows of successive phasors (56 ms) overlap, so that their noise is correlated. Over many
// reports it averages like independent noise with 1.57 times the standard deviation.
constexpr float kOverlap = 1.57f;
// The phase noise is measured by the third differences of successive phases, in which changes of
// the grid are negligible. Their variance is kThirdDifference times that of a phase, plus that of
// the front end's images. Averaged over two seconds it varies by 15 %. Divided by kNoiseMargin, it
// replaces the setting only if it is clearly larger.
constexpr float kThirdDifference = 3.9f;
constexpr float kImages_cycles2 = 2.7e-8f;  // (1.03 mrad)²
constexpr float kNoiseMargin = 1.3f;
constexpr float kNoiseMemory = 1.0f / 128.0f;  // weight of the newest difference
constexpr float kLargestSquare = 9.0f;         // times the mean; limits the effect of a phase step

float nominal_phase_variance(const FollowerSettings& settings) {
  return square(settings.phase_sigma_rad / kTwoPi);
}

}  // namespace

float nominal_noise_squares(const FollowerSettings& settings) {
  return kThirdDifference * nominal_phase_variance(settings) + kImages_cycles2;
}

float phase_variance(const FollowerSettings& settings, const GridFollower& f) {
  const float measured = (f.noise_squares - kImages_cycles2) / (kThirdDifference * kNoiseMargin);
  return square(kOverlap) * maximum(measured, nominal_phase_variance(settings));
}

void measure_noise(GridFollower& f) {
  const std::uint32_t now = f.count - 1;
  if (now < f.oldest + 3) {
    return;
  }
  for (std::uint32_t age = 0; age < 4; ++age) {
    const PhaseMeasurement& m = at(f, now - age).measurement;
    if (!m.measured || (m.after_gap && age < 3)) {
      return;
    }
  }
  const auto phase = [&](std::uint32_t age) { return at(f, now - age).measurement.phase_cycles; };
  float difference = phase(0) - phase(3) - 3.0f * (phase(1) - phase(2));
  difference -= nearest_whole(difference);
  const float limited = minimum(square(difference), kLargestSquare * f.noise_squares);
  f.noise_squares += kNoiseMemory * (limited - f.noise_squares);
}

}  // namespace gs::outlet
