#include "balance.hpp"
#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <drivers/workers.hpp>
#include <fleet/closed_loop.hpp>
#include <grid/sfr_model.hpp>
#include <models/adc.hpp>
#include <models/noise.hpp>
#include <outlet/outlet.hpp>

namespace gsbench::fleet {
namespace {

constexpr double kBeforeLoss_s = 1.0;
constexpr double kTwoPi = 6.283185307179586;
constexpr std::size_t kOutletsInBlock = 50;

// One outlet behind its ADC.
struct Outlet {
  gs::outlet::Config config;
  gs::outlet::State state;
  std::size_t skipped = 0;  // samples before its first report: outlets report at different instants
  double event_s = kNone;
  double loss_mw = kNone;
};

class Loop {
 public:
  Loop(const grid::Grid& grid, const Fleet& fleet, const ClosedLoopOptions& options,
       const campaign::Execution& execution)
      : grid_(grid),
        fleet_(fleet),
        options_(options),
        execution_(execution),
        workers_(execution.threads),
        model_(grid),
        balance_(model_, options.loss_mw),
        off_(fleet.outlets(), 0),
        outlets_(fleet.outlets()) {
    hardware_.counts_per_pu = models::kCounts_per_pu;
    hardware_.nominal_hz = static_cast<std::int32_t>(std::lround(grid.nominal_hz));
    voltage_pu_.resize(samples_);
    shed_at_.resize((fleet.outlets() + kOutletsInBlock - 1) / kOutletsInBlock);
    gs::outlet::Settings settings = control_centre::grid_settings(grid);
    settings.version = 1;
    if (options.threshold_mw > 0.0) {
      settings.threshold_mw = static_cast<float>(options.threshold_mw);
    }
    const std::vector<double> switch_off = switch_off_hz(grid, fleet);
    for (std::size_t i = 0; i < outlets_.size(); ++i) {
      Outlet& outlet = outlets_[i];
      const std::size_t group = i / fleet.per_group;
      settings.accumulated_mw = static_cast<float>(fleet.accumulated_mw[group]);
      settings.switch_off_hz = static_cast<float>(switch_off[group]);
      outlet.skipped = i * 37 % samples_;
      if (!gs::outlet::configure(hardware_, outlet.config) ||
          apply(outlet.config, outlet.state, settings) != gs::outlet::SettingsError::kNone) {
        throw std::invalid_argument(
            fmt::format("the firmware rejects the settings of group {}", group + 1));
      }
    }
  }

  // Returns false if it was stopped.
  bool simulate() {
    const auto blocks =
        static_cast<std::size_t>((kBeforeLoss_s + options_.duration_s) / campaign::kReport_s);
    for (std::size_t block = 0; block < blocks; ++block) {
      if (stopped(execution_)) {
        return false;
      }
      synthesize(block);
      workers_.run(shed_at_.size(), [&](std::size_t some) { feed(some, block); });
      for (auto& some : shed_at_) {
        for (const auto& [at_s, power_mw] : some) {
          balance_.shed(at_s, power_mw);
        }
        some.clear();
      }
      report_progress(execution_, static_cast<double>(block + 1), static_cast<double>(blocks));
    }
    return true;
  }

  ClosedLoopResult result() const {
    ClosedLoopResult result{balance_.result(grid_, options_.duration_s, count_shed(fleet_, off_)),
                            0, 0, kNone, campaign::Histogram(0.0, 2.0 * options_.loss_mw, 2000)};
    for (const Outlet& outlet : outlets_) {
      if (outlet.event_s >= 0.0) {
        ++result.events;
        result.latest_event_s = std::fmax(result.latest_event_s, outlet.event_s);
      } else if (outlet.event_s < 0.0) {
        ++result.false_events;
      }
      if (std::isfinite(outlet.loss_mw)) {
        result.loss_mw.add(outlet.loss_mw);
      }
    }
    return result;
  }

 private:
  double time_s(std::size_t block, std::size_t sample) const {
    return static_cast<double>(block * samples_ + sample) /
               static_cast<double>(hardware_.sample_rate_hz) -
           kBeforeLoss_s;
  }

