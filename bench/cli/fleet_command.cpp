#include "commands.hpp"
#include "page_output.hpp"

#include <filesystem>
#include <set>

#include <fleet/page.hpp>
#include <profile/files.hpp>
#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

struct FleetArguments {
  std::string grid = "ieee24";
  fleet::Study study;
  fleet::Sweep sweep;
  bool sweeps = false;
  std::vector<std::string> profiles;  // or folders of them
  bool has_grid = false;
  bool has_seed = false;
  PageOutput output;
};

struct ReadProfiles {
  std::vector<profile::Plan> plans;  // each file once
  bool in_table = false;             // several were given, or a folder
  bool complete = true;              // every file of a folder is a profile
};

// The profiles with the grid and the seed of the command line, if they are given. Files of a folder
// that cannot be read are reported and left out.
ReadProfiles read_profiles(const FleetArguments& arguments) {
  profile::Overrides overrides;
  if (arguments.has_seed) {
    overrides.seed = arguments.study.fleet.seed;
  }
  ReadProfiles read;
  read.in_table = arguments.profiles.size() > 1;
  std::set<std::filesystem::path> files;
  for (const std::string& given : arguments.profiles) {
    const profile::FoundProfiles found = profile::find_profile_or_folder(given);
    read.in_table = read.in_table || found.of_folder;
    for (const std::string& name : found.names) {
      try {
        if (files.insert(std::filesystem::canonical(profile::find_profile(name))).second) {
          read.plans.push_back(profile::load_profile(name, overrides));
        }
      } catch (const profile::ConfigurationError& error) {
        if (!found.of_folder) {
          throw;
        }
        print_error(error.what());
        read.complete = false;
      }
    }
  }
  if (arguments.has_grid) {
    const grid::Grid grid = profile::load_grid(arguments.grid);
    for (profile::Plan& plan : read.plans) {
      plan.grid = grid;
    }
  }
  return read;
}

int run_closed_loop(const FleetArguments& arguments) {
  const ReadProfiles read = read_profiles(arguments);
  if (read.plans.empty()) {
    return kBadInput;
  }
  const int exit_code =
      print_page("fleet", arguments.output, [&](const campaign::Execution& execution) {
        return read.in_table
                   ? fleet::make_scenarios_page(read.plans, arguments.study, execution)
                   : fleet::make_closed_loop_page(read.plans.front(), arguments.study, execution);
      });
  return read.complete || exit_code == kInterrupted ? exit_code : kBadInput;
}

int run_fleet(const FleetArguments& arguments) {
  if (!arguments.profiles.empty()) {
    return run_closed_loop(arguments);
  }
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
  FleetArguments& given = arguments;  // lambdas cannot capture a structured binding
  fleet::Study& study = arguments.study;
  fleet::ScenarioOptions& scenario = study.scenario;
  add_grid(command, arguments.grid)
      ->capture_default_str()
      ->each([&given](const std::string& /*name*/) { given.has_grid = true; });
  add_with_default(command, "--loss", scenario.loss_mw, "MW", "Lost power, MW");
  add_with_default(command, "--noise", scenario.noise_hz, "HZ",
                   "Noise of measured frequencies, Hz: ± this if uniform, σ if Gaussian");
  add_noise_distribution(command, scenario.distribution);
  add_outlets(command, study.fleet);
  add_rules(command, scenario.rules);
  add_with_default(command, "--delay", scenario.further_delay_s, "S",
                   "Additional delay of every outlet, s");
  add_with_default(command, "--central-delay", scenario.central_delay_s, "S",
                   "Communication delay of central control, s");
  command.add_flag("--delay-aware", study.delay_aware,
                   "Add a fleet whose threshold loss allows for the delay of the outlets");
  add_sweep(command, arguments);
  CLI::Option* closed_loop = command.add_flag(
      "--closed-loop", study.closed_loop,
      "Add 1000 outlets that run the complete firmware, starting from the sampled voltage");
  CLI::Option* profile =
      command
          .add_option("--profile", arguments.profiles,
                      "With --closed-loop: play the losses, disturbances and noise of this profile "
                      "into the outlets, compare them with other controls, and judge them beside "
                      "clairvoyants. May be given several times, and may name a folder of "
                      "profiles: then there is one table. The grid is the profile's own if GRID is "
                      "not given")
          ->type_name("PROFILE")
          ->allow_extra_args(false)
          ->needs(closed_loop);
  for (const char* const other : {"--loss", "--noise", "--noise-distribution", "--rules", "--delay",
                                  "--delay-aware", "--sweep"}) {
    profile->excludes(command.get_option(other));
  }
  add_with_default(command, "--duration", scenario.duration_s, "S",
                   "Simulated time after the loss, or the last loss of a profile, s");
  add_seed(command, "--seed", study.fleet.seed,
           "Seed of all random numbers; with --profile: replaces the profile's if given")
      ->each([&given](const std::string& /*seed*/) { given.has_seed = true; });
  add_page_options(command, arguments.output);
  command.footer(
      "With --profile, the exit code is 1 if a profile fails: the nadir is more than 20 mHz below\n"
      "the lowest of four clairvoyants, more is shed than 10 MW plus 1.15 times the most that one "
      "of\n"
      "them sheds, load is shed where none of them sheds any, or an outlet claims an event before "
      "a\n"
      "loss in a profile without oscillations. A recorded frequency is not judged.\n"
      "A file in a folder that is not a profile is reported and left out; the exit code is then "
      "2.\n"
      "\n"
      "Examples:\n"
      "  gsbench fleet                              a million outlets, loss of 500 MW\n"
      "  gsbench fleet --loss 600 --delay-aware -o fleet.html\n"
      "  gsbench fleet island-60hz --loss 600 --groups 100 --per-group 50 --most 100000\n"
      "  gsbench fleet --closed-loop --profile paper/loss-600mw -o closed-loop.html\n"
      "  gsbench fleet ieee24 --closed-loop --profile disturbances/dips --json\n"
      "  gsbench fleet --closed-loop --profile cascades -o cascades.html\n"
      "  gsbench fleet --sweep --losses 400,500 --delays 0,0.5,2 -o sweep.html");
}

}  // namespace gsbench::cli
