#include "sections.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <grid/sfr_model.hpp>

namespace gsbench::profile {
namespace {

using keys::Range;
using keys::Table;

// Shorter ones lose digits in long runs (grid/sfr_model.hpp), and are steps for any outlet.
constexpr double kShortestRamp_s = 0.001;
constexpr double kLongestRamp_s = 3600.0;

grid::PowerChange read_loss(const Table& table, const grid::Grid& grid, const RunTime& run) {
  grid::PowerChange loss;
  loss.at_s = table.number("at_s", run.starts());
  loss.power_mw =
      table.number("power_mw", {-grid.load_mw, grid.load_mw, false, false, "the grid's load"});
  loss.ramp_s = table.number("ramp_s");
  if (loss.power_mw == 0.0) {
    table.refuse("power_mw",
                 "power_mw is 0; it must be above 0 (lost generation) or below 0 (shed load)");
  }
  if (loss.ramp_s > 0.0 && loss.ramp_s < kShortestRamp_s) {
    table.refuse("ramp_s", fmt::format("ramp_s is {}; it must be at least {}, or 0 for a step",
                                       loss.ramp_s, kShortestRamp_s));
  }
  return loss;
}

// A step of the balance, or of its slope.
struct Kink {
  double t_s;
  double step_mw;
  double slope_mw_per_s;
};

std::vector<Kink> kinks_of(const std::vector<grid::PowerChange>& losses) {
  std::vector<Kink> kinks;
  for (const grid::PowerChange& loss : losses) {
    if (loss.ramp_s > 0.0) {
      const double slope_mw_per_s = loss.power_mw / loss.ramp_s;
      kinks.push_back({loss.at_s, 0.0, slope_mw_per_s});
      kinks.push_back({loss.at_s + loss.ramp_s, 0.0, -slope_mw_per_s});
    } else {
      kinks.push_back({loss.at_s, loss.power_mw, 0.0});
    }
  }
  std::stable_sort(kinks.begin(), kinks.end(),
                   [](const Kink& a, const Kink& b) { return a.t_s < b.t_s; });
  return kinks;
}

// Between kinks the balance is linear, so its extremes are at them.
void check_balance(const Table& grid_section, const std::vector<grid::PowerChange>& losses,
                   double load_mw) {
  constexpr double kRounding = 1e-9;
  double balance_mw = 0.0;
  double slope_mw_per_s = 0.0;
  double last_s = 0.0;
  for (const Kink& kink : kinks_of(losses)) {
    balance_mw += slope_mw_per_s * (kink.t_s - last_s);
    last_s = kink.t_s;
    slope_mw_per_s += kink.slope_mw_per_s;
    for (const double step_mw : {0.0, kink.step_mw}) {
      balance_mw += step_mw;
      if (std::abs(balance_mw) > load_mw * (1.0 + kRounding)) {
        grid_section.refuse(
            "loss",
            fmt::format("the losses add up to {:.9g} MW at {} s; their sum must stay within "
                        "± {} MW (the grid's load)",
                        balance_mw, kink.t_s, load_mw));
      }
    }
  }
}

}  // namespace

keys::Key loss_keys() {
  return keys::tables(
      "loss",
      "Changes of the power balance, superposed (eq. 10). Without losses the frequency stays as it "
      "was before the start.",
      {time_in_run("time of the loss; of a ramp, its start. Measures count from it"),
       keys::number("power_mw", "MW", {}, "lost generation; negative: shed load, or power returned")
           .permits("-load … +load of the grid, not 0; the sum of all losses must stay in this "
                    "range at any time")
           .require(),
       keys::number("ramp_s", "s", keys::between(0.0, kLongestRamp_s),
                    "the power is lost linearly over this time; it may end after the run")
           .permits("0: at once; 0.001 … 3600")
           .by_default(0.0)});
}

keys::Key frequency_before_key() {
  return keys::number("frequency_before_hz", "Hz", keys::above(0.0),
                      "frequency before the start: the grid is in equilibrium there, as if power "
                      "had been lost or shed long before. The outlets' settings do not depend on "
                      "it. Not with `frequency` or `[signal.trace]`")
      .permits("as far from nominal as ± load moves it, at most by half")
      .or_else("nominal");
}

double read_initial_deviation_hz(const Table& grid_section, const grid::Grid& grid) {
  const double of_load_hz = grid.load_mw * grid::SfrModel(grid).gain_hz_per_mw();
  // In whole millihertz, for the message.
  const double reach_hz = std::floor(1e3 * std::min(of_load_hz, 0.5 * grid.nominal_hz)) / 1e3;
  const Range reachable = {grid.nominal_hz - reach_hz, grid.nominal_hz + reach_hz, false, false,
                           "as far as the grid's load moves it"};
  return grid_section.find_number("frequency_before_hz", reachable).value_or(grid.nominal_hz) -
         grid.nominal_hz;
}

std::vector<grid::PowerChange> read_losses(const Table& grid_section, const grid::Grid& grid,
                                           const RunTime& run) {
  std::vector<grid::PowerChange> losses;
  for (const Table& table : grid_section.tables("loss")) {
    losses.push_back(read_loss(table, grid, run));
  }
  std::stable_sort(
      losses.begin(), losses.end(),
      [](const grid::PowerChange& a, const grid::PowerChange& b) { return a.at_s < b.at_s; });
  check_balance(grid_section, losses, grid.load_mw);
  return losses;
}

}  // namespace gsbench::profile
