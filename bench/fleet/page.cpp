// Pages of `gsbench fleet`.
#include <control_centre/threshold.hpp>

#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <fleet/closed_loop.hpp>
#include <fleet/page.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::fleet {
namespace {

using campaign::Execution;
using campaign::NoiseDistribution;
using record::kNoFigure;

constexpr std::size_t kClosedLoopOutlets = 1000;
constexpr double kToDecide_s = 0.8;  // from an event to an open relay
constexpr double kLossParts[] = {0.9, 1.0, 1.1, 1.2, 1.42, 1.7, 2.0};  // of the threshold

constexpr std::pair<Control, const char*> kControls[] = {
    {Control::kNone, "no control"},
    {Control::kGridSense, "Grid Sense, by each outlet's estimate"},
    {Control::kSwitchOff, "switching-off frequencies alone"},
    {Control::kCentral, "central control"},
    {Control::kUfls, "under-frequency load shedding"}};

record::FigureRow row_of(const std::string& name, const ScenarioResult& result) {
  const bool outlets = !result.shed.off_in_group.empty();
  const auto count = [&](std::size_t value) {
    return outlets ? static_cast<double>(value) : kNoFigure;
  };
  return {name,
          {result.shed.power_mw, count(result.shed.outlets), count(result.shed.first_partly),
           count(result.shed.end_partly + 1), result.first_action_s, result.last_action_s,
           result.nadir_hz, result.nadir_s, result.end_hz}};
}

// What keeps the nadir where outlets act that late.
double delay_aware_threshold_mw(const grid::Grid& grid, const ScenarioOptions& options,
                                double last_action_s) {
  return control_centre::threshold_for_delay_mw(grid::SfrModel(grid), grid.threshold_hz,
                                                options.loss_mw, last_action_s);
}

record::PageSection controls(const grid::Grid& grid, const Study& study, const Fleet& fleet,
                             const Execution& execution) {
  record::FigureTable table = {
      "The shed load fed back into the grid, each outlet at its own instant",
      "",
      {"shed, MW", "outlets off", "wholly off up to", "wholly on from", "first action, s",
       "last action, s", "nadir, Hz", "at, s", "end, Hz"}};
  record::CurvePlot plot = {"The frequency.", "s", "Hz"};
  record::CurvePlot groups = {"Outlets off in each group.", "group", "outlets"};
  groups.steps = true;
  ScenarioOptions options = study.scenario;
  double last_action_s = kNoFigure;
  double wanted_mw = 0.0;
  const auto add = [&](const std::string& name) {
    auto result = play(grid, fleet, options, execution);
    if (result) {
      table.rows.push_back(row_of(name, *result));
      plot.x = result->t_s;
      plot.curves.push_back({name, result->frequency_hz});
      wanted_mw = result->wanted_mw;
    }
    return result;
  };
  for (const auto& [control, title] : kControls) {
    options.control = control;
    const auto result = add(title);
    if (control == Control::kGridSense && result) {
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
    options.threshold_mw = delay_aware_threshold_mw(grid, options, last_action_s);
    add(fmt::format("Grid Sense, threshold {:.2f} MW for the delay", options.threshold_mw));
  }
  return {{table},
          {plot, groups},
          {fmt::format("Wanted are {:.2f} MW, the loss above the threshold by eq. (15), which "
                       "takes shedding to be instant. The load-shedding conditions and an outlet's "
                       "own flag on its estimate are not played here.",
                       wanted_mw)},
          fmt::format("After a loss of {:g} MW", study.scenario.loss_mw),
          "controls"};
}

// Over losses and something else. `figure` may have none.
template <class Figure>
record::FigureTable heat_map(const std::string& caption, const std::string& unit,
                             const std::vector<double>& losses_mw,
                             const std::vector<double>& columns, const Figure& figure) {
  record::FigureTable table = {caption, "loss", {}, {}, true, unit};
  for (const double column : columns) {
    table.columns.push_back(fmt::format("{:g}", column));
  }
  for (const double loss_mw : losses_mw) {
    record::FigureRow row = {fmt::format("{:.6g} MW", loss_mw), {}};
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
      const auto result = play(grid, fleet, options, quiet(execution));
      report_progress(execution, ++done, all);
      if (!result) {
        return kNoFigure;
      }
      beyond_mw.try_emplace({loss_mw, noise_hz}, result->shed.power_mw - result->wanted_mw);
      return result->nadir_hz;
    };
    tables.push_back(heat_map(
        fmt::format("Nadir, Hz, over noise (± or σ, Hz); every outlet {:g} s later", delay_s), "Hz",
        losses_mw, over.noises_hz, nadir_hz));
  }
  // Who sheds hardly depends on when.
  tables.push_back(heat_map("Shed beyond what is wanted, MW, over noise (± or σ, Hz)", "MW",
                            losses_mw, over.noises_hz, [&](double loss_mw, double noise_hz) {
                              const auto cell = beyond_mw.find({loss_mw, noise_hz});
                              return cell != beyond_mw.end() ? cell->second : kNoFigure;
                            }));
  ScenarioOptions central = study.scenario;
  central.control = Control::kCentral;
  tables.push_back(heat_map(fmt::format("Central control in its place, which knows the loss after "
                                        "{:g} s: nadir, Hz, over its communication delay, s",
                                        central.central_decision_s),
                            "Hz", losses_mw, over.delays_s, [&](double loss_mw, double delay_s) {
                              central.loss_mw = loss_mw;
                              central.central_delay_s = delay_s;
                              const auto result = play(grid, fleet, central, quiet(execution));
                              return result ? result->nadir_hz : kNoFigure;
                            }));
  return {tables, {}, {}, "Loss, noise and delay", "sweep"};
}

record::PageSection closed_loop(const grid::Grid& grid, const Study& study,
                                const Execution& execution) {
  // As much power as the fleet has, by a thousand outlets that take more each.
  FleetOptions few = study.fleet;
  const double outlets = static_cast<double>(few.groups) * static_cast<double>(few.per_group);
  few.groups = kClosedLoopOutlets;
  few.per_group = 1;
  few.least_w *= outlets / static_cast<double>(kClosedLoopOutlets);
  few.most_w *= outlets / static_cast<double>(kClosedLoopOutlets);
  const Fleet fleet = make_fleet(few);
  ClosedLoopOptions options;
  options.loss_mw = study.scenario.loss_mw;
  options.duration_s = study.scenario.duration_s;
  options.seed = study.fleet.seed;
  record::FigureTable table = {"1 % white noise on each outlet's voltage",
                               "",
                               {"threshold by eq. (15)", "threshold for the delay"}};
  record::CurvePlot plot = {"The frequency.", "s", "Hz"};
  for (const std::string& column : table.columns) {
    const auto result = play_closed_loop(grid, fleet, options, execution);
    if (!result) {
      break;
    }
    const ScenarioResult& scenario = result->scenario;
    const std::pair<const char*, double> figures[] = {
        {"wanted, MW", scenario.wanted_mw},
        {"shed, MW", scenario.shed.power_mw},
        {"outlets off", static_cast<double>(scenario.shed.outlets)},
        {"outlets that detected the loss", static_cast<double>(result->events)},
        {"events before the loss", static_cast<double>(result->false_events)},
        {"last event, s", result->latest_event_s},
        {"estimates, mean, MW", result->loss_mw.mean()},
        {"estimates, σ, MW", result->loss_mw.standard_deviation()},
        {"first action, s", scenario.first_action_s},
        {"last action, s", scenario.last_action_s},
        {"nadir, Hz", scenario.nadir_hz},
        {"at, s", scenario.nadir_s},
        {"end, Hz", scenario.end_hz}};
    for (std::size_t i = 0; i < std::size(figures); ++i) {
      if (table.rows.size() <= i) {
        table.rows.push_back({figures[i].first, {}});
      }
      table.rows[i].figures.push_back(figures[i].second);
    }
    plot.x = scenario.t_s;
    plot.curves.push_back({column, scenario.frequency_hz});
    options.threshold_mw =
        delay_aware_threshold_mw(grid, study.scenario, result->latest_event_s + kToDecide_s);
  }
  return {{table},
          {plot},
          {"By eq. (15) the nadir comes to lie below f_s, and with it below switching-off "
           "frequencies: outlets that had decided to stay on go off after all. A threshold that "
           "reckons with the delay spares most of them."},
          fmt::format("{} outlets with the whole firmware, from the voltage on", fleet.outlets()),
          "closed-loop"};
}

// Before anything is played: a sweep may take minutes.
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
  page.title =
      fmt::format("{} outlets of {:.1f} MW on {}", fleet.outlets(), fleet.power_mw, grid.name);
  page.subtitle = grid.title;
  page.facts = {{"loss", fmt::format("{:g} MW", study.scenario.loss_mw)},
                {"noise", fmt::format("{} {:g} Hz",
                                      study.scenario.distribution == NoiseDistribution::kGaussian
                                          ? "Gaussian, σ ="
                                          : "uniform, ±",
                                      study.scenario.noise_hz)},
                {"seed", std::to_string(study.fleet.seed)}};
  page.sections = {controls(grid, study, fleet, execution)};
  if (study.closed_loop) {
    page.sections.push_back(closed_loop(grid, study, execution));
  }
  if (study.sweep) {
    page.sections.push_back(sweep(grid, study, fleet, execution));
  }
  if (stopped(execution)) {
    page.facts.emplace_back("stopped", "what was under way is left out; the page is not whole");
  }
  return page;
}

}  // namespace gsbench::fleet
