#include "commands.hpp"
#include "expectations.hpp"
#include "full_scale.hpp"
#include "grid_section.hpp"
#include "outlets.hpp"
#include "signal_section.hpp"
#include "trace_section.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include <profile/files.hpp>
#include <profile/keys.hpp>
#include <profile/load.hpp>

namespace gsbench::profile {
namespace {

// Whatever the waveform refuses beyond what the sections have checked.
void check_playable(const Plan& plan) {
  try {
    (void)plan.synthesizer();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(fmt::format("{}: {}", plan.path, error.what()));
  }
}

}  // namespace

const keys::Key& profile_keys() {
  static const keys::Key keys = keys::table(
      "a profile", "",
      {keys::text("title", "one line for lists and reports").require(),
       keys::text("source", "where the case comes from").require(),
       keys::whole("seed", "", 0, static_cast<double>(kLargestSeed),
                   "of noise and all else that is random; `--seed` overrides it")
           .permits("0 … 2⁵³")
           .by_default(1),
       grid_section_keys(), signal_keys(), outlet_keys(), command_keys(), expect_keys()});
  return keys;
}

Plan parse_profile(const std::string& text, const std::string& path, const Overrides& overrides) {
  const keys::Document document = keys::parse_toml(text, path);
  const keys::Table top(document, profile_keys());
  Plan plan;
  plan.name = profile_name(path);
  plan.path = path;
  plan.text = text;
  plan.sha256 = sha256(text);
  plan.title = top.text("title");
  plan.source = top.text("source");
  plan.seed = static_cast<std::uint64_t>(top.whole("seed"));
  const keys::Table grid_section = top.table("grid");
  const keys::Table signal = top.table("signal");
  plan.grid = read_grid_section(grid_section, plan.title, plan.source);
  check_conditions(grid_section, plan.grid);
  const bool replaced = !overrides.trace_path.empty();
  plan.stimulus = read_stimulus(signal, grid_section, plan.grid, replaced);
  if (replaced) {
    replace_by_recording(overrides.trace_path, overrides.trace_columns, plan.grid.nominal_hz,
                         plan.stimulus);
  }
  plan.seed = overrides.seed.value_or(plan.seed);
  plan.outlets = read_outlets(top, plan.grid);
  plan.commands = read_commands(top, plan.outlets, plan.stimulus.duration_s);
  plan.expectations = read_expectations(top, plan.outlets);
  check_playable(plan);
  check_full_scale(signal, plan.stimulus, *plan.truth());
  return plan;
}

Plan load_profile(const std::string& name, const Overrides& overrides) {
  const NamedFile file = find_profile(name);
  return parse_profile(read_file(file.path), file.path, overrides);
}

grid::Grid load_grid(const std::string& name) {
  const auto file = find_grid(name, "");
  if (!file) throw ConfigurationError(no_such_grid(name));
  return read_grid_file(*file);
}

std::vector<ProfileSummary> list_profiles() {
  std::vector<ProfileSummary> summaries;
  for (const NamedFile& file : all_profiles()) {
    try {
      const keys::Document document = keys::parse_toml(read_file(file.path), file.path);
      summaries.push_back({file.name, keys::Table(document, profile_keys()).text("title")});
    } catch (const ConfigurationError& error) {
      summaries.push_back({file.name, fmt::format("unreadable: {}", error.what())});
    }
  }
  return summaries;
}

}  // namespace gsbench::profile
