#include "sections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include <profile/load.hpp>

namespace gsbench::profile {
namespace {

// Reports what the waveform library refuses after the sections have been checked.
void check_playable(const Plan& plan) {
  try {
    (void)plan.synthesizer();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(fmt::format("{}: {}", plan.path, error.what()));
  }
}

}  // namespace

keys::Key time_in_run(const char* meaning) {
  return keys::number("at_s", "s", keys::at_least(0.0), meaning)
      .permits("0 … the last sample of the run")
      .require();
}

keys::Key start_key() {
  return keys::number("at_s", "s", keys::at_least(0.0), "start")
      .permits("0 … the last sample of the run")
      .by_default(0.0);
}

keys::Key duration_key() {
  return keys::number("duration_s", "s", keys::above(0.0), "duration")
      .permits("at least one sample, ending within the run")
      .or_else("to the end");
}

double RunTime::end_s() const {
  const auto rate_hz = static_cast<double>(sample_rate_hz);
  return std::min(duration_s, std::round(duration_s * rate_hz) / rate_hz);
}

keys::Range RunTime::starts() const {
  const auto rate_hz = static_cast<double>(sample_rate_hz);
  return {0.0, (std::round(duration_s * rate_hz) - 1.0) / rate_hz, false, false,
          "the last sample of the run"};
}

void check_at_least_a_sample(const keys::Table& table, keys::Position at, const std::string& name,
                             double value_s, double sample_s) {
  constexpr double kRounding_s = 1e-9;
  if (value_s < sample_s - kRounding_s) {
    table.refuse(at, fmt::format("{} is {:.9g} s; it must be at least {:.9g} s, one sample", name,
                                 value_s, sample_s));
  }
}

Span read_span(const keys::Table& table, const RunTime& run, const char* what) {
  const double at_s = table.number("at_s", run.starts());
  const std::optional<double> duration_s = table.find_number("duration_s");
  if (!duration_s) {
    return {at_s, std::numeric_limits<double>::infinity()};
  }
  if (at_s + *duration_s > run.duration_s) {
    table.refuse("duration_s", fmt::format("the {} ends at {} s, after the end of the run at {} s; "
                                           "omit duration_s for one that lasts to the end",
                                           what, at_s + *duration_s, run.duration_s));
  }
  check_at_least_a_sample(table, table.at("duration_s"), "duration_s", *duration_s, run.sample_s());
  return {at_s, *duration_s};
}

const keys::Key& profile_keys() {
  static const keys::Key keys = keys::table(
      "a profile", "",
      {keys::text("title", "title in lists and reports, one line").require(),
       keys::text("source", "origin of the test case: publication, standard, event").require(),
       keys::whole("seed", "", 0, static_cast<double>(kLargestSeed),
                   "seed of the noise and of all other random values; `--seed` overrides it")
           .permits("0 … 2⁵³")
           .by_default(1),
       grid_section_keys(), signal_keys(), outlet_keys(), settings_update_keys(), command_keys(),
       expect_keys()});
  return keys;
}

Plan parse_profile(const std::string& text, const std::string& path, const Overrides& overrides,
                   const Copies& copies) {
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
  plan.grid = read_grid_section(grid_section, plan.title, plan.source, copies.grid, plan.grid_text);
  check_conditions(grid_section, plan.grid);
  const bool replaced = !overrides.trace_path.empty();
  plan.stimulus = read_stimulus(signal, grid_section, plan.grid, replaced, copies);
  if (replaced) {
    replace_by_recording(overrides, plan.grid.nominal_hz, copies, plan.stimulus);
  }
  plan.seed = overrides.seed.value_or(plan.seed);
  plan.outlets = read_outlets(top, plan.grid);
  plan.settings = read_settings_updates(top, plan.grid, plan.outlets, plan.stimulus.duration_s);
  plan.commands =
      read_commands(top, plan.outlets, {plan.stimulus.duration_s, plan.stimulus.sample_rate_hz});
  plan.expectations = read_expectations(top, plan.outlets);
  check_playable(plan);
  check_spectrum(signal, plan.stimulus, *plan.reference());
  check_full_scale(signal, plan.stimulus, *plan.reference());
  return plan;
}

Plan load_profile(const std::string& name, const Overrides& overrides) {
  const std::string path = find_profile(name);
  return parse_profile(read_file(path), path, overrides);
}

grid::Grid load_grid(const std::string& name) {
  const auto file = find_grid(name, "");
  if (!file) {
    throw ConfigurationError(unknown_grid(name));
  }
  return read_grid_text(*file, read_file(file->path));
}

namespace {

std::vector<ProfileSummary> titles_of(const std::vector<NamedFile>& files,
                                      const keys::Key& declared) {
  return summaries_of(files, [&](const NamedFile& file) {
    const keys::Document document = keys::parse_toml(read_file(file.path), file.path);
    return keys::Table(document, declared).text("title");
  });
}

}  // namespace

std::vector<ProfileSummary> list_profiles() {
  return titles_of(all_profiles(), profile_keys());
}

std::vector<ProfileSummary> list_grids() {
  return titles_of(all_grids(), grid_keys());
}

std::vector<ProfileSummary> summaries_of(
    const std::vector<NamedFile>& files,
    const std::function<std::string(const NamedFile&)>& read_title) {
  std::vector<ProfileSummary> summaries;
  for (const NamedFile& file : files) {
    try {
      summaries.push_back({file.name, read_title(file)});
    } catch (const ConfigurationError& error) {
      summaries.push_back({file.name, fmt::format("unreadable: {}", error.what())});
    }
  }
  return summaries;
}

}  // namespace gsbench::profile
