#include "commands.hpp"

#include <cstdio>
#include <memory>

#include <judge/catalogue.hpp>
#include <profile/load.hpp>
#include <station/outlet_settings.hpp>

namespace gsbench::cli {
namespace {

void check(const std::vector<std::string>& profiles) {
  for (const std::string& name : profiles) {
    const profile::Plan plan = profile::load_profile(name, judge::measure_names());
    // What only the outlets could refuse is a mistake in the profile as well.
    for (const profile::Outlet& outlet : plan.outlets) {
      station::outlet_settings(plan, outlet, 1);
    }
    plan.synthesizer();
    std::printf("%s: outlets: %zu, %g s at %lld Hz, limits: %zu\n", plan.name.c_str(),
                plan.outlets.size(), plan.stimulus.duration_s,
                static_cast<long long>(plan.stimulus.sample_rate_hz), plan.expectations.size());
  }
}

}  // namespace

void add_check(CLI::App& app, int&) {
  auto profiles = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      app.add_subcommand("check", "Say whether profiles make sense, and play nothing");
  command->add_option("profile", *profiles, "Shipped profiles, or .toml files")->required();
  command->footer("Example:\n  gsbench check my-profile.toml");
  command->callback([profiles] { check(*profiles); });
}

}  // namespace gsbench::cli
