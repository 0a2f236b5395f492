// A million outlets, §6.5.
#include "sections.hpp"
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cmath>

#include <campaign/estimates.hpp>
#include <campaign/fleet.hpp>
#include <campaign/scenario.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::reproduce {
namespace {

using campaign::Accumulation;
using campaign::Control;
using campaign::EstimateOptions;
using campaign::Fleet;
using campaign::FleetOptions;
using campaign::Mode;
using campaign::ScenarioOptions;
using campaign::Shed;
using record::kNoFigure;

Fleet fleet_of(const Study& study, Accumulation accumulation) {
  FleetOptions all;
  all.accumulation = accumulation;
  all.seed = study.options().seed;
  return make_fleet(all);
}

// As many as there are outlets, whatever was asked for elsewhere.
std::vector<float> estimates_of(const Study& study, Mode mode, double parameter_error,
                                std::size_t outlets, const Execution& execution) {
  EstimateOptions all = study.campaign(mode);
  all.parameter_error = parameter_error;
  all.trajectories = outlets;
  std::vector<float> estimates(outlets, 0.0F);
  estimate(study.grid(), all, execution,
           [&](std::uint64_t first, const float* mw, std::size_t count) {
             std::copy_n(mw, count, estimates.begin() + static_cast<std::ptrdiff_t>(first));
           });
  return estimates;
}

record::FigureRow shed_row(const std::string& name, const Shed& shed, double wanted_mw) {
  return {
      name,
      {shed.power_mw, 100.0 * (shed.power_mw / wanted_mw - 1.0), static_cast<double>(shed.outlets),
       static_cast<double>(shed.first_partly), static_cast<double>(shed.end_partly + 1)}};
}

}  // namespace

PageSection fig20_and_21(Study& study, const Execution& execution) {
  const grid::Grid& grid = study.grid();
  PageSection section;
  int n = 0;
  const double threshold_mw = control_centre::threshold_mw(grid::SfrModel(grid), grid.threshold_hz);
  const double wanted_mw = kLossMw - threshold_mw;
  record::FigureTable table = {
      "Shed after 500 MW, by the estimates of Fig. 17 and of Table 5",
      "",
      {"MW", "off what is wanted, %", "outlets", "wholly off up to group", "wholly on from group"},
      {{"wanted", {wanted_mw, 0.0, kNoFigure, kNoFigure, kNoFigure}},
       {"paper, §6.5.1", {148.34, 100.0 * (148.34 / 148.1 - 1.0), 164793, 118, 199}},
       {"paper, §6.5.2 (Table 5)",
        {148.97, 100.0 * (148.97 / 148.1 - 1.0), 165540, kNoFigure, kNoFigure}}}};
  record::CurvePlot power = {"Accumulated power of the groups (Fig. 20).", "group", "MW"};
  const Fleet half = fleet_of(study, Accumulation::kHalfGroup);
  const Fleet whole = fleet_of(study, Accumulation::kWholeGroup);
  for (std::size_t group = 0; group < half.groups(); ++group) {
    power.x.push_back(static_cast<double>(group + 1));
  }
  power.curves = {{"P^A", half.accumulated_mw}};
  record::CurvePlot groups = {"Outlets that switch off in each group.", "group", "outlets off"};
  groups.x = power.x;
  for (const Mode mode : {Mode::kPaper, Mode::kGsbench}) {
    for (const double error : {0.0, 0.05}) {
      const auto estimates =
          estimates_of(study, mode, error, half.outlets(), nth_of(execution, n++, 4));
      if (stopped(execution)) {
        continue;  // not all outlets have one
      }
      const std::string name = std::string(mode == Mode::kPaper ? "paper's way" : "gsbench") +
                               (error > 0.0 ? ", parameters 5 % off" : "") + ", P^A with ";
      const Shed shed = shed_by_estimates(half, estimates, threshold_mw);
      table.rows.push_back(shed_row(name + "half of its own group", shed, wanted_mw));
      table.rows.push_back(shed_row(name + "its whole group, eq. (11)",
                                    shed_by_estimates(whole, estimates, threshold_mw), wanted_mw));
      if (mode == Mode::kGsbench) {
        record::Curve curve{error > 0.0 ? "parameters 5 % off" : "exact parameters", {}};
        for (const std::uint32_t count : shed.off_in_group) {
          curve.y.push_back(static_cast<double>(count));
        }
        groups.curves.push_back(curve);
      }
    }
  }
  groups.steps = true;
  section.tables = {table};
  section.plots = {power, groups};
  section.paragraphs = {
      "By eq. (11) an outlet compares with the power up to and with its own group, so that on "
      "average half a group too little is shed, 0.45 MW here. gsbench counts half of the own "
      "group: it goes off where the requirement passes its middle."};
  return section;
}

PageSection fig22(Study& study, const Execution& execution) {
  const grid::Grid& grid = study.grid();
  PageSection section;
  const Fleet fleet = fleet_of(study, Accumulation::kHalfGroup);
  record::FigureTable table = {
      "After 500 MW, the shed load fed back into the grid",
      "",
      {"shed, MW", "first action, s", "last action, s", "nadir, Hz", "at, s", "end, Hz"},
      {}};
  record::CurvePlot plot = {"The frequency.", "s", "Hz"};
  ScenarioOptions choice;
  choice.loss_mw = kLossMw;
  choice.law = study.options().choices.noise_law;
  choice.seed = study.options().seed;
  int n = 0;
  const auto add = [&](const std::string& name) {
    auto result = play_whole(grid, fleet, choice, nth_of(execution, n++, 3));
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
        grid::SfrModel(grid), grid.threshold_hz, kLossMw, plain->last_action_s);
    add("with a threshold that knows of the delay");
  }
  section.tables = {table};
  section.plots = {plot};
  section.paragraphs = {
      "Eq. (15) takes shedding to be instant: with the outlets' delay the nadir comes to lie a "
      "little below f_s. A threshold for the delay and this loss keeps it."};
  return section;
}

}  // namespace gsbench::reproduce
