#include "choices.hpp"
#include "commands.hpp"
#include "page_output.hpp"

#include <memory>

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

int run_fleet(FleetArguments arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  fleet::Study& study = arguments.study;
  study.scenario.seed = study.fleet.seed;
  if (arguments.sweeps) {
    study.sweep = arguments.sweep;
  }
  return print_page("fleet", arguments.output, [&](const campaign::Execution& execution) {
    return fleet::make_page(grid, study, execution);
  });
}

void add_outlets(const Command& command, fleet::FleetOptions& fleet) {
  command.option("--groups", fleet.groups, "Of outlets, in order of importance").show_default();
  command.option("--per-group", fleet.per_group, "Outlets in each").show_default();
  command.option("--least", fleet.least_w, "An appliance's least power, W").show_default();
  command.option("--most", fleet.most_w, "An appliance's most power, W").show_default();
  add_accumulation(command, fleet.accumulation);
}

void add_sweep(const Command& command, FleetArguments& arguments) {
  const Option sweep = command.flag("--sweep", arguments.sweeps,
                                    "Also over losses, noises and delays, as heat maps");
  const auto add = [&](const char* name, std::vector<double>& values, const char* text) {
    command.option(name, values, text).comma_separated().needs(sweep);
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
  auto arguments = std::make_shared<FleetArguments>();
  const Command command = line.command(
      "fleet", "Very many outlets after a loss: who sheds, how much, when, how the frequency goes");
  fleet::Study& study = arguments->study;
  fleet::ScenarioOptions& scenario = study.scenario;
  command.option("grid", arguments->grid, "A shipped grid, or a .toml file").show_default();
  command.option("--loss", scenario.loss_mw, "Power lost, MW").show_default();
  command
      .option("--noise", scenario.noise_hz,
              "Of measured frequencies, Hz: ± that if uniform, else σ")
      .show_default();
  add_noise_distribution(command, scenario.distribution);
  add_outlets(command, study.fleet);
  command.option("--delay", scenario.further_delay_s, "Of every outlet's action beyond its own, s")
      .show_default();
  command
      .option("--central-delay", scenario.central_delay_s, "Of a central controller's commands, s")
      .show_default();
  command.flag("--delay-aware", study.delay_aware,
               "Also with a threshold that reckons with the outlets' delay");
  add_sweep(command, *arguments);
  command.flag("--closed-loop", study.closed_loop,
               "Also a thousand outlets with the whole firmware, from the voltage on");
  command.option("--duration", scenario.duration_s, "How long it is played, s").show_default();
  command.option("--seed", study.fleet.seed, "Of all random numbers")
      .range(std::uint64_t{0}, profile::kLargestSeed)
      .show_default();
  add_page_options(command, arguments->output);
  command.footer(
      "Examples:\n"
      "  gsbench fleet                                  a million outlets after 500 MW\n"
      "  gsbench fleet --loss 600 --delay-aware -o fleet.html\n"
      "  gsbench fleet island-60hz --loss 12 --groups 100 --per-group 50 --most 3000\n"
      "  gsbench fleet --sweep --losses 400,500 --delays 0,0.5,2 -o sweep.html");
  command.callback([arguments] { return run_fleet(*arguments); });
}

}  // namespace gsbench::cli
