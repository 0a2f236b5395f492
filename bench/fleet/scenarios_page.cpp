// The page of `gsbench fleet --closed-loop` with several profiles.
#include "closed_loop_page.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace gsbench::fleet {
namespace {

// The folder of all profiles, with its slash; empty if they are in several.
std::string common_folder(const std::vector<profile::Plan>& plans) {
  const std::string& first = plans.front().name;
  const std::string folder = first.substr(0, first.rfind('/') + 1);  // npos + 1 is 0
  const bool common = std::all_of(plans.begin(), plans.end(), [&](const profile::Plan& plan) {
    return plan.name.rfind(folder, 0) == 0;
  });
  return common ? folder : "";
}

// Narrow columns, so that the table fits in the lines of a terminal.
record::FigureTable table_of(const std::vector<profile::Plan>& plans) {
  record::FigureTable table = {
      "Nadir and the most power shed at any time. none: without control. best: clairvoyants, the "
      "lowest nadir of the four and the most that one of them sheds. min, max: limits of gsbench. "
      "Without these words: gsbench",
      "profile",
      {{"nadir, none, Hz", 3},
       {"nadir, best, Hz", 3},
       {"nadir, min, Hz", 3},
       {"nadir, Hz", 3},
       {"shed, best, MW", 1},
       {"shed, max, MW", 1},
       {"shed, MW", 1},
       {"false events"}}};
  table.list = "scenarios";
  table.row_key = "profile";
  table.row_prefix = common_folder(plans);
  if (!table.row_prefix.empty()) {
    table.first_column = table.row_prefix;
  }
  return table;
}

// `results`: of all strategies.
record::FigureRow row_of(const profile::Plan& plan, const std::vector<StrategyResult>& results) {
  constexpr double kNone = record::kNoFigure;
  const ClosedLoopResult& none = result_of(results, Strategy::kNone).value();
  const ClosedLoopResult& outlets = result_of(results, Strategy::kGsbench).value();
  const std::optional<Clairvoyants> best = clairvoyants_of(results);
  const ClosedLoopLimits limits =
      best ? limits_of(plan, *best) : ClosedLoopLimits{kNone, kNone, false};
  const std::optional<std::size_t> false_events = outlets.outlets.value().false_events;
  return {plan.name,
          {none.nadir_hz, best ? best->lowest_nadir_hz : kNone, limits.least_nadir_hz,
           outlets.nadir_hz, best ? best->most_shed_mw : kNone, limits.most_shed_mw,
           outlets.shed_mw, false_events ? static_cast<double>(*false_events) : kNone},
          {},
          judgement_of(plan, results, Strategy::kGsbench)};
}

struct Counts {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t not_judged = 0;

  void add(const record::Judgement& judgement) {
    ++(!judgement.passed ? not_judged : *judgement.passed ? passed : failed);
  }
  std::string text() const {
    if (passed + failed == 0) {
      return "no profile is judged";
    }
    const std::string judged = fmt::format("{} of {} profiles pass", passed, passed + failed);
    return not_judged == 0 ? judged : fmt::format("{}; not judged: {}", judged, not_judged);
  }
};

// `stopped`: after how many of how many; empty if all are done.
record::Judgement judgement_of_all(const Counts& counts, const std::string& stopped) {
  if (counts.failed > 0) {
    return {false, {counts.text()}};
  }
  if (!stopped.empty()) {
    return {std::nullopt, {"stopped " + stopped}};
  }
  if (counts.passed == 0) {
    return {std::nullopt, {counts.text()}};
  }
  return {true, {}};
}

}  // namespace

record::Page make_scenarios_page(const std::vector<profile::Plan>& plans, const Study& study,
                                 const campaign::Execution& execution) {
  campaign::demand(!plans.empty(), "no profiles are given");
  record::FigureTable table = table_of(plans);
  std::vector<std::string> notes;
  Counts counts;
  Counts of_paper;
  for (const profile::Plan& plan : plans) {
    const Fleet fleet = fleet_of(plan, study);
    const std::vector<StrategyResult> results =
        simulate_strategies(plan, fleet, options_of(study),
                            part_of(execution, static_cast<double>(table.rows.size()), 1.0,
                                    static_cast<double>(plans.size())));
    if (results.size() < all_strategies().size()) {
      break;
    }
    table.rows.push_back(row_of(plan, results));
    record::FigureRow& row = table.rows.back();
    row.name.erase(0, table.row_prefix.size());
    row.lists = {strategies_table(plan, fleet, results)};
    counts.add(*row.judgement);
    of_paper.add(judgement_of(plan, results, Strategy::kPaper));
    if (row.judgement->passed != true) {
      notes.push_back(fmt::format("{}: {}", plan.name, to_string(*row.judgement)));
    }
  }
  const std::string stopped =
      table.rows.size() == plans.size()
          ? ""
          : fmt::format("after {} of {} profiles", table.rows.size(), plans.size());
  notes.push_back(limits_note());
  notes.push_back(fmt::format("By the paper's way (method = 0), {}.", of_paper.text()));
  notes.push_back(fmt::format("By gsbench, {}.", counts.text()));

  record::Page page;
  page.title = fmt::format("Profiles in a closed loop: {}", plans.size());
  page.subtitle = fmt::format("{} outlets with the whole firmware, beside clairvoyants",
                              fleet_of(plans.front(), study).outlets());
  page.judgement = judgement_of_all(counts, stopped);
  page.facts = {{"verdict", to_string(*page.judgement)}};
  page.sections = {{{table}, {}, notes, "Nadir and power shed by profile", "scenarios"}};
  if (!stopped.empty()) {
    page.facts.emplace_back("stopped",
                            stopped + "; the others are left out, the page is incomplete");
  }
  return page;
}

}  // namespace gsbench::fleet
