#include "commands.hpp"

#include <cstdio>

#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

// Each of them, whatever is wrong with those before it.
int check_all(const std::vector<std::string>& profiles) {
  int exit_code = kPassed;
  for (const std::string& name : profiles) {
    try {
      const profile::Plan plan = profile::load_profile(name);
      std::printf("%s: outlets: %zu, %g s at %lld Hz, limits: %zu\n", plan.name.c_str(),
                  plan.outlets.size(), plan.stimulus.duration_s,
                  static_cast<long long>(plan.stimulus.sample_rate_hz), plan.expectations.size());
    } catch (const profile::ConfigurationError& error) {
      std::fprintf(stderr, "gsbench: %s\n", error.what());
      exit_code = kBadInput;
    }
  }
  return exit_code;
}

}  // namespace

void add_check(CommandLine& line) {
  const auto [command, arguments] =
      line.command("check", "Say whether profiles make sense, and play nothing", check_all);
  command.add_option("profile", arguments, "Shipped profiles, or .toml files")->required();
  command.footer("Example:\n  gsbench check my-profile.toml regression/backup");
}

}  // namespace gsbench::cli
