#include "run_steps.hpp"
#include <control_centre/outlet_settings.hpp>

#include <stdexcept>

#include <capture/capture.hpp>
#include <profile/load.hpp>

namespace gsbench::station {
namespace {

std::string noise_text(const profile::Plan& plan, const source::Limits& source) {
  if (!(plan.stimulus.noise_pct > 0.0)) {
    return "none";
  }
  std::string percent = std::to_string(plan.stimulus.noise_pct);
  percent.erase(percent.find_last_not_of('0') + 1);
  if (percent.back() == '.') {
    percent.pop_back();
  }
  return percent + " % white, " +
         (source.noise_per_outlet ? "each outlet its own" : "the same at all outlets");
}

}  // namespace

record::RunRecord prepare(const profile::Plan& plan, Station& station) {
  for (const profile::Outlet& outlet : plan.outlets) {
    try {
      control_centre::outlet_settings(plan.grid, outlet.settings, 1);
    } catch (const std::invalid_argument& error) {
      throw profile::ConfigurationError(plan.path + ": outlet " + outlet.id + ": " + error.what());
    }
  }
  record::RunRecord run;
  run.run_id = new_run_id();
  run.started_utc = utc_now();
  run.gsbench_version = GSBENCH_VERSION;
  run.firmware_sha256 = GSBENCH_FIRMWARE_SHA256;
  run.profile = plan.name;
  run.profile_title = plan.title;
  run.profile_source = plan.source;
  run.profile_sha256 = plan.sha256;
  run.profile_text = plan.text;
  run.grid = plan.grid.name;
  run.grid_sha256 = plan.grid.sha256;
  const profile::Recording& source = plan.stimulus.recording;
  const recording::TraceColumns& columns = source.columns;
  run.recording = {
      source.file,     source.sha256,           columns.time,           columns.frequency,
      columns.voltage, columns.nominal_voltage, source.replaces_profile};
  run.station = station.name();
  run.bench_uncertainty = station.uncertainty();
  run.noise = noise_text(plan, station.source().limits());
  run.seed = plan.seed;
  run.sample_rate_hz = plan.stimulus.sample_rate_hz;
  run.duration_ticks = plan.duration_ticks();
  run.nominal_hz = plan.grid.nominal_hz;
  run.comparisons = comparisons(plan.grid);
  run.stimulus = stimulus_marks(plan);
  run.truth =
      capture::truth_trace(*plan.truth(), plan.duration_ticks(), plan.stimulus.sample_rate_hz);
  return run;
}

}  // namespace gsbench::station
