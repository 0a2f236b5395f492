// The page of `gsbench fleet --profile --closed-loop`.
#include "closed_loop_page.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace gsbench::fleet {
namespace {

using campaign::Execution;
using record::kNoFigure;

// A strategy without outlets takes so long, compared with one that has them.
constexpr double kWithoutOutlets = 0.02;

double effort(Strategy strategy) {
  return has_outlets(strategy) ? 1.0 : kWithoutOutlets;
}

record::FigureRow row_of_result(Strategy strategy, const std::optional<ClosedLoopResult>& result) {
  record::FigureRow row = {to_string(strategy), std::vector<double>(7, kNoFigure)};
  if (result) {
    row.figures = {result->shed_mw,
                   result->nadir_hz,
                   result->end_hz,
                   kNoFigure,
                   result->first_action_s.value_or(kNoFigure),
                   result->last_action_s.value_or(kNoFigure),
                   kNoFigure};
    if (result->outlets) {
      row.figures[3] = static_cast<double>(result->outlets->off);
      if (result->outlets->false_events) {
        row.figures[6] = static_cast<double>(*result->outlets->false_events);
      }
    }
  }
  return row;
}

}  // namespace

campaign::Execution part_of(const Execution& execution, double done, double own, double all) {
  Execution part = execution;
  part.progress = [&execution, done, own, all](double of_own) {
    report_progress(execution, done + own * of_own, all);
  };
  return part;
}

std::vector<StrategyResult> simulate_strategies(const profile::Plan& plan, const Fleet& fleet,
                                                const ClosedLoopOptions& options,
                                                const Execution& execution) {
  double all = 0.0;
  for (const Strategy strategy : all_strategies()) {
    all += effort(strategy);
  }
  std::vector<StrategyResult> results;
  double done = 0.0;
  for (const Strategy strategy : all_strategies()) {
    std::optional<ClosedLoopResult> result;
    if (is_possible(plan, strategy)) {
      result = simulate_closed_loop(plan, fleet, strategy, options,
                                    part_of(execution, done, effort(strategy), all));
    }
    if (stopped(execution)) {
      break;
    }
    results.push_back({strategy, std::move(result)});
    done += effort(strategy);
    report_progress(execution, done, all);
  }
  return results;
}

const std::optional<ClosedLoopResult>& result_of(const std::vector<StrategyResult>& results,
                                                 Strategy strategy) {
  return std::find_if(results.begin(), results.end(),
                      [&](const StrategyResult& each) { return each.strategy == strategy; })
      ->result;
}

record::FigureTable strategies_table(const profile::Plan& plan, const Fleet& fleet,
                                     const std::vector<StrategyResult>& results) {
  record::FigureTable table = {
      fmt::format("{} outlets with {:.1f} MW; {:g} % white noise on each outlet's voltage",
                  fleet.outlets(), fleet.power_mw, plan.stimulus.noise_pct),
      "strategy",
      {{"shed, MW", 2},
       {"nadir, Hz", 3},
       {"end, Hz", 3},
       {"outlets off"},
       {"first action, s", 3},
       {"last action, s", 3},
       {"false events"}}};
  const char* const keys[] = {"shed_mw",        "nadir_hz",      "end_hz",      "outlets_off",
                              "first_action_s", "last_action_s", "false_events"};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    table.columns[i].key = keys[i];
  }
  table.list = "closed_loop";
  table.row_key = "strategy";
  for (const auto& [strategy, result] : results) {
    table.rows.push_back(row_of_result(strategy, result));
  }
  return table;
}

