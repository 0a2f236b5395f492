#include "closed_loop_page.hpp"

#include <control_centre/threshold.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <fleet/closed_loop.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::fleet {
namespace {

using campaign::Execution;
using record::kNoFigure;

constexpr double kBeforeLoss_s = 1.0;
constexpr double kNoise_pct = 1.0;
constexpr double kEventToAction_s = 0.8;  // from an outlet's event to its open relay

}  // namespace

double delay_aware_threshold_mw(const grid::Grid& grid, double loss_mw, double last_action_s) {
  return control_centre::threshold_for_delay_mw(grid::SfrModel(grid), grid.threshold_hz, loss_mw,
                                                last_action_s);
}

record::PageSection closed_loop_section(const grid::Grid& grid, const Study& study,
                                        const Execution& execution) {
  const Fleet fleet = make_fleet(in_fewer_outlets(study.fleet, kClosedLoopOutlets));
  const profile::Plan plan =
      plan_of_loss(grid, study.scenario.loss_mw, kBeforeLoss_s, kNoise_pct, study.fleet.seed);
  const double required_mw =
      std::max(study.scenario.loss_mw -
                   control_centre::threshold_mw(grid::SfrModel(grid), grid.threshold_hz),
               0.0);
  ClosedLoopOptions options;
  options.after_loss_s = study.scenario.duration_s;
  record::FigureTable table = {"1 % white noise on each outlet's voltage", "", {}};
  record::CurvePlot plot = {"The frequency of the grid.", "s", "Hz"};
  std::vector<std::string> notes;
  for (const char* const name : {"threshold loss by eq. (15)", "delay-aware threshold"}) {
    const auto result = simulate_closed_loop(plan, fleet, Strategy::kPaper, options, execution);
    if (!result) {
      break;
    }
    const OutletActions& outlets = *result->outlets;
    const auto after_loss_s = [](const std::optional<double>& t_s) {
      return t_s ? *t_s - kBeforeLoss_s : kNoFigure;
    };
    const record::FigureRow rows[] = {
        {"required, MW", {required_mw}, 2},
        {"shed, MW", {result->shed_mw}, 2},
        {"outlets off", {static_cast<double>(outlets.off)}},
        {"outlets that detected the loss", {static_cast<double>(outlets.events)}},
        {"outlets with an event before it", {static_cast<double>(*outlets.false_events)}},
        {"last event, s", {after_loss_s(outlets.latest_event_s)}, 3},
        {"estimates, mean, MW", {outlets.loss_mw.mean()}, 2},
        {"estimates, σ, MW", {outlets.loss_mw.standard_deviation()}, 2},
        {"first action, s", {after_loss_s(result->first_action_s)}, 3},
        {"last action, s", {after_loss_s(result->last_action_s)}, 3},
        {"nadir, Hz", {result->nadir_hz}, 3},
        {"nadir at, s", {result->nadir_s - kBeforeLoss_s}, 3},
        {"end, Hz", {result->end_hz}, 3}};
    table.columns.push_back({name});
    for (std::size_t i = 0; i < std::size(rows); ++i) {
      if (table.rows.size() <= i) {
        table.rows.push_back(rows[i]);
      } else {
        table.rows[i].figures.push_back(rows[i].figures[0]);
      }
    }
    plot.x.clear();
    for (const double t_s : result->t_s) {
      plot.x.push_back(t_s - kBeforeLoss_s);
    }
    plot.curves.push_back({name, result->frequency_hz});
    if (options.threshold_mw > 0.0) {
      break;
    }
    if (result->nadir_hz < grid.threshold_hz) {
      notes.emplace_back(
          "With the threshold loss by eq. (15) the nadir is below f_s. A small group has a "
          "switching-off frequency f^B just below f_s. If the nadir is below f^B of a group, its "
          "outlets switch off even if they had decided not to shed.");
    }
    if (outlets.events == 0) {
      notes.push_back(
          fmt::format("No outlet detected the loss of {:g} MW, so there is no delay to compute a "
                      "threshold loss for.",
                      study.scenario.loss_mw));
      break;
    }
    options.threshold_mw = delay_aware_threshold_mw(
        grid, study.scenario.loss_mw, after_loss_s(outlets.latest_event_s) + kEventToAction_s);
    if (options.threshold_mw == 0.0) {
      notes.emplace_back(kTooLate);
      break;
    }
    notes.push_back(
        fmt::format("The delay-aware threshold is {:.2f} MW: a threshold loss that allows for the "
                    "delay of the outlets.",
                    options.threshold_mw));
  }
  return {{table},
          {plot},
          notes,
          fmt::format("{} outlets with the whole firmware, starting from the sampled voltage",
                      fleet.outlets()),
          "closed-loop"};
}

record::PageSection strategies_after_loss(const grid::Grid& grid, const Study& study,
                                          const Execution& execution) {
  const profile::Plan plan =
      plan_of_loss(grid, study.scenario.loss_mw, kBeforeLoss_s, kNoise_pct, study.fleet.seed);
  const Fleet fleet = fleet_of(plan, study);
  const ClosedLoopOptions options = options_of(study);
  record::PageSection section = strategies_section(
      plan, fleet, options, simulate_strategies(plan, fleet, options, execution));
  section.paragraphs.push_back(fmt::format("The loss is {:g} s after the start.", kBeforeLoss_s));
  return section;
}

}  // namespace gsbench::fleet
