#include "sections.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace gsbench::paper {
namespace {

struct Section {
  const char* id;
  const char* title;
  PageSection (*make)(Study&, const Execution&);
};

constexpr Section kSections[] = {
    {"fig13", "Figs. 8 and 13: frequency after a loss (§4.2, §6.1)", fig8_and_13},
    {"table1", "Fig. 9 and Table 1: load-shedding conditions (§4.3, §6.2)", fig9_and_table1},
    {"fig14", "Fig. 14: ROCOF and frequency for several losses (§6.2)", fig14},
    {"table2", "Table 2: decisions whether load shedding is needed (§6.2)", table2},
    {"table3", "Fig. 15 and Table 3: estimates by LSE (§6.3.1)", table3},
    {"fig16", "Fig. 16: estimates after each measurement (§6.3.2)", fig16},
    {"table4", "Fig. 17 and Table 4: estimates by EKF (§6.3.2)", table4},
    {"table5", "Table 5: estimates by EKF with wrong parameters (§6.3.3)", table5},
    {"fig19", "Fig. 19: the 500 MW experiment, starting from the sampled voltage (§6.4)", fig19},
    {"fig21", "Figs. 20 and 21: a million outlets (§6.5.1, §6.5.2)", fig20_and_21},
    {"fig22", "Fig. 22: frequency with and without Grid Sense (§6.5.1)", fig22},
};

bool is_chosen(const Options& options, const std::string& id) {
  return options.only.empty() ||
         std::find(options.only.begin(), options.only.end(), id) != options.only.end();
}

void check(const Options& options) {
  std::vector<std::string> ids;
  for (const Section& section : kSections) {
    ids.emplace_back(section.id);
  }
  for (const std::string& id : options.only) {
    campaign::demand(
        std::find(ids.begin(), ids.end(), id) != ids.end(),
        fmt::format("unknown section \"{}\"; the sections are {}", id, fmt::join(ids, ", ")));
  }
}

std::vector<std::pair<std::string, std::string>> facts(const grid::Grid& grid,
                                                       const Options& options) {
  const Choices& choices = options.choices;
  return {{"grid", grid.name + ": " + grid.title},
          {"trajectories", std::to_string(options.trajectories)},
          {"seed", std::to_string(options.seed)},
          {"noise of the measured frequency", text_of(choices.noise_distribution)},
          {"instant of the loss", text_of(choices.loss_instant)},
          {"load-shedding conditions, paper's method", text_of(choices.counting)},
          {"EKF start, paper's method",
           fmt::format("σ of ΔP {:g} MW, σ of the instant {:g} ms", choices.ekf_loss_sigma_mw,
                       1000.0 * choices.ekf_t_x_sigma_s)}};
}

}  // namespace

std::vector<Item> items() {
  std::vector<Item> items;
  for (const Section& section : kSections) {
    items.push_back({section.id, section.title});
  }
  return items;
}

record::Page reproduce(const grid::Grid& grid, const Options& options, const Execution& execution) {
  check(options);
  record::Page page;
  page.title = "The paper's tables and figures, computed again";
  page.subtitle =
      "Xiang et al., Distributed Frequency Emergency Control with Coordinated Edge Intelligence. "
      "\"Paper\": the printed figure. \"Paper's method\": its equations and procedure. \"Firmware, "
      "known event\": the firmware's estimators. The event is given: it is the first report after "
      "the loss, and the frequency before the loss is exact (settings event_drops = 1, "
      "event_lag_s = 0; shipped: 5 and 0.008 s). A shipped outlet detects the event and measures "
      "that frequency itself. "
      "\"Experiment\": not part of any product.";
  page.facts = facts(grid, options);
  Study study{grid, options};
  std::vector<Section> chosen;
  std::copy_if(std::begin(kSections), std::end(kSections), std::back_inserter(chosen),
               [&](const Section& section) { return is_chosen(options, section.id); });
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    PageSection section = chosen[i].make(
        study, nth_of(execution, static_cast<int>(i), static_cast<int>(chosen.size())));
    section.id = chosen[i].id;
    section.title = chosen[i].title;
    page.sections.push_back(section);
    if (stopped(execution)) {
      page.facts.emplace_back("stopped", "in " + section.id + ", which is incomplete");
      break;
    }
  }
  return page;
}

}  // namespace gsbench::paper
