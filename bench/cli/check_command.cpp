#include "commands.hpp"

#include <cstdio>
#include <memory>

#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

void check(const std::string& name) {
  const profile::Plan plan = profile::load_profile(name);
  std::printf("%s: outlets: %zu, %g s at %lld Hz, limits: %zu\n", plan.name.c_str(),
              plan.outlets.size(), plan.stimulus.duration_s,
              static_cast<long long>(plan.stimulus.sample_rate_hz), plan.expectations.size());
}

// Each of them, whatever is wrong with those before it.
int check_all(const std::vector<std::string>& profiles) {
  int exit_code = kPassed;
  for (const std::string& name : profiles) {
    try {
      check(name);
    } catch (const profile::ConfigurationError& error) {
      std::fprintf(stderr, "gsbench: %s\n", error.what());
      exit_code = kBadInput;
    }
  }
  return exit_code;
}

}  // namespace

void add_check(CommandLine& line) {
  auto profiles = std::make_shared<std::vector<std::string>>();
  const Command command =
      line.command("check", "Say whether profiles make sense, and play nothing");
  command.option("profile", *profiles, "Shipped profiles, or .toml files").required();
  command.footer("Example:\n  gsbench check my-profile.toml regression/backup");
  command.callback([profiles] { return check_all(*profiles); });
}

}  // namespace gsbench::cli
