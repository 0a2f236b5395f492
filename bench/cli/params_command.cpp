#include "commands.hpp"
#include <control_centre/blocks.hpp>
#include <control_centre/threshold.hpp>

#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include <grid/falling_limb.hpp>
#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

using control_centre::Accumulation;
using nlohmann::ordered_json;

ordered_json as_json(const grid::Grid& grid, double row_hz, Accumulation accumulation) {
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
       control_centre::block_settings(grid, accumulation)) {
    out["blocks"].push_back({{"id", block.id},
                             {"power_mw", block.power_mw},
                             {"accumulated_mw", block.accumulated_mw},
                             {"switch_off_hz", block.switch_off_hz}});
  }
  return out;
}

void print_beside(const char* what, const char* unit, double ours, int digits,
                  const std::optional<double>& published) {
  std::printf("  %-34s %12.*f %-10s", what, digits, ours, unit);
  if (published) {
    std::printf(" published %.*f", digits, *published);
  }
  std::putchar('\n');
}

void print(const grid::Grid& grid, double row_hz, Accumulation accumulation) {
  const grid::SfrModel model(grid);
  const double threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
  const grid::Reference& reference = grid.reference;
  std::printf("%s: %s\n\n", grid.name.c_str(), grid.title.c_str());
  print_beside("inertia constant H", "s", model.inertia_s(), 4, {});
  print_beside("droop R", "pu", model.droop_pu(), 6, {});
  print_beside("natural frequency omega_n", "rad/s", model.omega_n(), 5, {});
  print_beside("damping ratio zeta", "", model.zeta(), 5, {});
  print_beside("time of the nadir", "s", grid::nadir(model, threshold_mw).t_s, 3,
               reference.t_nadir_s);
  print_beside("threshold power loss", "MW", threshold_mw, 2, reference.threshold_mw);
  print_beside("K_LSE", "MW/(Hz/s)", control_centre::k_lse_mw_per_hz_s(model), 2, {});
  std::puts("\nLoad-shedding conditions");
  const std::vector<control_centre::Condition> rows =
      control_centre::conditions(model, grid.threshold_hz, row_hz);
  const bool comparable = row_hz == grid.condition_row_hz;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::printf("  %7.3f … %7.3f Hz   ROCOF < %8.4f Hz/s", rows[row].from_hz, rows[row].to_hz,
                rows[row].rocof_below_hz_s);
    if (comparable && row < reference.condition_rocof_hz_s.size()) {
      std::printf("   published %8.4f", reference.condition_rocof_hz_s[row]);
    }
    std::putchar('\n');
  }
  const std::vector<control_centre::BlockSetting> blocks =
      control_centre::block_settings(grid, accumulation);
  if (!blocks.empty()) {
    std::puts("\nLoad blocks               power  accumulated  switches off below");
    for (const control_centre::BlockSetting& block : blocks) {
      std::printf("  %-20s %7.1f MW %8.1f MW %11.3f Hz\n", block.id.c_str(), block.power_mw,
                  block.accumulated_mw, block.switch_off_hz);
    }
  }
  if (!reference.source.empty()) {
    std::printf("\nPublished: %s\n", reference.source.c_str());
  }
  if (!reference.note.empty()) {
    std::printf("%s\n", reference.note.c_str());
  }
}

struct ParamsArguments {
  std::string grid;
  double row_hz = 0.0;
  Accumulation accumulation = Accumulation::kHalfGroup;
  bool json = false;
};

int params(const ParamsArguments& arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  if (std::isnan(arguments.row_hz)) {
    throw profile::ConfigurationError("--row: not a number");
  }
  const double row_hz = arguments.row_hz > 0.0 ? arguments.row_hz : grid.condition_row_hz;
  if (arguments.json) {
    print_json(as_json(grid, row_hz, arguments.accumulation));
  } else {
    print(grid, row_hz, arguments.accumulation);
  }
  return kPassed;
}

}  // namespace

void add_params(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "params", "What the control centre works out for a grid: threshold, conditions, blocks",
      params);
  command.add_option("grid", arguments.grid, "A shipped grid, or a .toml file")->required();
  command.add_option("--row", arguments.row_hz, "Height of a row of the conditions, Hz")
      ->check(CLI::Range(0.001, 5.0));
  add_accumulation(command, arguments.accumulation);
  command.add_flag("--json", arguments.json, "Print as JSON");
  command.footer("Examples:\n  gsbench params ieee24\n  gsbench params ieee24 --row 0.02 --json");
}

}  // namespace gsbench::cli
