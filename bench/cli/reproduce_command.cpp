#include "commands.hpp"
#include "page_output.hpp"

#include <memory>

#include <campaign/estimates.hpp>
#include <profile/load.hpp>
#include <reproduce/reproduction.hpp>

namespace gsbench::cli {
namespace {

struct ReproduceArguments {
  std::string grid = "ieee24";
  reproduce::Options options;
  PageOutput output;
};

int run_reproduce(const ReproduceArguments& arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  return print_page("reproduce", arguments.output, [&](const campaign::Execution& execution) {
    return reproduce::reproduce(grid, arguments.options, execution);
  });
}

std::string list_of_items() {
  std::string text = "What can be reproduced:\n";
  for (const reproduce::Item& item : reproduce::items()) {
    text += "  " + item.id + std::string(10 - item.id.size(), ' ') + item.title + '\n';
  }
  return text +
         "Fig. 19 is a run: gsbench run paper/loss-500mw\n"
         "\n"
         "Examples:\n"
         "  gsbench reproduce -o paper.html               all of it, a million trajectories\n"
         "  gsbench reproduce --only table4,table5 --n 10000000 --seed 7\n"
         "  gsbench reproduce --only table2 --json";
}

}  // namespace

void add_reproduce(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<ReproduceArguments>();
  CLI::App* command = app.add_subcommand(
      "reproduce", "The paper's tables and figures, computed again and set beside what it prints");
  command->add_option("--only", arguments->options.only, "Some of them, by commas")->delimiter(',');
  command->add_option("--n", arguments->options.trajectories, "Trajectories of each campaign")
      ->check(CLI::Range(std::uint64_t{1}, campaign::kMostTrajectories))
      ->capture_default_str();
  command->add_option("--seed", arguments->options.seed, "Of all random numbers")
      ->check(kSeedRange)
      ->capture_default_str();
  command->add_option("--grid", arguments->grid, "A shipped grid, or a .toml file")
      ->capture_default_str();
  add_page_options(*command, arguments->output);
  command->footer(list_of_items());
  command->callback([arguments, &exit_code] { exit_code = run_reproduce(*arguments); });
}

}  // namespace gsbench::cli
