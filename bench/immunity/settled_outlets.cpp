#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <grid/sfr_model.hpp>
#include <immunity/settled_outlets.hpp>
#include <models/adc.hpp>
#include <models/noise.hpp>

namespace gsbench::immunity {
namespace {

using campaign::demand;

constexpr std::size_t kSamplesInReport = kSampleRate_hz / 1000 * gs::outlet::kReport_ms;
constexpr std::int64_t kSettledTicks = static_cast<std::int64_t>(kSettled_s * kSampleRate_hz);

// The voltage at an outlet: the signal with noise of its own.
class Voltage {
 public:
  Voltage(const waveform::Synthesizer& synthesizer, const models::Stream& noise, double noise_pct)
      : synthesizer_(synthesizer),
        noise_(noise),
        sigma_pu_(static_cast<float>(noise_pct / 100.0)) {}

  // The ADC's counts of samples first_tick …
  void convert(std::int64_t first_tick, std::vector<std::int16_t>& counts) {
    samples_.resize(counts.size());
    synthesizer_.render(first_tick, samples_.size(), samples_.data());
    models::add_gaussian(noise_, static_cast<std::uint64_t>(first_tick), samples_.size(), sigma_pu_,
                         samples_.data());
    std::transform(samples_.begin(), samples_.end(), counts.begin(),
                   [](float pu) { return models::adc_counts(pu, models::kCounts_per_pu); });
  }

 private:
  const waveform::Synthesizer& synthesizer_;
  models::Stream noise_;
  float sigma_pu_;
  std::vector<float> samples_;
};

// Samples first_tick … end_tick−1 into an outlet, until `take` returns false. `take` gets each
// report with the tick after its last sample.
template <class Take>
void feed(const gs::outlet::Config& config, gs::outlet::State& state, Voltage voltage,
          std::int64_t first_tick, std::int64_t end_tick, const Take& take) {
  std::vector<std::int16_t> counts;
  for (std::int64_t tick = first_tick; tick < end_tick;) {
    // Up to the end of a block of the synthesizer, which is as long as a report.
    const auto block = static_cast<std::int64_t>(kSamplesInReport);
    const std::int64_t end = std::min(tick + block - tick % block, end_tick);
    counts.resize(static_cast<std::size_t>(end - tick));
    voltage.convert(tick, counts);
    for (std::size_t at = 0; at < counts.size();) {
      gs::outlet::Report report;
      bool ready = false;
      at += step(config, state, counts.data() + at, counts.size() - at, report, ready);
      if (ready && !take(report, tick + static_cast<std::int64_t>(at))) {
        return;
      }
    }
    tick = end;
  }
}

waveform::Synthesizer synthesizer_of(const grid::Grid& grid, const Disturbance& disturbance) {
  std::shared_ptr<const waveform::ReferenceSignal> reference = waveform::with_oscillations(
      waveform::reference_from_losses(grid::SfrModel(grid), disturbance.losses),
      disturbance.oscillations);
  return {std::move(reference), disturbance.signal, kSampleRate_hz};
}

}  // namespace

void check(const grid::Grid& grid, const Options& options) {
  demand(options.cases >= 1 && options.cases <= kMostCases,
         fmt::format("the number of cases is {}; it must be 1 … {}", options.cases, kMostCases));
  demand(
      options.noise_pct >= 0.0 && options.noise_pct <= kMostNoise_pct,
      fmt::format("a noise of {:g} % is not within 0 … {:g} %", options.noise_pct, kMostNoise_pct));
  // Rounded down, so that the printed limit is accepted.
  const double most_mw = std::floor(100.0 * control_centre::largest_accumulated_mw(grid)) / 100.0;
  demand(options.accumulated_mw >= 0.0 && options.accumulated_mw <= most_mw,
         fmt::format("a P^A of {:g} MW is not within 0 … {:g} MW, the range in grid {}",
                     options.accumulated_mw, most_mw, grid.name));
}

SettledOutlets::SettledOutlets(const grid::Grid& grid, const Options& options,
                               const campaign::Execution& execution)
    : grid_(grid), options_(options), settled_(kSamplesInReport) {
  check(grid, options);
  gs::outlet::Hardware hardware;
  hardware.sample_rate_hz = static_cast<std::int32_t>(kSampleRate_hz);
  hardware.counts_per_pu = models::kCounts_per_pu;
  hardware.nominal_hz = static_cast<std::int32_t>(std::lround(grid.nominal_hz));
  demand(gs::outlet::configure(hardware, config_), "the firmware does not support this grid");
  control_centre::RequestedSettings requested;
  requested.accumulated_mw = options.accumulated_mw;
  const gs::outlet::Settings settings = control_centre::outlet_settings(grid, requested, 1);
  const waveform::Synthesizer mains = synthesizer_of(grid, {});
  campaign::Histograms none;
  const auto settle = [&](std::uint64_t skipped, campaign::Histograms&) {
    gs::outlet::State& state = settled_[skipped];
    gs::outlet::Config config = config_;
    apply(config, state, settings);
    // Numbers of cases are far below.
    const models::Stream noise = {options.seed, models::kNoiseOfDisturbance,
                                  kMostCases + static_cast<std::uint32_t>(skipped)};
    feed(config, state, {mains, noise, options.noise_pct}, static_cast<std::int64_t>(skipped),
         kSettledTicks, [](const gs::outlet::Report&, std::int64_t) { return true; });
  };
  run_blocks(settled_.size(), quiet(execution), settle, none);
  gs::outlet::State unused = {};
  apply(config_, unused, settings);
}

Outcome SettledOutlets::play(const Disturbance& disturbance, std::uint32_t number) const {
  const waveform::Synthesizer signal = synthesizer_of(grid_, disturbance);
  const std::int64_t end_tick = waveform::tick_at(disturbance.end_s + kAfter_s, kSampleRate_hz);
  const models::Stream noise = {options_.seed, models::kNoiseOfDisturbance, number};
  gs::outlet::State state = outlet_of(number);
  Outcome outcome;
  feed(config_, state, {signal, noise, options_.noise_pct}, kSettledTicks, end_tick,
       [&](const gs::outlet::Report& report, std::int64_t tick) {
         const double t_s = static_cast<double>(tick) / static_cast<double>(kSampleRate_hz);
         if ((report.happened & gs::outlet::kEvent) != 0 && !outcome.event_s) {
           outcome.event_s = t_s;
         }
         if (!report.relay_closed) {
           outcome.trip_s = t_s;
         }
         return report.relay_closed;
       });
  return outcome;
}

const gs::outlet::State& SettledOutlets::outlet_of(std::uint32_t number) const {
  // Kinds repeat with a period of their own, so that each kind meets all outlets.
  static_assert(kSamplesInReport % kKinds.size() != 0);
  return settled_[number % settled_.size()];
}

}  // namespace gsbench::immunity
