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
  add_with_default(command, "--groups", fleet.groups, "N",
                   "Number of groups (load blocks); the least important is shed first");
  add_with_default(command, "--per-group", fleet.per_group, "N", "Outlets in each group");
  add_with_default(command, "--least", fleet.least_w, "W",
                   "Smallest power of an appliance (uniform distribution), W");
  add_with_default(command, "--most", fleet.most_w, "W",
                   "Largest power of an appliance (uniform distribution), W");
  add_accumulation(command, fleet.accumulation);
}

void add_sweep(CLI::App& command, FleetArguments& arguments) {
  CLI::Option* sweep = command.add_flag("--sweep", arguments.sweeps,
                                        "Add heat maps over losses, noise levels and delays");
  const auto add = [&](const char* name, std::vector<double>& values, const char* type,
                       const char* text) {
    command.add_option(name, values, text)->type_name(type)->delimiter(',')->needs(sweep);
  };
  add("--losses", arguments.sweep.losses_mw, "MW,MW,…",
      "Comma-separated losses to sweep, MW (default: 0.9 to 2 times the threshold loss)");
  add("--noises", arguments.sweep.noises_hz, "HZ,HZ,…",
      "Comma-separated noise levels to sweep, Hz (default: 0,0.005,0.01,0.02,0.05)");
  add("--delays", arguments.sweep.delays_s, "S,S,…",
      "Comma-separated delays to sweep, s: additional delay of every outlet, and communication "
      "delay of central control (default: 0,0.1,0.2,0.5,1)");
}

}  // namespace

void add_fleet(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "fleet", "Simulate the load shedding by up to 100 million outlets after a loss", run_fleet);
  fleet::Study& study = arguments.study;
  fleet::ScenarioOptions& scenario = study.scenario;
  add_grid(command, arguments.grid)->capture_default_str();
  add_with_default(command, "--loss", scenario.loss_mw, "MW", "Lost power, MW");
  add_with_default(command, "--noise", scenario.noise_hz, "HZ",
                   "Noise of measured frequencies, Hz: ± this if uniform, σ if Gaussian");
  add_noise_distribution(command, scenario.distribution);
  add_outlets(command, study.fleet);
  add_with_default(command, "--delay", scenario.further_delay_s, "S",
                   "Additional delay of every outlet, s");
  add_with_default(command, "--central-delay", scenario.central_delay_s, "S",
                   "Communication delay of central control, s");
  command.add_flag("--delay-aware", study.delay_aware,
                   "Add a fleet whose threshold loss allows for the delay of the outlets");
  add_sweep(command, arguments);
  command.add_flag(
      "--closed-loop", study.closed_loop,
      "Add 1000 outlets that run the complete firmware, starting from the sampled voltage");
  add_with_default(command, "--duration", scenario.duration_s, "S",
                   "Simulated time after the loss, s");
  add_seed(command, "--seed", study.fleet.seed, "Seed of all random numbers");
  add_page_options(command, arguments.output);
  command.footer(
      "Examples:\n"
      "  gsbench fleet                              a million outlets, loss of 500 MW\n"
      "  gsbench fleet --loss 600 --delay-aware -o fleet.html\n"
      "  gsbench fleet island-60hz --loss 600 --groups 100 --per-group 50 --most 100000\n"
      "  gsbench fleet --sweep --losses 400,500 --delays 0,0.5,2 -o sweep.html");
}

}  // namespace gsbench::cli
