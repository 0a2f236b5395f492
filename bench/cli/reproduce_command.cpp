#include "choices.hpp"
#include "commands.hpp"
#include "page_output.hpp"

#include <memory>

#include <campaign/estimates.hpp>
#include <paper/reproduction.hpp>
#include <profile/load.hpp>
#include <station/run.hpp>
#include <station/station.hpp>

namespace gsbench::cli {
namespace {

constexpr const char* kExperiment = "paper/loss-500mw";

struct ReproduceArguments {
  std::string grid = "ieee24";
  paper::Options options;
  PageOutput output;
};

record::RunRecord play_experiment(std::uint64_t seed, const campaign::Execution& execution) {
  profile::Overrides overrides;
  overrides.seed = seed;
  const profile::Plan plan = profile::load_profile(kExperiment, overrides);
  station::SimulatedOptions simulated;
  simulated.threads = execution.threads;
  const auto station = station::simulated_station(plan, simulated);
  station::RunOptions options;
  options.stop = execution.stop;
  options.progress = execution.progress;
  return station::run(plan, *station, options);
}

int run_reproduce(ReproduceArguments arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  paper::Options& options = arguments.options;
  options.play_experiment = [seed = options.seed](const campaign::Execution& execution) {
    return play_experiment(seed, execution);
  };
  return print_page("reproduce", arguments.output, [&](const campaign::Execution& execution) {
    return paper::reproduce(grid, options, execution);
  });
}

// What the paper leaves open.
void add_choices(const Command& command, paper::Choices& choices) {
  add_noise_distribution(command, choices.noise_distribution);
  add_loss_instant(command, choices.loss_instant);
  campaign::Counting& counting = choices.counting;
  const auto add = [&command](const char* name, auto& value, const char* text) {
    return command.option(name, value, text).show_default();
  };
  add("--rocof-window", counting.window, "Table 2, the paper's way: samples in a slope")
      .range(2, 64);
  add("--count-from", counting.first, "The same: sample from which on conditions are counted")
      .range(0, 1000);
  add("--count-lines", counting.count, "The same: how many samples are counted").range(1, 1000);
  add("--hits-above", counting.more_than, "The same: hits above which load shedding is needed")
      .range(0, 1000);
  add("--ekf-loss-sigma", choices.ekf_loss_sigma_mw,
      "The paper's EKF starts with this standard deviation of LSE, MW");
  add("--ekf-instant-sigma", choices.ekf_t_x_sigma_s,
      "And with this standard deviation of the loss's instant, s");
}

std::string list_of_items() {
  std::string text = "What can be reproduced:\n";
  for (const paper::Item& item : paper::items()) {
    text += "  " + item.id + std::string(10 - item.id.size(), ' ') + item.title + '\n';
  }
  return text +
         "\n"
         "Examples:\n"
         "  gsbench reproduce -o paper.html               all of it, a million trajectories\n"
         "  gsbench reproduce --only table4,table5 --n 10000000 --seed 7\n"
         "  gsbench reproduce --only table2 --rocof-window 8 --count-lines 38 --json\n"
         "  gsbench reproduce --noise-distribution gaussian --loss-instant between-reports";
}

}  // namespace

void add_reproduce(CommandLine& line) {
  auto arguments = std::make_shared<ReproduceArguments>();
  const Command command = line.command(
      "reproduce", "The paper's tables and figures, computed again and set beside what it prints");
  command.option("--only", arguments->options.only, "Comma-separated sections, instead of all")
      .comma_separated();
  command.option("--n", arguments->options.trajectories, "Trajectories of each campaign")
      .range(std::uint64_t{1}, campaign::kMostTrajectories)
      .show_default();
  command.option("--seed", arguments->options.seed, "Of all random numbers")
      .range(std::uint64_t{0}, profile::kLargestSeed)
      .show_default();
  command.option("--grid", arguments->grid, "A shipped grid, or a .toml file").show_default();
  add_choices(command, arguments->options.choices);
  add_accumulation(command, arguments->options.accumulation);
  add_page_options(command, arguments->output);
  command.footer(list_of_items());
  command.callback([arguments] { return run_reproduce(*arguments); });
}

}  // namespace gsbench::cli
