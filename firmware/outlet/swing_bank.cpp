#include <outlet/arithmetic.hpp>
#include <outlet/swing_bank.hpp>

namespace gs::outlet {
namespace {

constexpr float kStart_hz[kSwingFilters] = {0.10f, 0.14f, 0.20f, 0.28f, 0.40f, 0.56f, 0.78f, 1.05f};

// What remains of the older terms with each measurement.
constexpr float kKeptLikelihood = 0.99f;
constexpr float kKeptSquares = 0.97f;

// Limits of an established oscillation: amplitude, also in its standard deviations; mean square of
// the normalised innovations; reports since the start.
constexpr float kSignificant_hz = 0.012f;
constexpr float kSignificantSigmas = 6.0f;
constexpr float kFittingSquares = 1.6f;
constexpr std::uint16_t kLeastAge = 90;

}  // namespace

void start(const Response& response, SwingBank& bank, float phase_cycles, float phase_variance,
           float deviation_hz) {
  bank.age = 0;
  for (int i = 0; i < kSwingFilters; ++i) {
    bank.likelihood[i] = 0.0f;
    bank.innovation_squares[i] = 0.0f;
    GridFilter& filter = bank.filters[i];
    start(response, filter, phase_cycles, deviation_hz);
    add_swing(filter, kTwoPi * kStart_hz[i]);
    take_phase(filter, phase_cycles, phase_variance);
  }
}

void follow(const GridStep& step, SwingBank& bank, int number, float loss_noise_mw2,
            const PhaseMeasurement& m) {
  GridFilter& filter = bank.filters[number];
  predict(step, filter, {0.0f, loss_noise_mw2});
  if (m.measured && m.after_gap) {
    take_phase(filter, m.phase_cycles, m.variance);
  } else if (m.measured) {
    const Innovation innovation = correct(filter, m.phase_cycles, m.variance);
    const float square = innovation.normalised * innovation.normalised;
    bank.innovation_squares[number] =
        kKeptSquares * bank.innovation_squares[number] + (1.0f - kKeptSquares) * square;
    bank.likelihood[number] = kKeptLikelihood * bank.likelihood[number] -
                              0.5f * (square + logarithm(innovation.relative_width));
  }
  if (number == kSwingFilters - 1 && bank.age < 0xFFFF) {
    ++bank.age;
  }
}

const GridFilter* established(const SwingBank& bank) {
  int best = 0;
  for (int i = 1; i < kSwingFilters; ++i) {
    best = bank.likelihood[i] > bank.likelihood[best] ? i : best;
  }
  const GridFilter& filter = bank.filters[best];
  const float periods = kReport_s * static_cast<float>(bank.age) * filter.x[kSwingOmega] / kTwoPi;
  const float amplitude_hz = swing_hz(filter);
  const bool explains = bank.age >= kLeastAge && periods >= 1.0f &&
                        amplitude_hz > kSignificant_hz &&
                        amplitude_hz > kSignificantSigmas * swing_sigma_hz(filter) &&
                        bank.innovation_squares[best] < kFittingSquares;
  return explains ? &filter : nullptr;
}

}  // namespace gs::outlet
