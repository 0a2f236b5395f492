#include "balance.hpp"
#include <control_centre/outlet_settings.hpp>
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <campaign/kernel.hpp>
#include <drivers/workers.hpp>
#include <fleet/scenario.hpp>
#include <grid/sfr_model.hpp>
#include <models/noise.hpp>
#include <outlet/decision.hpp>

namespace gsbench::fleet {
namespace {

using campaign::demand;
using campaign::Execution;
using campaign::kLanes;
using campaign::kReport_s;
using campaign::Lanes;
using campaign::NoiseDistribution;
using campaign::stopped;
using gs::outlet::LossEstimator;
using gs::outlet::Settings;

constexpr double kMeasuring_s = gs::outlet::kFrontEndDelay_ms / 1000.0;

// Outlets measure at that many different instants of a report, a batch of kLanes at each.
constexpr std::size_t kInstants = 64;
constexpr std::size_t kChunk = kInstants * kLanes;

double instant_s(std::size_t instant) {
  return kReport_s * (static_cast<double>(instant) + 0.5) / static_cast<double>(kInstants);
}

void demand_delay(double delay_s) {
  demand(delay_s >= 0.0 && delay_s <= 300.0,
         fmt::format("a delay of {:g} s is not within 0 … 300 s", delay_s));
}

void check_scenario(const grid::Grid& grid, const ScenarioOptions& o) {
  demand(o.loss_mw > 0.0 && o.loss_mw <= grid.base_mw,
         fmt::format("a loss of {:g} MW is not above 0 and at most {:g} MW, the grid's base power",
                     o.loss_mw, grid.base_mw));
  demand(o.noise_hz >= 0.0 && o.noise_hz <= 1.0,
         fmt::format("a noise of {:g} Hz is not within 0 … 1 Hz", o.noise_hz));
  demand(o.duration_s >= 1.0 && o.duration_s <= 300.0,
         fmt::format("a duration of {:g} s is not within 1 … 300 s", o.duration_s));
  demand_delay(o.further_delay_s);
  check(static_cast<const Controls&>(o));
}

// The outlets of a fleet, advanced by one measurement at a time.
class Outlets {
 public:
  Outlets(const grid::Grid& grid, const Fleet& fleet, const ScenarioOptions& options,
          std::size_t threads)
      : fleet_(fleet),
        options_(options),
        workers_(threads),
        settings_(control_centre::grid_settings(grid, options.rules)),
        chunks_((fleet.outlets() + kChunk - 1) / kChunk),
        off_(fleet.outlets(), 0),
        shed_mw_(chunks_ * kInstants, 0.0) {
    if (options.threshold_mw > 0.0) {
      settings_.threshold_mw = static_cast<float>(options.threshold_mw);
    }
    if (options.control == Control::kGridSense) {
      estimators_.resize(chunks_ * kInstants);
    } else {
      below_.assign(fleet.outlets(), 0);
      for (const double group_hz : switch_off_hz(grid, fleet, options.rules)) {
        switch_off_hz_.push_back(static_cast<float>(group_hz - grid.nominal_hz));
      }
      highest_switch_off_hz_ = *std::max_element(switch_off_hz_.begin(), switch_off_hz_.end());
    }
  }

  // Takes one report of every outlet. Report 0 is within 16 ms after the loss.
  void take(int report, Balance& balance) {
    double deviation_hz[kInstants];
    for (std::size_t i = 0; i < kInstants; ++i) {
      deviation_hz[i] = balance.deviation_hz(at_s(report, i) - kMeasuring_s);
    }
    if (nothing_to_do(report, deviation_hz)) {
      return;
    }
    std::fill(shed_mw_.begin(), shed_mw_.end(), 0.0);
    workers_.run(chunks_, [&](std::size_t chunk) { take_chunk(chunk, report, deviation_hz); });
    for (std::size_t i = 0; i < kInstants; ++i) {
      double sum_mw = 0.0;
      for (std::size_t chunk = 0; chunk < chunks_; ++chunk) {
        sum_mw += shed_mw_[chunk * kInstants + i];
      }
      balance.shed(at_s(report, i) + kRelay_s + options_.further_delay_s, sum_mw);
    }
  }

  const std::vector<std::uint8_t>& off() const { return off_; }

 private:
  static double at_s(int report, std::size_t instant) {
    return kReport_s * static_cast<double>(report) + instant_s(instant);
  }

  // The number of the first report that measures the time after the loss.
  static int first_after(std::size_t instant) {
    return static_cast<int>(std::ceil((kMeasuring_s - instant_s(instant)) / kReport_s));
  }

  int since_event(int report, std::size_t instant) const {
    return report - first_after(instant) - settings_.event_drops;
  }

  int decides_at() const { return gs::outlet::reports_to_decision(settings_) - 1; }

  bool nothing_to_do(int report, const double* deviation_hz) const {
    if (options_.control == Control::kGridSense) {
      return since_event(report, kInstants - 1) < 0 || since_event(report, 0) > decides_at();
    }
    const double furthest = options_.distribution == NoiseDistribution::kUniform ? 1.0 : 8.0;
    const double lowest = *std::min_element(deviation_hz, deviation_hz + kInstants);
    return lowest - furthest * options_.noise_hz > static_cast<double>(highest_switch_off_hz_);
  }

