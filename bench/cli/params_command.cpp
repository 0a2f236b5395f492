#include "commands.hpp"
#include <control_centre/blocks.hpp>
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include <grid/falling_limb.hpp>
#include <profile/load.hpp>
#include <render/figures.hpp>
#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

using control_centre::Accumulation;
using control_centre::Rules;
using nlohmann::ordered_json;

ordered_json as_json(const grid::Grid& grid, double row_hz, Accumulation accumulation,
                     Rules rules) {
  const grid::SfrModel model(grid);
  const double threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
  ordered_json out;
  out["grid"] = grid.name;
  out["inertia_s"] = model.inertia_s();
  out["droop_pu"] = model.droop_pu();
  out["damping_pu"] = grid.damping_pu;
  out["gain_km"] = grid.gain_km;
  out["reheat_fraction"] = grid.reheat_fraction;
  out["reheat_s"] = grid.reheat_s;
  out["base_mw"] = grid.base_mw;
  out["omega_n"] = model.omega_n();
  out["zeta"] = model.zeta();
  const auto closed = grid::underdamped_parameters(model, grid.reheat_s);
  out["alpha"] = closed ? ordered_json(closed->alpha) : ordered_json(nullptr);
  out["omega_r"] = closed ? ordered_json(closed->omega_r) : ordered_json(nullptr);
  out["phi"] = closed ? ordered_json(closed->phi) : ordered_json(nullptr);
  out["phi1"] = closed ? ordered_json(closed->phi1) : ordered_json(nullptr);
  out["t_nadir_s"] = grid::nadir(model, threshold_mw).t_s;
  out["threshold_mw"] = threshold_mw;
  out["threshold_delay_mw"] = control_centre::delay_aware_threshold_mw(grid);
  out["credible_loss_mw"] = control_centre::credible_loss_mw(grid);
  out["outlet_delay_s"] = control_centre::kOutletDelay_s;
  out["k_lse_mw_per_hz_s"] = control_centre::k_lse_mw_per_hz_s(model);
  out["conditions"] = ordered_json::array();
  for (const control_centre::Condition& row :
       control_centre::conditions(model, grid.threshold_hz, row_hz)) {
    out["conditions"].push_back({{"from_hz", row.from_hz},
                                 {"to_hz", row.to_hz},
                                 {"rocof_below_hz_s", row.rocof_below_hz_s}});
  }
  out["blocks"] = ordered_json::array();
  for (const control_centre::BlockSetting& block :
       control_centre::block_settings(grid, accumulation, rules)) {
    out["blocks"].push_back({{"id", block.id},
                             {"power_mw", block.power_mw},
                             {"accumulated_mw", block.accumulated_mw},
                             {"switch_off_hz", block.switch_off_hz}});
  }
  return out;
}

using Rows = std::vector<std::vector<std::string>>;

void print_rows(const Rows& rows, const std::string& sides) {
  for (const std::string& line : render::aligned(rows, sides)) {
    print_wrapped("  " + line, 4);
  }
}

void print_parameters(const grid::Grid& grid, const grid::SfrModel& model, double threshold_mw) {
  const grid::Reference& reference = grid.reference;
  const auto row = [](const char* name, const char* unit, double value,
                      const std::optional<double>& published = {}) -> std::vector<std::string> {
    if (!published) {
      return {name, render::figure(value), unit};
    }
    const int decimals = render::decimals_of_written(*published);
    return {name, render::fixed(value, decimals + 1), unit,
            "published " + render::fixed(*published, decimals)};
  };
  print_rows(
      {row("inertia constant H", "s", model.inertia_s()), row("droop R", "p.u.", model.droop_pu()),
       row("natural frequency omega_n", "rad/s", model.omega_n()),
       row("damping ratio zeta", "", model.zeta()),
       row("time of the nadir", "s", grid::nadir(model, threshold_mw).t_s, reference.t_nadir_s),
       row("threshold loss, eq. (15)", "MW", threshold_mw, reference.threshold_mw),
       row("threshold loss with the outlets' delay", "MW",
           control_centre::delay_aware_threshold_mw(grid)),
       row("largest credible loss", "MW", control_centre::credible_loss_mw(grid)),
       row("K_LSE (loss per ROCOF, eq. (18))", "MW/(Hz/s)",
           control_centre::k_lse_mw_per_hz_s(model))},
      "lrll");
}

