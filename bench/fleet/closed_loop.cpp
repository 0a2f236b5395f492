#include "firmware_outlets.hpp"
#include "played_grid.hpp"
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <fleet/clairvoyant.hpp>
#include <fleet/closed_loop.hpp>

namespace gsbench::fleet {
namespace {

using campaign::demand;
using campaign::Execution;
using profile::Plan;

constexpr double kClairvoyantStep_s = 0.016;
constexpr double kCentralStep_s = 0.1;  // between decisions of the controller
constexpr double kRounding_s = 1e-9;
constexpr double kCurveStep_s = 0.02;

// Losses before the start of the signal are part of its initial state.
double first_loss_s(const Plan& plan) {
  double first_s = std::numeric_limits<double>::infinity();
  for (const grid::PowerChange& change : plan.stimulus.losses) {
    if (change.at_s >= 0.0 && change.power_mw > 0.0) {
      first_s = std::min(first_s, change.at_s);
    }
  }
  return first_s;
}

double end_of(const Plan& plan, const ClosedLoopOptions& options) {
  double end_s = plan.stimulus.duration_s;
  for (const grid::PowerChange& change : plan.stimulus.losses) {
    end_s = std::max(end_s, change.at_s + change.ramp_s + options.after_loss_s);
  }
  return end_s;
}

class Loop {
 public:
  Loop(const Plan& plan, const Fleet& fleet, Strategy strategy, const ClosedLoopOptions& options,
       const Execution& execution)
      : plan_(plan),
        fleet_(fleet),
        strategy_(strategy),
        options_(options),
        execution_(execution),
        grid_(plan),
        end_s_(end_of(plan, options)) {}

  std::optional<ClosedLoopResult> simulate() {
    const std::optional<double> knows_after_s = knows_loss_after_s(strategy_);
    bool done = true;
    if (has_outlets(strategy_)) {
      done = play_into_outlets();
    } else if (strategy_ == Strategy::kCentral) {
      control_centrally();
    } else if (strategy_ == Strategy::kUfls) {
      watch_by_relays();
    } else if (knows_after_s) {
      shed_by_clairvoyant(*knows_after_s);
    }
    if (!done || stopped(execution_)) {
      return std::nullopt;
    }
    follow_frequency();
    return result_;
  }

 private:
  void switch_off(double at_s, double power_mw) {
    if (at_s > end_s_ || power_mw == 0.0) {
      return;
    }
    grid_.switch_off(at_s, power_mw);
    off_mw_ += power_mw;
    result_.shed_mw = std::max(result_.shed_mw, off_mw_);
    if (power_mw > 0.0) {
      result_.first_action_s = result_.first_action_s.value_or(at_s);
      result_.last_action_s = at_s;
    }
  }

  // Returns false if it was stopped. What outlets switch takes effect kRelay_ms after their report,
  // so that pieces of this length know all that was switched before.
  bool play_into_outlets() {
    const std::int64_t rate_hz = plan_.stimulus.sample_rate_hz;
    const auto rate = static_cast<double>(rate_hz);
    const std::int64_t piece = kRelay_ms * rate_hz / 1000;
    const std::int64_t pieces = std::llround(end_s_ * rate) / piece;
    const double loss_s = first_loss_s(plan_);
    const bool recorded = plays_recorded_frequency(plan_);
    FirmwareOutlets outlets(plan_, fleet_, strategy_, options_,
                            recorded ? 0 : waveform::tick_at(loss_s, rate_hz), execution_.threads);
    std::vector<float> voltage_pu(static_cast<std::size_t>(piece));
    for (std::int64_t i = 0; i < pieces; ++i) {
      if (stopped(execution_)) {
        return false;
      }
      grid_.render(i * piece, voltage_pu.size(), voltage_pu.data());
      for (const Switched& each : outlets.take(i * piece, voltage_pu)) {
        switch_off(static_cast<double>(each.tick) / rate, each.power_mw);
      }
      report_progress(execution_, static_cast<double>(i + 1), static_cast<double>(pieces));
    }
    result_.outlets = outlets.actions();
    if (recorded) {
      result_.outlets->false_events.reset();
    }
    return true;
  }

  // By eq. (29). What is off stays off.
  void control_centrally() {
    const double threshold_mw =
        options_.threshold_mw > 0.0
            ? options_.threshold_mw
            : control_centre::threshold_mw(grid_.model(), plan_.grid.threshold_hz);
    const auto steps = static_cast<int>(end_s_ / kCentralStep_s);
    for (int step = 0; step <= steps; ++step) {
      const double t_s = kCentralStep_s * step;
      const double known_mw =
          known_loss_mw(grid_.losses(), t_s - options_.central_delay_s + kRounding_s,
                        options_.central_decision_s);
      const double wanted_mw = std::min(known_mw - threshold_mw, fleet_.power_mw);
      if (wanted_mw - off_mw_ >= kLeastAction_mw) {
        switch_off(t_s, wanted_mw - off_mw_);
      }
    }
  }