  void synthesize(std::size_t block) {
    for (std::size_t i = 0; i < samples_; ++i) {
      const double t_s = time_s(block, i);
      const double cycles = grid_.nominal_hz * (t_s + kBeforeLoss_s) + balance_.excess_cycles(t_s);
      voltage_pu_[i] = static_cast<float>(std::sin(kTwoPi * (cycles - std::floor(cycles))));
    }
  }

  void feed(std::size_t some, std::size_t block) {
    const std::size_t first = some * kOutletsInBlock;
    const std::size_t end = std::min(first + kOutletsInBlock, outlets_.size());
    std::vector<float> noisy(samples_);
    std::vector<std::int16_t> counts(samples_);
    for (std::size_t i = first; i < end; ++i) {
      noisy = voltage_pu_;
      models::add_gaussian({options_.seed, models::kSourceNoise, static_cast<std::uint32_t>(i)},
                           block * samples_, samples_,
                           static_cast<float>(0.01 * options_.noise_pct), noisy.data());
      std::transform(noisy.begin(), noisy.end(), counts.begin(), [&](float voltage_pu) {
        return models::adc_counts(voltage_pu, hardware_.counts_per_pu);
      });
      take(i, block, counts);
    }
  }

  void take(std::size_t number, std::size_t block, const std::vector<std::int16_t>& counts) {
    Outlet& outlet = outlets_[number];
    std::size_t at = block == 0 ? outlet.skipped : 0;
    while (at < counts.size()) {
      gs::outlet::Report report;
      bool ready = false;
      at +=
          step(outlet.config, outlet.state, counts.data() + at, counts.size() - at, report, ready);
      if (ready) {
        note(number, outlet, report, time_s(block, at));
      }
    }
  }

  void note(std::size_t number, Outlet& outlet, const gs::outlet::Report& report, double t_s) {
    if ((report.happened & gs::outlet::kEvent) != 0 && std::isnan(outlet.event_s)) {
      outlet.event_s = t_s;
    }
    if ((report.happened & gs::outlet::kDecision) != 0 && std::isnan(outlet.loss_mw)) {
      outlet.loss_mw = static_cast<double>(report.loss_mw);
    }
    if ((report.happened & gs::outlet::kRelay) != 0 && !report.relay_closed) {
      off_[number] = 1;
      shed_at_[number / kOutletsInBlock].emplace_back(
          t_s + kRelay_s, 1e-6 * static_cast<double>(fleet_.power_w[number]));
    }
  }

  const grid::Grid& grid_;
  const Fleet& fleet_;
  const ClosedLoopOptions& options_;
  const campaign::Execution& execution_;
  drivers::Workers workers_;
  grid::SfrModel model_;
  Balance balance_;
  gs::outlet::Hardware hardware_;
  std::size_t samples_ = static_cast<std::size_t>(hardware_.sample_rate_hz / 1000) *
                         static_cast<std::size_t>(gs::outlet::kReport_ms);  // in a block of 16 ms
  std::vector<float> voltage_pu_;
  std::vector<std::uint8_t> off_;
  std::vector<std::vector<std::pair<double, double>>> shed_at_;  // s and MW, by block of outlets
  std::vector<Outlet> outlets_;
};

}  // namespace

std::optional<ClosedLoopResult> simulate_closed_loop(const grid::Grid& grid, const Fleet& fleet,
                                                     const ClosedLoopOptions& options,
                                                     const campaign::Execution& execution) {
  campaign::demand(fleet.outlets() <= kMostInClosedLoop,
                   fmt::format("a closed loop has at most {} outlets, not {}", kMostInClosedLoop,
                               fleet.outlets()));
  campaign::demand(options.loss_mw > 0.0 && options.loss_mw <= grid.base_mw,
                   fmt::format("a loss of {:g} MW is not above 0 and at most {:g} MW, the grid's "
                               "base power",
                               options.loss_mw, grid.base_mw));
  campaign::demand(
      options.noise_pct >= 0.0 && options.noise_pct <= 20.0,
      fmt::format("a noise of {:g} % of the voltage is not within 0 … 20 %", options.noise_pct));
  campaign::demand(options.duration_s >= 1.0 && options.duration_s <= 300.0,
                   fmt::format("a duration of {:g} s is not within 1 … 300 s", options.duration_s));
  Loop loop(grid, fleet, options, execution);
  return loop.simulate() ? std::optional(loop.result()) : std::nullopt;
}

}  // namespace gsbench::fleet