void print_conditions(const std::vector<control_centre::Condition>& conditions,
                      const std::vector<double>& published_hz_s) {
  Rows rows = {{"from, Hz", "to, Hz", "ROCOF below, Hz/s"}};
  if (!published_hz_s.empty()) {
    rows[0].emplace_back("published");
  }
  // The edges of narrow rows need more than three decimals.
  const double height_hz = conditions[0].to_hz - conditions[0].from_hz;
  const int decimals = std::clamp(render::decimals_of_written(height_hz), 3, 6);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    rows.push_back({render::fixed(conditions[i].from_hz, decimals),
                    render::fixed(conditions[i].to_hz, decimals),
                    render::fixed(conditions[i].rocof_below_hz_s, 4)});
    if (i < published_hz_s.size()) {
      rows.back().push_back(render::fixed(published_hz_s[i], 4));
    }
  }
  std::puts("\nLoad-shedding conditions");
  print_rows(rows, "r");
}

void print_blocks(const std::vector<control_centre::BlockSetting>& blocks) {
  constexpr std::size_t kNameColumns = 40;
  Rows rows = {{"block", "power, MW", "accumulated, MW", "backup: switches off below, Hz"}};
  std::vector<double> powers_mw;
  for (const control_centre::BlockSetting& block : blocks) {
    powers_mw.insert(powers_mw.end(), {block.power_mw, block.accumulated_mw});
  }
  const int decimals = render::decimals_for(powers_mw);
  for (const control_centre::BlockSetting& block : blocks) {
    rows.push_back(
        {render::shortened(block.id, kNameColumns), render::fixed(block.power_mw, decimals),
         render::fixed(block.accumulated_mw, decimals), render::fixed(block.switch_off_hz, 3)});
  }
  std::puts("\nLoad blocks");
  print_rows(rows, "lr");
}

void print(const grid::Grid& grid, double row_hz, Accumulation accumulation, Rules rules) {
  const grid::SfrModel model(grid);
  const double threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
  const grid::Reference& reference = grid.reference;
  print_wrapped(grid.name + ": " + grid.title, 4);
  std::puts("");
  print_parameters(grid, model, threshold_mw);
  const bool comparable = row_hz == grid.condition_row_hz;
  print_conditions(control_centre::conditions(model, grid.threshold_hz, row_hz),
                   comparable ? reference.condition_rocof_hz_s : std::vector<double>());
  const std::vector<control_centre::BlockSetting> blocks =
      control_centre::block_settings(grid, accumulation, rules);
  if (!blocks.empty()) {
    print_blocks(blocks);
  }
  if (!reference.source.empty()) {
    print_wrapped("\nPublished: " + reference.source);
  }
  if (!reference.note.empty()) {
    print_wrapped(reference.note);
  }
}

struct ParamsArguments {
  std::string grid;
  double row_hz = 0.0;
  Accumulation accumulation = Accumulation::kHalfGroup;
  Rules rules = Rules::kGsbench;
  bool json = false;
};

int params(const ParamsArguments& arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  if (std::isnan(arguments.row_hz)) {
    throw profile::ConfigurationError("--row: not a number");
  }
  const double row_hz = arguments.row_hz > 0.0 ? arguments.row_hz : grid.condition_row_hz;
  if (arguments.json) {
    print_json(as_json(grid, row_hz, arguments.accumulation, arguments.rules));
  } else {
    print(grid, row_hz, arguments.accumulation, arguments.rules);
  }
  return kPassed;
}

}  // namespace

void add_params(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "params", "Compute threshold loss, load-shedding conditions and load blocks of a grid",
      params);
  add_grid(command, arguments.grid)->required();
  command
      .add_option("--row", arguments.row_hz,
                  "Frequency step between the rows of load-shedding conditions, 0.001 to 1000 Hz "
                  "(default: condition_row_hz "
                  "of the grid's file)")
      ->type_name("HZ")
      ->check(number_between(grid::kConditionRow_hz.low, grid::kConditionRow_hz.high));
  add_accumulation(command, arguments.accumulation);
  add_rules(command, arguments.rules);
  add_json_flag(command, arguments.json);
  command.footer("Examples:\n  gsbench params ieee24\n  gsbench params ieee24 --row 0.02 --json");
}

}  // namespace gsbench::cli
