#include "commands.hpp"
#include "interrupt.hpp"
#include "page_output.hpp"
#include "progress.hpp"

#include <memory>
#include <stdexcept>

#include <campaign/estimates.hpp>
#include <profile/load.hpp>
#include <reproduce/reproduction.hpp>

namespace gsbench::cli {
namespace {

struct ReproduceArguments {
  std::string grid = "ieee24";
  reproduce::Options options;
  std::size_t threads = 1;
  PageOutput output;
};

int run_reproduce(const ReproduceArguments& arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  check_place(arguments.output);
  const std::atomic<bool>& interrupted = catch_interrupts();
  campaign::Execution execution;
  execution.threads = arguments.threads;
  execution.stop = &interrupted;
  record::Page page;
  try {
    Progress progress("reproduce");
    execution.progress = [&](double part) { progress.show(part); };
    page = reproduce::reproduce(grid, arguments.options, execution);
  } catch (const std::invalid_argument& error) {
    throw profile::ConfigurationError(error.what());
  }
  print_page(page, arguments.output);
  return interrupted ? kInterrupted : kPassed;
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
  arguments->threads = default_threads();
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
  command->add_option("--threads", arguments->threads, "The result is the same for any")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->output.report,
                      "Write an HTML report there; - is standard output");
  command->add_flag("--json", arguments->output.json, "Print as JSON");
  command->footer(list_of_items());
  command->callback([arguments, &exit_code] { exit_code = run_reproduce(*arguments); });
}

}  // namespace gsbench::cli