  void take_chunk(std::size_t chunk, int report, const double* deviation_hz) {
    const std::size_t first = chunk * kChunk;
    const std::size_t count = std::min(kChunk, fleet_.outlets() - first);
    float measured_hz[kChunk];
    for (std::size_t i = 0; i < kInstants; ++i) {
      std::fill_n(measured_hz + i * kLanes, kLanes, static_cast<float>(deviation_hz[i]));
    }
    const auto noise = options_.distribution == NoiseDistribution::kUniform ? models::add_uniform
                                                                            : models::add_gaussian;
    noise({options_.seed, models::kTrajectory, static_cast<std::uint32_t>(report)}, first, kChunk,
          static_cast<float>(options_.noise_hz), measured_hz);
    for (std::size_t i = 0; i < kInstants && i * kLanes < count; ++i) {
      const std::size_t begin = first + i * kLanes;
      const std::size_t end = std::min(begin + kLanes, first + count);
      if (options_.control == Control::kGridSense) {
        estimate(chunk, i, begin, end, report, measured_hz + i * kLanes);
      } else {
        compare(chunk, i, begin, end, measured_hz + i * kLanes);
      }
    }
  }

  void estimate(std::size_t chunk, std::size_t instant, std::size_t begin, std::size_t end,
                int report, const float* measured_hz) {
    const int since = since_event(report, instant);
    if (since < 0 || since > decides_at()) {
      return;
    }
    LossEstimator<Lanes>& estimator = estimators_[chunk * kInstants + instant];
    take_report(settings_, estimator, measured_hz, since);
    if (since < decides_at()) {
      return;
    }
    float loss_mw[kLanes];
    store(estimator.ekf.loss_mw, loss_mw);
    for (std::size_t outlet = begin; outlet < end; ++outlet) {
      if (sheds(fleet_, outlet, loss_mw[outlet - begin], settings_.threshold_mw)) {
        switch_off(chunk, instant, outlet);
      }
    }
  }

  void compare(std::size_t chunk, std::size_t instant, std::size_t begin, std::size_t end,
               const float* measured_hz) {
    for (std::size_t outlet = begin; outlet < end; ++outlet) {
      if (gs::outlet::stays_below(measured_hz[outlet - begin],
                                  switch_off_hz_[outlet / fleet_.per_group],
                                  settings_.switch_off_samples, below_[outlet]) &&
          off_[outlet] == 0) {
        switch_off(chunk, instant, outlet);
      }
    }
  }

  void switch_off(std::size_t chunk, std::size_t instant, std::size_t outlet) {
    off_[outlet] = 1;
    shed_mw_[chunk * kInstants + instant] += 1e-6 * static_cast<double>(fleet_.power_w[outlet]);
  }

  const Fleet& fleet_;
  const ScenarioOptions& options_;
  drivers::Workers workers_;
  Settings settings_;
  std::size_t chunks_;
  std::vector<LossEstimator<Lanes>> estimators_;
  std::vector<std::uint8_t> below_;   // successive measurements below the switching-off frequency
  std::vector<float> switch_off_hz_;  // of each group, as a deviation
  float highest_switch_off_hz_ = 0.0F;
  std::vector<std::uint8_t> off_;
  std::vector<double> shed_mw_;  // in the current report, by chunk and instant
};

void simulate_relays(const grid::Grid& grid, const ScenarioOptions& options, Balance& balance) {
  const std::vector<double> stages_hz = ufls_stages_hz(grid, options);
  auto stage = stages_hz.begin();
  const auto steps = static_cast<int>(options.duration_s / kStep_s);
  for (int step = 0; step < steps; ++step) {
    const double t_s = kStep_s * step;
    while (stage != stages_hz.end() && balance.deviation_hz(t_s) < *stage) {
      balance.shed(t_s + options.ufls_delay_s, options.ufls_part * grid.load_mw);
      ++stage;
    }
  }
}

}  // namespace

std::vector<double> ufls_stages_hz(const grid::Grid& grid, const Controls& controls) {
  const double first_hz =
      controls.ufls_first_hz > 0.0 ? controls.ufls_first_hz : 0.98 * grid.nominal_hz;
  std::vector<double> stages_hz(kUflsStages);
  for (std::size_t stage = 0; stage < kUflsStages; ++stage) {
    stages_hz[stage] =
        first_hz - grid.nominal_hz - controls.ufls_step_hz * static_cast<double>(stage);
  }
  return stages_hz;
}

void check(const Controls& controls) {
  demand_delay(controls.central_delay_s);
  demand_delay(controls.central_decision_s);
  demand_delay(controls.ufls_delay_s);
}

std::optional<ScenarioResult> simulate(const grid::Grid& grid, const Fleet& fleet,
                                       const ScenarioOptions& options, const Execution& execution) {
  check_scenario(grid, options);
  if (stopped(execution)) {
    return std::nullopt;
  }
  const grid::SfrModel model(grid);
  const double threshold_mw = options.threshold_mw > 0.0
                                  ? options.threshold_mw
                                  : control_centre::threshold_mw(grid, options.rules);
  const double required_mw = std::max(options.loss_mw - threshold_mw, 0.0);
  Balance balance(model, options.loss_mw);
  Shed shed;
  if (options.control == Control::kGridSense || options.control == Control::kSwitchOff) {
    Outlets outlets(grid, fleet, options, execution.threads);
    const auto reports = static_cast<int>(options.duration_s / kReport_s);
    for (int report = 0; report < reports; ++report) {
      if (stopped(execution)) {
        return std::nullopt;
      }
      outlets.take(report, balance);
      report_progress(execution, report + 1, reports);
    }
    shed = count_shed(fleet, outlets.off());
  } else if (options.control == Control::kCentral) {
    balance.shed(options.central_decision_s + options.central_delay_s,
                 std::min(required_mw, fleet.power_mw));
  } else if (options.control == Control::kUfls) {
    simulate_relays(grid, options, balance);
  }
  ScenarioResult result = balance.result(grid, options.duration_s, shed);
  result.threshold_mw = threshold_mw;
  result.required_mw = required_mw;
  return result;
}

}  // namespace gsbench::fleet
