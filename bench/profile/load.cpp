#include "commands.hpp"
#include "expectations.hpp"
#include "files.hpp"
#include "grid_section.hpp"
#include "outlets.hpp"
#include "signal_section.hpp"
#include "trace_section.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include <profile/load.hpp>

namespace gsbench::profile {
namespace {

Table open_top(const Document& document) {
  return {document,
          document.root,
          "a profile",
          {"title", "source", "seed", "grid", "signal", "outlet", "command", "expect"}};
}

Table open_section(const Table& top, const std::string& key, const std::string& what,
                   std::initializer_list<const char*> keys) {
  const Value* section = top.table(key);
  if (section == nullptr) top.refuse_missing(key, what);
  return {top.document(), *section, fmt::format("[{}]", key), keys};
}

// Whatever the waveform refuses beyond what the sections have checked.
void check_playable(const Plan& plan) {
  try {
    (void)plan.synthesizer();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(fmt::format("{}: {}", plan.path, error.what()));
  }
}

}  // namespace

Plan parse_profile(const std::string& text, const std::string& path,
                   const MeasureCatalogue& catalogue, const Overrides& overrides) {
  const Document document = parse_toml(text, path);
  const Table top = open_top(document);
  Plan plan;
  plan.name = profile_name(path);
  plan.path = path;
  plan.text = text;
  plan.sha256 = sha256(text);
  plan.title = top.required_text("title");
  plan.source = top.required_text("source");
  plan.seed = static_cast<std::uint64_t>(
      top.integer("seed", 0, static_cast<std::int64_t>(kLargestSeed)).value_or(1));
  const Table grid_section =
      open_section(top, "grid", "the power system: [grid] system = \"ieee24\"",
                   {"system", "loss", "plant", "block", "reference"});
  const Table signal = open_section(
      top, "signal", "what is played: [signal] duration_s = …",
      {"duration_s", "sample_rate_hz", "noise_pct", "harmonics", "harmonic_set", "frequency",
       "amplitude_step", "phase_jump", "dc_offset_pct", "initial_phase_deg", "trace"});
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
  plan.expectations = read_expectations(top, plan.outlets, catalogue);
  check_playable(plan);
  check_full_scale(signal, plan.stimulus, *plan.truth());
  return plan;
}

Plan load_profile(const std::string& name, const MeasureCatalogue& catalogue,
                  const Overrides& overrides) {
  const NamedFile file = find_profile(name);
  return parse_profile(read_file(file.path), file.path, catalogue, overrides);
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
      const Document document = parse_toml(read_file(file.path), file.path);
      summaries.push_back({file.name, open_top(document).required_text("title")});
    } catch (const ConfigurationError& error) {
      summaries.push_back({file.name, fmt::format("unreadable: {}", error.what())});
    }
  }
  return summaries;
}

}  // namespace gsbench::profile
