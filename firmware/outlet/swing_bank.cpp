#include <outlet/arithmetic.hpp>
#include <outlet/swing_bank.hpp>

namespace gs::outlet {
namespace {

constexpr float kStart_hz[kSwingFilters] = {0.10f, 0.14f, 0.20f, 0.28f, 0.40f, 0.56f, 0.78f, 1.05f};

// What remains of the older innovations in a sum, and the variance of such a sum if they fit.
constexpr float kKeptInnovations = 0.8f;
constexpr float kSumVariance = 1.0f / (1.0f - kKeptInnovations * kKeptInnovations);
constexpr float kSumSigmas = 3.5f;

// Limits of an established oscillation: amplitude, also in its standard deviations; periods since
// the start; difference of the likelihoods with and without it.
constexpr float kSmallest_hz = 0.012f;
constexpr float kAmplitudeSigmas = 6.0f;
constexpr float kLargest_hz = 0.080f;
constexpr float kLeastPeriods = 0.35f;
constexpr float kMostPeriods = 0.9f;
constexpr float kLikelier = 32.0f;

}  // namespace

void start(SwingBank& bank, const PhaseMeasurement& m) {
  bank.age = 0;
  for (int i = kSwingFilters - 1; i >= 0; --i) {
    GridFilter& filter = bank.filters[i];
    filter = bank.filters[0];
    add_swing(filter, kTwoPi * kStart_hz[i]);
    take_phase(filter, m);
    bank.innovation_sums[i] = 0.0f;
  }
}

void follow(const GridStep& step, SwingBank& bank, int number, const LossNoise& noise,
            const PhaseMeasurement& m) {
  GridFilter& filter = bank.filters[number];
  float& sum = bank.innovation_sums[number];
  predict(step, filter, {0.0f, noise.steady});
  const float innovation = correct(filter, m);
  if (m.measured && !m.after_gap) {
    sum = kKeptInnovations * sum + innovation;
  }
  if (sum * sum > kSumSigmas * kSumSigmas * kSumVariance) {
    open_loss(step, filter, noise.onset, kOnsetMeasurements);
    filter.likelihood -= kSwingOnsetPenalty;
    sum = 0.0f;
  }
  if (number == kSwingFilters - 1 && bank.age < 0xFFFF) {
    ++bank.age;
  }
}

const GridFilter& likeliest(const SwingBank& bank) {
  const GridFilter* best = bank.filters;
  for (const GridFilter& filter : bank.filters) {
    best = filter.likelihood > best->likelihood ? &filter : best;
  }
  return *best;
}

const GridFilter* established(const SwingBank& bank, float likelihood_without) {
  const GridFilter& filter = likeliest(bank);
  const float periods = kReport_s * static_cast<float>(bank.age) * filter.x[kSwingOmega] / kTwoPi;
  const float amplitude_hz = swing_hz(filter);
  const bool explains = periods > kLeastPeriods && periods < kMostPeriods &&
                        amplitude_hz > kSmallest_hz && amplitude_hz < kLargest_hz &&
                        amplitude_hz > kAmplitudeSigmas * swing_sigma_hz(filter) &&
                        filter.likelihood > likelihood_without + kLikelier;
  return explains ? &filter : nullptr;
}

}  // namespace gs::outlet
