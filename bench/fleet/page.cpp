// The page of `gsbench fleet`.
#include "closed_loop_page.hpp"
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <fleet/page.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::fleet {
namespace {

using campaign::Execution;
using campaign::NoiseDistribution;
using record::kNoFigure;

constexpr double kLossParts[] = {0.9, 1.0, 1.1, 1.2, 1.42, 1.7, 2.0};  // of the threshold loss

constexpr const char* kGridSense = "Grid Sense";
constexpr std::pair<Control, const char*> kControls[] = {
    {Control::kNone, "no control"},
    {Control::kGridSense, kGridSense},
    {Control::kSwitchOff, "switching-off frequencies alone"},
    {Control::kCentral, "central control"},
    {Control::kUfls, "under-frequency relays"}};

record::FigureRow shed_row(const std::string& name, const Shed& shed) {
  const bool outlets = !shed.off_in_group.empty();
  const auto count = [&](std::size_t value) {
    return outlets ? static_cast<double>(value) : kNoFigure;
  };
  return {
      name,
      {shed.power_mw, count(shed.outlets), count(shed.first_partly), count(shed.end_partly + 1)}};
}

record::PageSection controls(const grid::Grid& grid, const Study& study, const Fleet& fleet,
                             const Execution& execution) {
  record::FigureTable shed = {
      "Load shed",
      "",
      {{"shed, MW", 2},
       {"outlets off"},
       {"fully off up to group", 0, 1.0},
       {"fully on from group", 0, 1.0, static_cast<double>(fleet.groups())}}};
  record::FigureTable actions = {
      "Actions and frequency; the load shed acts back on the grid's frequency",
      "",
      {{"first action, s", 3},
       {"last action, s", 3},
       {"nadir, Hz", 3},
       {"nadir at, s", 3},
       {"end, Hz", 3}}};
  record::CurvePlot plot = {"The frequency of the grid.", "s", "Hz"};
  record::CurvePlot groups = {"Outlets off in each group.", "group", "outlets"};
  groups.steps = true;
  std::vector<std::string> notes;
  ScenarioOptions options = study.scenario;
  double last_action_s = kNoFigure;
  double threshold_mw = 0.0;
  const auto add = [&](const std::string& name) {
    auto result = simulate(grid, fleet, options, execution);
    if (result) {
      shed.rows.push_back(shed_row(name, result->shed));
      actions.rows.push_back({name,
                              {result->first_action_s, result->last_action_s, result->nadir_hz,
                               result->nadir_s, result->end_hz}});
      plot.x = result->t_s;
      plot.curves.push_back({name, result->frequency_hz});
    }
    return result;
  };
  for (const auto& [control, title] : kControls) {
    options.control = control;
    const auto result = add(title);
    if (control == Control::kGridSense && result) {
      threshold_mw = result->threshold_mw;
      last_action_s = result->last_action_s;
      record::Curve curve{"off", {}};
      for (std::size_t group = 0; group < result->shed.off_in_group.size(); ++group) {
        groups.x.push_back(static_cast<double>(group + 1));
        curve.y.push_back(static_cast<double>(result->shed.off_in_group[group]));
      }
      groups.curves = {curve};
    }
  }
  if (study.delay_aware && std::isfinite(last_action_s)) {
    options.control = Control::kGridSense;
    options.threshold_mw = delay_aware_threshold_mw(grid, options.loss_mw, last_action_s);
    if (options.threshold_mw > 0.0) {
      add(fmt::format("{}, threshold loss {:.2f} MW", kGridSense, options.threshold_mw));
      notes.push_back(fmt::format(
          "The threshold loss of {:.2f} MW allows for the delay of the outlets' last action.",
          options.threshold_mw));
    } else {
      notes.emplace_back(kTooLate);
    }
  } else if (study.delay_aware && !stopped(execution)) {
    notes.push_back(
        fmt::format("No outlet switched off after the loss of {:g} MW, so there is no delay to "
                    "compute a threshold loss for.",
                    options.loss_mw));
  }
  notes.insert(
      notes.begin(),
      fmt::format(
          "The threshold loss in use is {:.2f} MW, {}; {:.2f} MW have to be shed with it. A "
          "group is a load block. The load-shedding conditions and an outlet's check of its "
          "own estimate are not part of this model.",
          threshold_mw,
          study.scenario.rules == control_centre::Rules::kPaper
              ? "by eq. (15), which assumes that load is shed at once"
              : "which allows for the delay of the outlets",
          std::max(study.scenario.loss_mw - threshold_mw, 0.0)));
  return {{shed, actions},
          {plot, groups},
          notes,
          fmt::format("After a loss of {:g} MW", study.scenario.loss_mw),
          "controls"};
}

// By loss and another parameter. `figure` returns kNoFigure for an empty cell.
template <class Figure>
record::FigureTable heat_map(const std::string& caption, int decimals,
                             const std::vector<double>& losses_mw,
                             const std::vector<double>& columns, const Figure& figure) {
  record::FigureTable table = {caption, "loss", {}, {}, true};
  for (const double column : columns) {
    table.columns.push_back({fmt::format("{:g}", column), decimals});
  }
  for (const double loss_mw : losses_mw) {
    record::FigureRow row = {fmt::format("{:.5g} MW", loss_mw), {}};
    for (const double column : columns) {
      row.figures.push_back(figure(loss_mw, column));
    }
    table.rows.push_back(row);
  }
  return table;
}

std::vector<double> losses_of(const grid::Grid& grid, const Sweep& sweep) {
  if (!sweep.losses_mw.empty()) {
    return sweep.losses_mw;
  }
  const double threshold_mw = control_centre::threshold_mw(grid::SfrModel(grid), grid.threshold_hz);
  std::vector<double> losses_mw;
  for (const double part : kLossParts) {
    if (part * threshold_mw <= grid.base_mw) {
      losses_mw.push_back(part * threshold_mw);
    }
  }
  return losses_mw;
}

record::PageSection sweep(const grid::Grid& grid, const Study& study, const Fleet& fleet,
                          const Execution& execution) {
  const Sweep& over = *study.sweep;
  const std::vector<double> losses_mw = losses_of(grid, over);
  const char* const noise =
      study.scenario.distribution == NoiseDistribution::kUniform ? "half width" : "σ";
  std::vector<record::FigureTable> tables;
  const auto all = static_cast<double>(losses_mw.size() * over.noises_hz.size()) *
                   static_cast<double>(over.delays_s.size());
  double done = 0.0;
  ScenarioOptions options = study.scenario;
  options.control = Control::kGridSense;
  std::map<std::pair<double, double>, double> beyond_mw;  // by loss and noise, at the first delay
  for (const double delay_s : over.delays_s) {
    options.further_delay_s = delay_s;
    const auto nadir_hz = [&](double loss_mw, double noise_hz) {
      options.loss_mw = loss_mw;
      options.noise_hz = noise_hz;
      const auto result = simulate(grid, fleet, options, quiet(execution));
      report_progress(execution, ++done, all);
      if (!result) {
        return kNoFigure;
      }
      beyond_mw.try_emplace({loss_mw, noise_hz}, result->shed.power_mw - result->required_mw);
      return result->nadir_hz;
    };
    tables.push_back(
        heat_map(fmt::format("Nadir, Hz, by loss and noise ({}, Hz); outlets delayed by {:g} s",
                             noise, delay_s),
                 3, losses_mw, over.noises_hz, nadir_hz));
  }
  // Shown for one delay only: it hardly depends on the delay.
  tables.push_back(heat_map(
      fmt::format("Load shed above the required power, MW, by loss and noise ({}, Hz)", noise), 2,
      losses_mw, over.noises_hz, [&](double loss_mw, double noise_hz) {
        const auto cell = beyond_mw.find({loss_mw, noise_hz});
        return cell != beyond_mw.end() ? cell->second : kNoFigure;
      }));
  ScenarioOptions central = study.scenario;
  central.control = Control::kCentral;
  tables.push_back(
      heat_map(fmt::format("Central control, which knows the loss after {:g} s: nadir, "
                           "Hz, by loss and communication delay, s",
                           central.central_decision_s),
               3, losses_mw, over.delays_s, [&](double loss_mw, double delay_s) {
                 central.loss_mw = loss_mw;
                 central.central_delay_s = delay_s;
                 const auto result = simulate(grid, fleet, central, quiet(execution));
                 return result ? result->nadir_hz : kNoFigure;
               }));
  return {tables, {}, {}, "Sweep over loss, noise and delay", "sweep"};
}

// Before the first simulation: a sweep may take minutes.
void check(const grid::Grid& grid, const Study& study) {
  const auto demand_within = [](const std::vector<double>& values, double least, double most,
                                const char* what) {
    for (const double value : values) {
      campaign::demand(
          value >= least && value <= most,
          fmt::format("the sweep's {}: {:g} is not within {:g} … {:g}", what, value, least, most));
    }
  };
  demand_within(study.sweep->losses_mw, 0.001, grid.base_mw, "losses, MW");
  demand_within(study.sweep->noises_hz, 0.0, 1.0, "noises, Hz");
  demand_within(study.sweep->delays_s, 0.0, study.scenario.duration_s, "delays, s");
}

}  // namespace

record::Page make_page(const grid::Grid& grid, const Study& study,
                       const campaign::Execution& execution) {
  if (study.sweep) {
    check(grid, study);
  }
  const Fleet fleet = make_fleet(study.fleet);
  record::Page page;
  page.title = fmt::format("{} outlets with {:.1f} MW in total on grid {}", fleet.outlets(),
                           fleet.power_mw, grid.name);
  page.subtitle = grid.title;
  page.facts = {
      {"loss", fmt::format("{:g} MW", study.scenario.loss_mw)},
      {"noise of the measured frequency",
       fmt::format("{}{:g} Hz",
                   study.scenario.distribution == NoiseDistribution::kGaussian ? "Gaussian, σ = "
                                                                               : "uniform ±",
                   study.scenario.noise_hz)},
      {"seed", std::to_string(study.fleet.seed)}};
  page.sections = {controls(grid, study, fleet, execution)};
  if (study.closed_loop) {
    page.sections.push_back(closed_loop_section(grid, study, execution));
    if (!stopped(execution)) {
      page.sections.push_back(strategies_after_loss(grid, study, execution));
    }
  }
  if (study.sweep) {
    page.sections.push_back(sweep(grid, study, fleet, execution));
  }
  if (stopped(execution)) {
    page.facts.emplace_back("stopped",
                            "unfinished simulations are left out; the page is incomplete");
  }
  return page;
}

}  // namespace gsbench::fleet