record::PageSection strategies_section(const profile::Plan& plan, const Fleet& fleet,
                                       const ClosedLoopOptions& options,
                                       const std::vector<StrategyResult>& results) {
  record::CurvePlot plot = {"The frequency of the grid.", "s", "Hz"};
  for (const auto& [strategy, result] : results) {
    if (result) {
      plot.x = result->t_s;
      plot.curves.push_back({to_string(strategy), result->frequency_hz});
    }
  }
  std::vector<std::string> notes = {
      fmt::format("shed: the most that is off at any time. nadir, end: frequency of the grid model "
                  "with all load that is off. f_s is {:g} Hz. Times count from the start of the "
                  "signal. false events: outlets that claimed an event while nothing was lost.",
                  plan.grid.threshold_hz),
      fmt::format(
          "none: no control. paper, gsbench: outlets with the whole firmware, which decide as in "
          "the "
          "paper (method = 0) or by the grid's state (method = 1). central: a controller that "
          "knows "
          "a loss after {:g} s and whose commands take {:g} s. ufls: under-frequency relays, {} "
          "stages of {:g} % of the load.",
          options.central_decision_s, options.central_delay_s, kUflsStages,
          100.0 * options.ufls_part),
      "clairvoyant-T: knows the state of the grid at once, a loss T seconds after it happens and a "
      "return at once. Every 16 ms it sheds the least power that keeps the predicted nadir at f_s "
      "or, where that cannot be reached, within 10 mHz of the best that can."};
  if (plays_recorded_frequency(plan)) {
    notes.emplace_back(
        "The profile plays a recorded frequency, so that the lost power and false events are not "
        "known.");
  }
  return {{strategies_table(plan, fleet, results)},
          {plot},
          notes,
          "Controls of the same load in a closed loop",
          "strategies"};
}

Fleet fleet_of(const profile::Plan& plan, const Study& study) {
  FleetOptions options = study.fleet;
  options.seed = plan.seed;
  return make_fleet(in_fewer_outlets(options, kClosedLoopOutlets));
}

ClosedLoopOptions options_of(const Study& study) {
  ClosedLoopOptions options;
  options.central_delay_s = study.scenario.central_delay_s;
  options.after_loss_s = study.scenario.duration_s;
  return options;
}

record::Judgement judgement_of(const profile::Plan& plan,
                               const std::vector<StrategyResult>& results, Strategy strategy) {
  if (results.size() < all_strategies().size()) {
    return {std::nullopt, {"stopped"}};
  }
  const std::optional<Clairvoyants> clairvoyants = clairvoyants_of(results);
  if (!clairvoyants) {
    return {std::nullopt,
            {"the profile plays a recorded frequency, whose lost power clairvoyants do not know"}};
  }
  const std::vector<std::string> missed =
      missed_limits(result_of(results, strategy).value(), limits_of(plan, *clairvoyants));
  return {missed.empty(), missed};
}

std::string limits_note() {
  return fmt::format(
      "Limits of gsbench: the nadir is at least the lowest of the four clairvoyants less {:g} "
      "mHz; at most {:g} times the most that one of them sheds, and {:g} MW, is shed, and nothing "
      "if none of them sheds; no outlet claims a false event. With an oscillation, claims before "
      "the loss are not judged.",
      1000.0 * kNadirMargin_hz, kShedFactor, kShedMargin_mw);
}

record::Page make_closed_loop_page(const profile::Plan& plan, const Study& study,
                                   const Execution& execution) {
  const Fleet fleet = fleet_of(plan, study);
  const ClosedLoopOptions options = options_of(study);
  const std::vector<StrategyResult> results = simulate_strategies(plan, fleet, options, execution);
  record::Page page;
  page.title = plan.title;
  page.subtitle = fmt::format("profile {} on grid {}", plan.name, plan.grid.name);
  page.judgement = judgement_of(plan, results, Strategy::kGsbench);
  page.facts = {{"seed", std::to_string(plan.seed)}, {"verdict", to_string(*page.judgement)}};
  page.sections = {strategies_section(plan, fleet, options, results)};
  page.sections[0].paragraphs.push_back(limits_note());
  if (stopped(execution)) {
    page.facts.emplace_back("stopped",
                            "unfinished simulations are left out; the page is incomplete");
  }
  return page;
}

}  // namespace gsbench::fleet
