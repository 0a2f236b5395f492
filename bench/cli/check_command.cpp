#include "commands.hpp"
#include "trace_arguments.hpp"

#include <fmt/format.h>

#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

// Checks every profile, also after one with an error.
int check_all(const std::vector<std::string>& profiles) {
  int exit_code = kPassed;
  for (const std::string& name : profiles) {
    try {
      const profile::Plan plan = profile::load_profile(name);
      print_wrapped(fmt::format("{}: outlets: {}, {:g} s at {} samples/s, limits: {}", plan.name,
                                plan.outlets.size(), plan.stimulus.duration_s,
                                plan.stimulus.sample_rate_hz, plan.expectations.size()),
                    4);
      print_recording(plan);
    } catch (const profile::ConfigurationError& error) {
      print_error(error.what());
      exit_code = kBadInput;
    }
  }
  return exit_code;
}

}  // namespace

void add_check(CommandLine& line) {
  const auto [command, arguments] =
      line.command("check", "Check profiles for mistakes, without playing them", check_all);
  command.add_option("PROFILE", arguments, "Names of profiles, or .toml files")
      ->type_name("PROFILE")
      ->required();
  command.footer("Example:\n  gsbench check my-profile.toml regression/backup");
}

}  // namespace gsbench::cli
