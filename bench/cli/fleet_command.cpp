#include "commands.hpp"
#include "page_output.hpp"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <campaign/closed_loop.hpp>
#include <campaign/fleet.hpp>
#include <campaign/scenario.hpp>
#include <grid/control_centre.hpp>
#include <grid/sfr_model.hpp>
#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

using campaign::Control;
using campaign::NoiseLaw;
using campaign::ScenarioOptions;
using campaign::ScenarioResult;
using record::kNoFigure;

constexpr std::size_t kClosedLoopOutlets = 1000;
constexpr double kToDecideS = 0.8;  // from an event to an open relay

struct FleetArguments {
  std::string grid = "ieee24";
  campaign::FleetOptions fleet;
  ScenarioOptions scenario;
  bool gaussian = false;
  bool whole_group = false;
  bool delay_aware = false;
  bool sweep = false;
  bool closed_loop = false;
  PageOutput output;
};

const char* title_of(Control control) {
  switch (control) {
    case Control::kNone:
      return "no control";
    case Control::kGridSense:
      return "Grid Sense, by each outlet's estimate";
    case Control::kSwitchOff:
      return "switching-off frequencies alone";
    case Control::kCentral:
      return "central control";
    case Control::kUfls:
      return "under-frequency load shedding";
  }
  return "";
}

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

// The outlets' last action where nothing else is known: what the threshold must reckon with.
double delay_aware_threshold_mw(const grid::Grid& grid, const ScenarioOptions& options,
                                double last_action_s) {
  return grid::threshold_for_delay_mw(grid::SfrModel(grid), grid.threshold_hz, options.loss_mw,
                                      last_action_s);
}

record::PageSection controls(const grid::Grid& grid, const FleetArguments& arguments,
                             const campaign::Fleet& fleet, const campaign::Execution& execution) {
  record::PageSection section;
  section.id = "controls";
  section.title = fmt::format("After a loss of {:g} MW", arguments.scenario.loss_mw);
  record::FigureTable table = {
      "The shed load fed back into the grid, each outlet at its own instant",
      "",
      {"shed, MW", "outlets off", "wholly off up to", "wholly on from", "first action, s",
       "last action, s", "nadir, Hz", "at, s", "end, Hz"}};
  record::CurvePlot plot = {"The frequency.", "s", "Hz"};
  record::CurvePlot groups = {"Outlets off in each group.", "group", "outlets"};
  groups.steps = true;
  ScenarioOptions options = arguments.scenario;
  double last_action_s = kNoFigure;
  double wanted_mw = 0.0;
  const auto add = [&](const std::string& name) {
    ScenarioResult result = play(grid, fleet, options, execution);
    table.rows.push_back(row_of(name, result));
    plot.x = result.t_s;
    plot.curves.push_back({name, result.frequency_hz});
    wanted_mw = result.wanted_mw;
    return result;
  };
  for (const Control control : campaign::all_controls()) {
    options.control = control;
    const ScenarioResult result = add(title_of(control));
    if (control == Control::kGridSense) {
      last_action_s = result.last_action_s;
      record::Curve curve{"off", {}};
      for (std::size_t group = 0; group < result.shed.off_in_group.size(); ++group) {
        groups.x.push_back(static_cast<double>(group + 1));
        curve.y.push_back(static_cast<double>(result.shed.off_in_group[group]));
      }
      groups.curves = {curve};
    }
  }
  if (arguments.delay_aware && std::isfinite(last_action_s)) {
    options.control = Control::kGridSense;
    options.threshold_mw = delay_aware_threshold_mw(grid, options, last_action_s);
    add(fmt::format("Grid Sense, threshold {:.2f} MW for the delay", options.threshold_mw));
  }
  section.tables = {table};
  section.plots = {plot, groups};
  section.paragraphs = {fmt::format(
      "Wanted are {:.2f} MW, the loss above the threshold by eq. (15), which takes shedding to be "
      "instant. The load-shedding conditions and an outlet's doubts are not played here.",
      wanted_mw)};
  return section;
}

