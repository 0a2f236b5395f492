#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <immunity/page.hpp>
#include <immunity/profile_text.hpp>

namespace gsbench::immunity {
namespace {

using record::kNoFigure;

constexpr double kMostTrips = 0.0;

record::Judgement judgement_of(std::vector<std::string> reasons) {
  return {reasons.empty(), std::move(reasons)};
}

std::vector<std::string> too_many_trips(const Count& count) {
  return count.passes_trips() ? std::vector<std::string>{}
                              : std::vector<std::string>{fmt::format("{} trips", count.trips)};
}

std::vector<std::string> too_much_of_dips(const Count& dips) {
  std::vector<std::string> reasons = too_many_trips(dips);
  if (!dips.passes_events()) {
    reasons.push_back(
        fmt::format("{} events in {} dips and interruptions", dips.events, dips.cases));
  }
  return reasons;
}

std::vector<std::string> too_much_of_all(const Result& result) {
  std::vector<std::string> reasons = too_much_of_dips(result.dips());
  if (!result.all().passes_trips()) {
    reasons.push_back(fmt::format("{} trips in all", result.all().trips));
  }
  return reasons;
}

// `events_max`: of 1000 cases. A row without cases is not judged.
record::FigureRow row_of(const char* name, const Count& count, double events_max,
                         const std::vector<std::string>& reasons) {
  const double cases = count.cases;
  const double per_1000 = count.cases > 0 ? 1e3 * count.events / cases : kNoFigure;
  return {name,
          {cases, static_cast<double>(count.events), per_1000, events_max,
           static_cast<double>(count.trips), kMostTrips},
          {},
          count.cases > 0 ? judgement_of(reasons)
                          : record::Judgement{std::nullopt, {"no case was played"}}};
}

record::FigureColumn column(const char* name, const char* key, int decimals = 0) {
  record::FigureColumn column = {name, decimals};
  column.key = key;
  return column;
}

record::FigureTable table_of(const Result& result) {
  record::FigureTable table = {
      "cases with an event, and with an open relay",
      "disturbance",
      {column("cases", "cases"), column("events", "events"),
       column("per 1000", "events_per_1000", 2), column("limit", "events_per_1000_max"),
       column("trips", "trips"), column("limit", "trips_max")}};
  table.list = "kinds";
  table.row_key = "kind";
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const Count& kind = result.kinds[i];
    table.rows.push_back(row_of(kKinds[i].name, kind, kNoFigure, too_many_trips(kind)));
  }
  const Count dips = result.dips();
  table.rows.push_back(
      row_of("all dips and interruptions", dips, 1e3 * kMostEventsOfDips, too_much_of_dips(dips)));
  const Count all = result.all();
  table.rows.push_back(row_of("all", all, kNoFigure, too_many_trips(all)));
  return table;
}

// A case, its times, and its keys, a paragraph a line.
record::PageSection section_of(const SettledOutlets& outlets, std::uint32_t number) {
  const Options& options = outlets.options();
  const Disturbance disturbance = draw(outlets.grid().nominal_hz, options.seed, number);
  const Outcome outcome = outlets.play(disturbance, number);
  record::PageSection section;
  section.title =
      fmt::format("Case {}: {}", number, kKinds[static_cast<std::size_t>(disturbance.kind)].name);
  section.id = fmt::format("case-{}", number);
  record::FigureTable times = {"times from the start of the signal, s", "", {{"s", 4}}};
  times.list = section.id;
  times.row_key = "what";
  times.columns[0].key = "t_s";
  times.rows = {{"disturbance begins", {disturbance.begin_s}},
                {"disturbance ends", {disturbance.end_s}},
                {"event", {outcome.event_s.value_or(kNoFigure)}},
                {"relay opens", {outcome.trip_s.value_or(kNoFigure)}}};
  section.tables = {times};
  section.paragraphs.emplace_back("[signal]");
  std::istringstream keys(signal_keys(disturbance, options.noise_pct));
  for (std::string line; std::getline(keys, line);) {
    section.paragraphs.push_back(line);
  }
  return section;
}

record::Page page_of(const grid::Grid& grid, const Options& options,
                     const record::Judgement& judgement) {
  record::Page page;
  page.judgement = judgement;
  page.title = "Immunity to disturbances without a loss of power";
  page.subtitle = fmt::format(
      "grid {}; outlets with the whole firmware and P^A = {:g} MW; {:g} % white noise on the "
      "voltage; each case is played until {:g} s after the disturbance",
      grid.name, options.accumulated_mw, options.noise_pct, kAfter_s);
  page.facts = {{"verdict", to_string(judgement)}, {"seed", std::to_string(options.seed)}};
  return page;
}

}  // namespace

record::Page make_page(const grid::Grid& grid, const Options& options,
                       const campaign::Execution& execution) {
  const SettledOutlets outlets(grid, options, execution);
  const auto cases = [&](std::uint32_t number) {
    return draw(grid.nominal_hz, options.seed, number);
  };
  const Result result = play_all(outlets, cases, execution);
  record::Judgement judgement = judgement_of(too_much_of_all(result));
  if (result.all().passes_trips() && stopped(execution)) {
    judgement = {std::nullopt,
                 {fmt::format("{} of {} cases were played", result.all().cases, options.cases)}};
  }
  record::Page page = page_of(grid, options, judgement);
  const auto without_case = std::count_if(result.kinds.begin(), result.kinds.end(),
                                          [](const Count& kind) { return kind.cases == 0; });
  if (without_case > 0) {
    page.facts.emplace_back("kinds without a case", std::to_string(without_case));
  }
  record::PageSection section;
  section.title = "Events and trips";
  section.id = "immunity";
  section.tables = {table_of(result)};
  section.paragraphs = {
      "A trip is an open relay. No case may have one. Events are limited for dips and "
      "interruptions together: phase steps and oscillations look like a change of the frequency "
      "at first. Below, the first case of each kind with a trip, or else with an event of a dip."};
  page.sections.push_back(section);
  for (const Count& kind : result.kinds) {
    if (kind.first_failing) {
      page.sections.push_back(section_of(outlets, *kind.first_failing));
    }
  }
  return page;
}

record::Page make_page_of_case(const grid::Grid& grid, const Options& options, std::uint32_t number,
                               const campaign::Execution& execution) {
  const SettledOutlets outlets(grid, options, execution);
  const Disturbance disturbance = draw(grid.nominal_hz, options.seed, number);
  const Outcome outcome = outlets.play(disturbance, number);
  const bool is_dip = kKinds[static_cast<std::size_t>(disturbance.kind)].is_dip;
  std::vector<std::string> reasons;
  if (outcome.trip_s) {
    reasons.emplace_back("a trip");
  }
  if (is_dip && outcome.event_s) {
    reasons.emplace_back("an event of a dip");
  }
  record::Page page = page_of(grid, options, judgement_of(std::move(reasons)));
  page.sections.push_back(section_of(outlets, number));
  return page;
}

}  // namespace gsbench::immunity
