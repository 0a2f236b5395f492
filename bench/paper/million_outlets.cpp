// A million outlets, §6.5.
#include "sections.hpp"
#include <control_centre/blocks.hpp>
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cmath>

#include <campaign/estimates.hpp>
#include <fleet/fleet.hpp>
#include <fleet/scenario.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::paper {
namespace {

using campaign::Mode;
using control_centre::Accumulation;
using fleet::Control;
using fleet::Fleet;
using fleet::Shed;
using record::kNoFigure;

Fleet fleet_of(const Study& study, Accumulation accumulation) {
  fleet::FleetOptions all;
  all.accumulation = accumulation;
  all.seed = study.options.seed;
  return make_fleet(all);
}

// One for each outlet; the number of trajectories of the options does not apply here.
std::vector<float> estimates_of(const Study& study, Mode mode, double parameter_error,
                                std::size_t outlets, const Execution& execution) {
  campaign::EstimateOptions all = study.campaign(mode, parameter_error);
  all.trajectories = outlets;
  std::vector<float> estimates(outlets, 0.0F);
  estimate(study.grid, all, execution,
           [&](std::uint64_t first, const float* mw, std::size_t count) {
             std::copy_n(mw, count, estimates.begin() + static_cast<std::ptrdiff_t>(first));
           });
  return estimates;
}

record::FigureRow shed_row(const std::string& name, const Shed& shed, double required_mw) {
  return {name,
          {shed.power_mw, 100.0 * (shed.power_mw / required_mw - 1.0),
           static_cast<double>(shed.outlets), static_cast<double>(shed.first_partly),
           static_cast<double>(shed.end_partly + 1)}};
}

}  // namespace

PageSection fig20_and_21(Study& study, const Execution& execution) {
  const grid::Grid& grid = study.grid;
  int n = 0;
  const double threshold_mw = control_centre::threshold_mw(grid::SfrModel(grid), grid.threshold_hz);
  const double required_mw = kLoss_mw - threshold_mw;
  const Fleet by_eq_11 = fleet_of(study, Accumulation::kWholeGroup);
  const Fleet by_choice = fleet_of(study, study.options.accumulation);
  record::FigureTable table = {
      "Load shed after the loss of 500 MW, with the estimates of Fig. 17 and of Table 5",
      "",
      {{"shed, MW", 2},
       {"error, %", 2},
       {"outlets off"},
       {"fully off up to group", 0, 1.0},
       {"fully on from group", 0, 1.0, static_cast<double>(by_choice.groups())}},
      {{"required", {required_mw, 0.0, kNoFigure, kNoFigure, kNoFigure}},
       {"paper, §6.5.1", {148.34, 100.0 * (148.34 / 148.1 - 1.0), 164793, 118, 199}},
       {"paper, §6.5.2 (Table 5)",
        {148.97, 100.0 * (148.97 / 148.1 - 1.0), 165540, kNoFigure, kNoFigure}}}};
  record::CurvePlot power = {"Accumulated power of the groups, which are load blocks (Fig. 20).",
                             "group", "MW"};
  for (std::size_t group = 0; group < by_choice.groups(); ++group) {
    power.x.push_back(static_cast<double>(group + 1));
  }
  power.curves = {{"P^A", by_choice.accumulated_mw}};
  record::CurvePlot groups = {"Outlets that switch off in each group.", "group", "outlets off"};
  groups.x = power.x;
  for (const Mode mode : {Mode::kPaper, Mode::kFirmware}) {
    const Fleet& fleet = mode == Mode::kPaper ? by_eq_11 : by_choice;
    for (const double error : {0.0, 0.05}) {
      const auto estimates =
          estimates_of(study, mode, error, fleet.outlets(), nth_of(execution, n++, 4));
      if (stopped(execution)) {
        continue;  // not every outlet has an estimate
      }
      const Shed shed = shed_by_estimates(fleet, estimates, static_cast<float>(threshold_mw));
      table.rows.push_back(shed_row(name_of(mode, error) + (error > 0.0 ? ", errors of 5 %" : ""),
                                    shed, required_mw));
      if (mode == Mode::kFirmware) {
        record::Curve curve{error > 0.0 ? "parameters with errors of 5 %" : "exact parameters", {}};
        for (const std::uint32_t count : shed.off_in_group) {
          curve.y.push_back(static_cast<double>(count));
        }
        groups.curves.push_back(curve);
      }
    }
  }
  groups.steps = true;
  return {{table},
          {power, groups},
          {"P^A is the power that an outlet compares with the power to be shed. The paper's method "
           "takes it by eq. (11): all groups up to and including the outlet's own, so that on "
           "average half a group too little is shed, 0.45 MW here. Outlets are sent half of their "
           "own group instead: the group goes off if the power to be shed passes its middle. With "
           "--accumulated whole the firmware's rows use eq. (11), too."}};
}

PageSection fig22(Study& study, const Execution& execution) {
  const grid::Grid& grid = study.grid;
  const Fleet fleet = fleet_of(study, study.options.accumulation);
  record::FigureTable table = {
      "After the loss of 500 MW; the load shed acts back on the grid's frequency",
      "",
      {{"shed, MW", 2},
       {"first action, s", 3},
       {"last action, s", 3},
       {"nadir, Hz", 3},
       {"nadir at, s", 3},
       {"end, Hz", 3}},
      {}};
  record::CurvePlot plot = {"The frequency of the grid.", "s", "Hz"};
  fleet::ScenarioOptions choice;
  choice.loss_mw = kLoss_mw;
  choice.rules = control_centre::Rules::kPaper;
  choice.distribution = study.options.choices.noise_distribution;
  choice.seed = study.options.seed;
  int n = 0;
  const auto add = [&](const std::string& name) {
    auto result = simulate(grid, fleet, choice, nth_of(execution, n++, 3));
    if (result) {
      table.rows.push_back({name,
                            {result->shed.power_mw, result->first_action_s, result->last_action_s,
                             result->nadir_hz, result->nadir_s, result->end_hz}});
      plot.x = result->t_s;
      plot.curves.push_back({name, result->frequency_hz});
    }
    return result;
  };
  choice.control = Control::kNone;
  add("without Grid Sense");
  choice.control = Control::kGridSense;
  const auto plain = add("with Grid Sense");
  if (plain && std::isfinite(plain->last_action_s)) {
    choice.threshold_mw = control_centre::threshold_for_delay_mw(
        grid::SfrModel(grid), grid.threshold_hz, kLoss_mw, plain->last_action_s);
    if (choice.threshold_mw > 0.0) {
      add("delay-aware threshold");
    }
  }
  return {
      {table},
      {plot},
      {"Eq. (15) assumes that load is shed at once. Outlets act later, so that the nadir is a "
       "little below f_s. A threshold loss that allows for this delay keeps the nadir at f_s."}};
}

}  // namespace gsbench::paper