record::PageSection sweep(const grid::Grid& grid, const FleetArguments& arguments,
                          const campaign::Fleet& fleet, const campaign::Execution& execution) {
  constexpr double kDelaysS[] = {0.0, 0.1, 0.2, 0.5, 1.0};
  constexpr double kNoisesHz[] = {0.0, 0.005, 0.01, 0.02, 0.05};
  constexpr double kLossParts[] = {0.9, 1.0, 1.1, 1.2, 1.42, 1.7, 2.0};  // of the threshold
  const double threshold_mw = grid::threshold_mw(grid::SfrModel(grid), grid.threshold_hz);
  record::PageSection section;
  section.id = "sweep";
  section.title = "Loss, noise and delay";
  double done = 0.0;
  constexpr double kAll = static_cast<double>(std::size(kLossParts)) *
                          static_cast<double>(std::size(kNoisesHz) + std::size(kDelaysS));
  const auto fill = [&](record::FigureTable& nadirs, record::FigureTable* sheds, const auto& values,
                        const auto& apply) {
    for (const double part : kLossParts) {
      ScenarioOptions options = arguments.scenario;
      options.control = Control::kGridSense;
      options.loss_mw = part * threshold_mw;
      if (options.loss_mw > grid.base_mw) {
        continue;
      }
      const std::string name = fmt::format("{:.1f} MW", options.loss_mw);
      record::FigureRow nadir = {name, {}};
      record::FigureRow shed = {name, {}};
      for (const double value : values) {
        apply(options, value);
        campaign::Execution quiet = execution;
        quiet.progress = nullptr;
        const ScenarioResult result = play(grid, fleet, options, quiet);
        nadir.figures.push_back(result.nadir_hz);
        shed.figures.push_back(result.shed.power_mw - result.wanted_mw);
        if (execution.progress) {
          execution.progress(++done / kAll);
        }
      }
      nadirs.rows.push_back(nadir);
      if (sheds != nullptr) {
        sheds->rows.push_back(shed);
      }
    }
  };
  record::FigureTable by_noise = {"Nadir, Hz, over noise (± or σ, Hz)", "loss", {}, {}, true};
  record::FigureTable shed_by_noise = {"Shed beyond what is wanted, MW", "loss", {}, {}, true};
  for (const double noise_hz : kNoisesHz) {
    by_noise.columns.push_back(fmt::format("{:g}", noise_hz));
  }
  shed_by_noise.columns = by_noise.columns;
  fill(by_noise, &shed_by_noise, kNoisesHz,
       [](ScenarioOptions& options, double value) { options.noise_hz = value; });
  record::FigureTable by_delay = {
      "Nadir, Hz, over a further delay of every outlet, s", "loss", {}, {}, true};
  for (const double delay_s : kDelaysS) {
    by_delay.columns.push_back(fmt::format("{:g}", delay_s));
  }
  fill(by_delay, nullptr, kDelaysS,
       [](ScenarioOptions& options, double value) { options.further_delay_s = value; });
  section.tables = {by_noise, shed_by_noise, by_delay};
  return section;
}

record::PageSection closed_loop(const grid::Grid& grid, const FleetArguments& arguments,
                                const campaign::Execution& execution) {
  // As much power as the fleet has, by a thousand outlets that take more each.
  campaign::FleetOptions few = arguments.fleet;
  const double outlets = static_cast<double>(few.groups) * static_cast<double>(few.per_group);
  few.groups = kClosedLoopOutlets;
  few.per_group = 1;
  few.least_w *= outlets / static_cast<double>(kClosedLoopOutlets);
  few.most_w *= outlets / static_cast<double>(kClosedLoopOutlets);
  const campaign::Fleet fleet = make_fleet(few);
  campaign::ClosedLoopOptions options;
  options.loss_mw = arguments.scenario.loss_mw;
  options.duration_s = arguments.scenario.duration_s;
  options.seed = arguments.fleet.seed;
  record::PageSection section;
  section.id = "closed-loop";
  section.title =
      fmt::format("{} outlets with the whole firmware, from the voltage on", fleet.outlets());
  record::FigureTable table = {"1 % white noise on each outlet's voltage",
                               "",
                               {"threshold by eq. (15)", "threshold for the delay"}};
  record::CurvePlot plot = {"The frequency.", "s", "Hz"};
  for (const std::string& column : table.columns) {
    const campaign::ClosedLoopResult result = play_closed_loop(grid, fleet, options, execution);
    const ScenarioResult& scenario = result.scenario;
    const std::pair<const char*, double> figures[] = {
        {"wanted, MW", scenario.wanted_mw},
        {"shed, MW", scenario.shed.power_mw},
        {"outlets off", static_cast<double>(scenario.shed.outlets)},
        {"outlets that detected the loss", static_cast<double>(result.events)},
        {"events before the loss", static_cast<double>(result.false_events)},
        {"last event, s", result.latest_event_s},
        {"estimates, mean, MW", result.loss_mw.mean()},
        {"estimates, σ, MW", result.loss_mw.standard_deviation()},
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
        delay_aware_threshold_mw(grid, arguments.scenario, result.latest_event_s + kToDecideS);
  }
  section.tables = {table};
  section.plots = {plot};
  section.paragraphs = {
      "By eq. (15) the nadir comes to lie below f_s, and with it below switching-off frequencies: "
      "outlets that had decided to stay on go off after all. A threshold that reckons with the "
      "delay "
      "spares most of them."};
  return section;
}

record::Page fleet_page(const grid::Grid& grid, const FleetArguments& arguments,
                        const campaign::Execution& execution) {
  const campaign::Fleet fleet = make_fleet(arguments.fleet);
  record::Page page;
  page.title =
      fmt::format("{} outlets of {:.1f} MW on {}", fleet.outlets(), fleet.power_mw, grid.name);
  page.subtitle = grid.title;
  page.facts = {
      {"loss", fmt::format("{:g} MW", arguments.scenario.loss_mw)},
      {"noise", fmt::format("{} {:g} Hz", arguments.gaussian ? "Gaussian, σ =" : "uniform, ±",
                            arguments.scenario.noise_hz)},
      {"seed", std::to_string(arguments.fleet.seed)}};
  page.sections = {controls(grid, arguments, fleet, execution)};
  if (arguments.closed_loop) {
    page.sections.push_back(closed_loop(grid, arguments, execution));
  }
  if (arguments.sweep) {
    page.sections.push_back(sweep(grid, arguments, fleet, execution));
  }
  if (execution.stop->load()) {
    page.facts.emplace_back("stopped", "what was under way is not whole");
  }
  return page;
}

int run_fleet(FleetArguments arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  arguments.scenario.law = arguments.gaussian ? NoiseLaw::kGaussian : NoiseLaw::kUniform;
  arguments.scenario.seed = arguments.fleet.seed;
  arguments.fleet.accumulation = arguments.whole_group ? campaign::Accumulation::kWholeGroup
                                                       : campaign::Accumulation::kHalfGroup;
  return print_page("fleet", arguments.output, [&](const campaign::Execution& execution) {
    return fleet_page(grid, arguments, execution);
  });
}

}  // namespace

