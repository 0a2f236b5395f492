#include "commands.hpp"
#include "page_output.hpp"

#include <fleet/page.hpp>
#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

struct FleetArguments {
  std::string grid = "ieee24";
  fleet::Study study;
  fleet::Sweep sweep;
  bool sweeps = false;
  PageOutput output;
};

int run_fleet(const FleetArguments& arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  fleet::Study study = arguments.study;
  study.scenario.seed = study.fleet.seed;
  if (arguments.sweeps) {
    study.sweep = arguments.sweep;
  }
  return print_page("fleet", arguments.output, [&](const campaign::Execution& execution) {
    return fleet::make_page(grid, study, execution);
  });
}

void add_outlets(CLI::App& command, fleet::FleetOptions& fleet) {
  add_with_default(command, "--groups", fleet.groups, "Number of groups, in order of importance");
  add_with_default(command, "--per-group", fleet.per_group, "Number of outlets in each group");
  add_with_default(command, "--least", fleet.least_w, "Lowest power of an appliance, W");
  add_with_default(command, "--most", fleet.most_w, "Highest power of an appliance, W");
  add_accumulation(command, fleet.accumulation);
}

void add_sweep(CLI::App& command, FleetArguments& arguments) {
  CLI::Option* sweep = command.add_flag(
      "--sweep", arguments.sweeps, "Also simulate all combinations of losses, noises and delays");
  const auto add = [&](const char* name, std::vector<double>& values, const char* text) {
    command.add_option(name, values, text)->delimiter(',')->needs(sweep);
  };
  add("--losses", arguments.sweep.losses_mw,
      "Comma-separated losses to sweep, MW (default: 0.9 … 2 × threshold)");
  add("--noises", arguments.sweep.noises_hz,
      "Comma-separated noises to sweep, Hz (default: 0,0.005,0.01,0.02,0.05)");
  add("--delays", arguments.sweep.delays_s,
      "Comma-separated delays to sweep, s (default: 0,0.1,0.2,0.5,1)");
}

}  // namespace

void add_fleet(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "fleet", "Simulate a fleet of outlets after a loss of power, beside other controls",
      run_fleet);
  fleet::Study& study = arguments.study;
  fleet::ScenarioOptions& scenario = study.scenario;
  add_with_default(command, "grid", arguments.grid, "Shipped grid or .toml file");
  add_with_default(command, "--loss", scenario.loss_mw, "Lost power, MW");
  add_with_default(command, "--noise", scenario.noise_hz,
                   "Noise of the measured frequency, Hz: half width if uniform, else σ");
  add_noise_distribution(command, scenario.distribution);
  add_outlets(command, study.fleet);
  add_with_default(command, "--delay", scenario.further_delay_s,
                   "Delay added to every outlet's action, s");
  add_with_default(command, "--central-delay", scenario.central_delay_s,
                   "Delay of a central controller's commands, s");
  command.add_flag("--delay-aware", study.delay_aware,
                   "Also use a threshold that allows for the outlets' delay");
  add_sweep(command, arguments);
  command.add_flag("--closed-loop", study.closed_loop,
                   "Also simulate a thousand outlets with the whole firmware");
  add_with_default(command, "--duration", scenario.duration_s, "Simulated time after the loss, s");
  add_with_default(command, "--seed", study.fleet.seed, "Seed of all random numbers")
      ->check(kSeeds);
  add_page_options(command, arguments.output);
  command.footer(
      "Examples:\n"
      "  gsbench fleet                              a million outlets, loss of 500 MW\n"
      "  gsbench fleet --loss 600 --delay-aware -o fleet.html\n"
      "  gsbench fleet island-60hz --loss 12 --groups 100 --per-group 50 --most 3000\n"
      "  gsbench fleet --sweep --losses 400,500 --delays 0,0.5,2 -o sweep.html");
}

}  // namespace gsbench::cli
