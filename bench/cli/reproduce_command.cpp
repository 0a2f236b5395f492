#include "commands.hpp"
#include "page_output.hpp"

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

record::RunRecord run_experiment(std::uint64_t seed, const campaign::Execution& execution) {
  profile::Overrides overrides;
  overrides.seed = seed;
  const profile::Plan plan = profile::load_profile(kExperiment, overrides);
  station::SimulatedOptions simulated;
  simulated.threads = execution.threads;
  const auto station = station::simulated_station(plan, simulated);
  return station::run(plan, *station, {nullptr, execution.stop, execution.progress});
}

int run_reproduce(const ReproduceArguments& arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  paper::Options options = arguments.options;
  options.run_experiment = [seed = options.seed](const campaign::Execution& execution) {
    return run_experiment(seed, execution);
  };
  return print_page("reproduce", arguments.output, [&](const campaign::Execution& execution) {
    return paper::reproduce(grid, options, execution);
  });
}

// Parameters that the paper does not state.
void add_choices(CLI::App& command, paper::Choices& choices) {
  add_noise_distribution(command, choices.noise_distribution);
  add_loss_instant(command, choices.loss_instant);
  campaign::Counting& counting = choices.counting;
  add_with_default(
      command, "--rocof-window", counting.window, "N",
      "Table 2, the paper's method: measurements over which a ROCOF slope is fitted, 2 to 64")
      ->check(CLI::Range(2, 64));
  add_with_default(command, "--count-from", counting.first, "N",
                   "Table 2, the paper's method: first measurement whose slope counts, 0 to 1000; "
                   "0 is the first measurement after the loss")
      ->check(CLI::Range(0, 1000));
  add_with_default(
      command, "--count-lines", counting.count, "N",
      "Table 2, the paper's method: number of slopes that count, 1 to 1000; the slope at "
      "measurement k is fitted over measurements k - window + 1 ... k")
      ->check(CLI::Range(1, 1000));
  add_with_default(
      command, "--hits-above", counting.more_than, "N",
      "Table 2, the paper's method: shed if more slopes than this meet the condition, 0 to 1000")
      ->check(CLI::Range(0, 1000));
  add_with_default(command, "--ekf-loss-sigma", choices.ekf_loss_sigma_mw, "MW",
                   "Initial standard deviation of ΔP in the paper's EKF, MW");
  add_with_default(command, "--ekf-instant-sigma", choices.ekf_t_x_sigma_s, "S",
                   "Initial standard deviation of the instant of the loss in the paper's EKF, s");
}

std::string list_of_items() {
  std::string text = "Sections, each named by its last figure or table:\n";
  for (const paper::Item& item : paper::items()) {
    text += "  " + item.id + std::string(10 - item.id.size(), ' ') + item.title + '\n';
  }
  return text +
         "\n"
         "Examples:\n"
         "  gsbench reproduce -o paper.html               all sections, a million trajectories\n"
         "  gsbench reproduce --only table4,table5 --n 10000000 --seed 7\n"
         "  gsbench reproduce --only table2 --rocof-window 8 --count-lines 38 --json\n"
         "  gsbench reproduce --noise-distribution gaussian --loss-instant between-reports";
}

}  // namespace

void add_reproduce(CommandLine& line) {
  const auto [command, arguments] =
      line.command("reproduce", "Compute the paper's tables and figures, beside the published ones",
                   run_reproduce);
  command
      .add_option("--only", arguments.options.only,
                  "Comma-separated sections from the list below (default: all)")
      ->type_name("SECTION,…")
      ->delimiter(',');
  add_with_default(
      command, "--n", arguments.options.trajectories, "N",
      "Number of simulated noisy frequency curves (trajectories) for each table, 1 to 2^32")
      ->check(CLI::Range(std::uint64_t{1}, campaign::kMostTrajectories));
  add_seed(command, "--seed", arguments.options.seed, "Seed of all random numbers");
  add_with_default(command, "--grid", arguments.grid, "GRID", "Name of a grid, or a .toml file");
  add_choices(command, arguments.options.choices);
  add_accumulation(command, arguments.options.accumulation);
  add_page_options(command, arguments.output);
  command.footer(list_of_items());
}

}  // namespace gsbench::cli
