#include "commands.hpp"
#include "output_file.hpp"
#include "page_output.hpp"

#include <filesystem>
#include <stdexcept>

#include <immunity/page.hpp>
#include <immunity/profile_text.hpp>
#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

struct ImmunityArguments {
  std::string grid = "ieee24";
  immunity::Options options;
  std::optional<std::uint32_t> only;
  std::string profile;
  PageOutput output;
};

// As a profile in any folder names it.
std::string name_of(const grid::Grid& grid, const std::string& given) {
  const bool by_path = given != grid.name;
  return by_path ? std::filesystem::canonical(grid.path).string() : given;
}

void write_profile(const ImmunityArguments& arguments, const grid::Grid& grid) {
  OutputFile file(arguments.profile, {grid.path});
  file.append(immunity::profile_text(
      immunity::draw(grid.nominal_hz, arguments.options.seed, *arguments.only), *arguments.only,
      name_of(grid, arguments.grid), arguments.options));
  file.commit();
}

int run_immunity(const ImmunityArguments& arguments) {
  const grid::Grid grid = profile::load_grid(arguments.grid);
  try {
    check(grid, arguments.options);
  } catch (const std::invalid_argument& error) {
    throw profile::ConfigurationError(error.what());
  }
  if (!arguments.profile.empty()) {
    write_profile(arguments, grid);
    return kPassed;
  }
  return print_page("immunity", arguments.output, [&](const campaign::Execution& execution) {
    return arguments.only ? make_page_of_case(grid, arguments.options, *arguments.only, execution)
                          : make_page(grid, arguments.options, execution);
  });
}

}  // namespace

void add_immunity(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "immunity", "Play random disturbances without a loss of power: no outlet may shed",
      run_immunity);
  immunity::Options& options = arguments.options;
  add_grid(command, arguments.grid)->capture_default_str();
  CLI::Option* cases =
      add_with_default(command, "--cases", options.cases, "N", "Number of disturbances")
          ->check(CLI::Range(1U, immunity::kMostCases));
  add_with_default(command, "--noise", options.noise_pct, "PCT",
                   "White noise on each outlet's voltage, RMS, % of the nominal peak amplitude")
      ->check(number_between(0.0, immunity::kMostNoise_pct));
  add_with_default(
      command, "--accumulated", options.accumulated_mw, "MW",
      "P^A of the outlets, MW, from 0 to a limit of the grid; the outlet with the least "
      "trips first");
  add_seed(command, "--seed", options.seed, "Seed of all random values");
  CLI::Option* only =
      command.add_option("--case", arguments.only, "Play only the case of this number, from 0")
          ->type_name("N")
          ->check(CLI::Range(0U, immunity::kMostCases - 1))
          ->excludes(cases);
  CLI::Option* profile =
      command
          .add_option(
              "--profile", arguments.profile,
              "With --case: write the case as a profile, in place of playing it; - is standard "
              "output")
          ->type_name("FILE")
          ->needs(only);
  add_page_options(command, arguments.output);
  for (const char* const other : {"--output", "--json", "--threads"}) {
    profile->excludes(command.get_option(other));
  }
  command.footer(
      "Dips, interruptions, phase steps, flicker, harmonics, mains signalling and oscillations\n"
      "are played in turn. FAIL if a relay opens, or if more than one dip in 1000 is an event.\n"
      "\n"
      "Examples:\n"
      "  gsbench immunity                            100 000 disturbances, some minutes\n"
      "  gsbench immunity island-60hz --cases 2000 --seed 7 -o immunity.html\n"
      "  gsbench immunity --case 1234                plays a case again\n"
      "  gsbench immunity --case 1234 --profile case.toml && gsbench run case.toml");
}

}  // namespace gsbench::cli