void add_fleet(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<FleetArguments>();
  CLI::App* command = app.add_subcommand(
      "fleet", "Very many outlets after a loss: who sheds, how much, when, how the frequency goes");
  ScenarioOptions& scenario = arguments->scenario;
  command->add_option("grid", arguments->grid, "A shipped grid, or a .toml file")
      ->capture_default_str();
  command->add_option("--loss", scenario.loss_mw, "Power lost, MW")->capture_default_str();
  command->add_option("--noise", scenario.noise_hz, "Of measured frequencies, Hz")
      ->capture_default_str();
  command->add_flag("--gaussian", arguments->gaussian,
                    "The noise is Gaussian of that σ; without, uniform within ± that");
  command->add_option("--groups", arguments->fleet.groups, "Of outlets, in order of importance")
      ->capture_default_str();
  command->add_option("--per-group", arguments->fleet.per_group, "Outlets in each")
      ->capture_default_str();
  command->add_option("--least", arguments->fleet.least_w, "An appliance's least power, W")
      ->capture_default_str();
  command->add_option("--most", arguments->fleet.most_w, "And its most")->capture_default_str();
  command->add_flag("--whole-group", arguments->whole_group,
                    "Outlets compare with the power up to and with their group, eq. (11); without, "
                    "with half of their own");
  command
      ->add_option("--delay", scenario.further_delay_s,
                   "Of every outlet's action beyond its own, s")
      ->capture_default_str();
  command
      ->add_option("--central-delay", scenario.central_delay_s,
                   "Of a central controller's commands, s")
      ->capture_default_str();
  command->add_flag("--delay-aware", arguments->delay_aware,
                    "Also with a threshold that reckons with the outlets' delay");
  command->add_flag("--sweep", arguments->sweep,
                    "Also over losses, noises and delays, as heat maps");
  command->add_flag("--closed-loop", arguments->closed_loop,
                    "Also a thousand outlets with the whole firmware, from the voltage on");
  command->add_option("--duration", scenario.duration_s, "s")->capture_default_str();
  command->add_option("--seed", arguments->fleet.seed, "Of all random numbers")
      ->check(kSeedRange)
      ->capture_default_str();
  add_page_options(*command, arguments->output);
  command->footer(
      "Examples:\n"
      "  gsbench fleet                                  a million outlets after 500 MW\n"
      "  gsbench fleet --loss 600 --delay-aware -o fleet.html\n"
      "  gsbench fleet island-60hz --loss 12 --groups 100 --per-group 50 --most 3000\n"
      "  gsbench fleet --per-group 20 --least 500 --most 90000 --sweep -o sweep.html");
  command->callback([arguments, &exit_code] { exit_code = run_fleet(*arguments); });
}

}  // namespace gsbench::cli