  void watch_by_relays() {
    const std::vector<double> stages_hz = ufls_stages_hz(plan_.grid, options_);
    auto stage = stages_hz.begin();
    const auto steps = static_cast<int>(end_s_ / kStep_s);
    for (int step = 0; step < steps; ++step) {
      const double t_s = kStep_s * step;
      while (stage != stages_hz.end() && grid_.state(t_s).deviation_hz < *stage) {
        switch_off(t_s + options_.ufls_delay_s, options_.ufls_part * plan_.grid.load_mw);
        ++stage;
      }
    }
  }

  void shed_by_clairvoyant(double knows_after_s) {
    // The model is linear: a deviation from before the start stays and adds to the response.
    const double before_hz = plan_.stimulus.initial_deviation_hz;
    const double goal_hz = plan_.grid.threshold_hz - plan_.grid.nominal_hz - before_hz;
    const auto steps = static_cast<int>(end_s_ / kClairvoyantStep_s);
    for (int step = 0; step < steps; ++step) {
      const double t_s = kClairvoyantStep_s * step;
      const double known_mw = known_loss_mw(grid_.losses(), t_s, knows_after_s) - off_mw_;
      GridState known = with_power(grid_.model(), grid_.state(t_s), known_mw);
      known.deviation_hz -= before_hz;
      const double shed_mw =
          least_shed_mw(grid_.model(), known, goal_hz, fleet_.power_mw - off_mw_);
      if (shed_mw >= kLeastAction_mw) {
        switch_off(t_s, shed_mw);
      }
    }
  }

  void follow_frequency() {
    const auto steps = static_cast<std::size_t>(end_s_ / kStep_s);
    const auto each = static_cast<std::size_t>(std::llround(kCurveStep_s / kStep_s));
    double lowest_hz = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= steps; ++i) {
      const double t_s = kStep_s * static_cast<double>(i);
      const double now_hz = grid_.state(t_s).deviation_hz;
      if (now_hz < lowest_hz) {
        lowest_hz = now_hz;
        result_.nadir_s = t_s;
      }
      if (i % each == 0 || i == steps) {
        result_.t_s.push_back(t_s);
        result_.frequency_hz.push_back(plan_.grid.nominal_hz + now_hz);
      }
    }
    result_.nadir_hz = plan_.grid.nominal_hz + lowest_hz;
    result_.end_hz = result_.frequency_hz.back();
  }

  const Plan& plan_;
  const Fleet& fleet_;
  Strategy strategy_;
  const ClosedLoopOptions& options_;
  const Execution& execution_;
  PlayedGrid grid_;
  double end_s_;
  double off_mw_ = 0.0;
  ClosedLoopResult result_;
};

}  // namespace

std::optional<ClosedLoopResult> simulate_closed_loop(const Plan& plan, const Fleet& fleet,
                                                     Strategy strategy,
                                                     const ClosedLoopOptions& options,
                                                     const Execution& execution) {
  demand(fleet.outlets() <= kMostInClosedLoop,
         fmt::format("a closed loop has at most {} outlets, not {}", kMostInClosedLoop,
                     fleet.outlets()));
  demand(options.after_loss_s >= 1.0 && options.after_loss_s <= 300.0,
         fmt::format("a duration of {:g} s is not within 1 … 300 s", options.after_loss_s));
  check(options);
  demand(is_possible(plan, strategy),
         fmt::format("{} needs to know the lost power, but profile {} plays a recorded frequency",
                     to_string(strategy), plan.name));
  return Loop(plan, fleet, strategy, options, execution).simulate();
}

profile::Plan plan_of_loss(const grid::Grid& grid, double loss_mw, double at_s, double noise_pct,
                           std::uint64_t seed) {
  demand(loss_mw > 0.0 && loss_mw <= grid.base_mw,
         fmt::format("a loss of {:g} MW is not above 0 and at most {:g} MW, the grid's base power",
                     loss_mw, grid.base_mw));
  Plan plan;
  plan.name = fmt::format("loss of {:g} MW", loss_mw);
  plan.grid = grid;
  plan.stimulus.losses = {{at_s, loss_mw}};
  plan.stimulus.duration_s = at_s;
  plan.stimulus.noise_pct = noise_pct;
  plan.seed = seed;
  return plan;
}

}  // namespace gsbench::fleet
