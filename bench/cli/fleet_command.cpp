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
  add_with_default(command, "--groups", fleet.groups, "Of outlets, in order of importance");
  add_with_default(command, "--per-group", fleet.per_group, "Outlets in each");
  add_with_default(command, "--least", fleet.least_w, "An appliance's least power, W");
  add_with_default(command, "--most", fleet.most_w, "An appliance's most power, W");
  add_accumulation(command, fleet.accumulation);
}

void add_sweep(CLI::App& command, FleetArguments& arguments) {
  CLI::Option* sweep = command.add_flag("--sweep", arguments.sweeps,
                                        "Also over losses, noises and delays, as heat maps");
  const auto add = [&](const char* name, std::vector<double>& values, const char* text) {
    command.add_option(name, values, text)->delimiter(',')->needs(sweep);
  };
  add("--losses", arguments.sweep.losses_mw,
      "Comma-separated losses to sweep, MW (default: 0.9 … 2 times the threshold)");
  add("--noises", arguments.sweep.noises_hz,
      "Comma-separated noises to sweep, Hz (default: 0,0.005,0.01,0.02,0.05)");
  add("--delays", arguments.sweep.delays_s,
      "Comma-separated delays to sweep, s: every outlet's beyond its own, and central control's "
      "communication (default: 0,0.1,0.2,0.5,1)");
}

}  // namespace

void add_fleet(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "fleet", "Very many outlets after a loss: who sheds, how much, when, how the frequency goes",
      run_fleet);
  fleet::Study& study = arguments.study;
  fleet::ScenarioOptions& scenario = study.scenario;
  add_with_default(command, "grid", arguments.grid, "A shipped grid, or a .toml file");
  add_with_default(command, "--loss", scenario.loss_mw, "Power lost, MW");
  add_with_default(command, "--noise", scenario.noise_hz,
                   "Of measured frequencies, Hz: ± that if uniform, else σ");
  add_noise_distribution(command, scenario.distribution);
  add_outlets(command, study.fleet);
  add_with_default(command, "--delay", scenario.further_delay_s,
                   "Of every outlet's action beyond its own, s");
  add_with_default(command, "--central-delay", scenario.central_delay_s,
                   "Of a central controller's commands, s");
  command.add_flag("--delay-aware", study.delay_aware,
                   "Also with a threshold that reckons with the outlets' delay");
  add_sweep(command, arguments);
  command.add_flag("--closed-loop", study.closed_loop,
                   "Also a thousand outlets with the whole firmware, from the voltage on");
  add_with_default(command, "--duration", scenario.duration_s, "How long it is played, s");
  add_with_default(command, "--seed", study.fleet.seed, "Of all random numbers")->check(kSeeds);
  add_page_options(command, arguments.output);
  command.footer(
      "Examples:\n"
      "  gsbench fleet                                  a million outlets after 500 MW\n"
      "  gsbench fleet --loss 600 --delay-aware -o fleet.html\n"
      "  gsbench fleet island-60hz --loss 12 --groups 100 --per-group 50 --most 3000\n"
      "  gsbench fleet --sweep --losses 400,500 --delays 0,0.5,2 -o sweep.html");
}

}  // namespace gsbench::cli
