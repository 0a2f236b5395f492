#include "run_steps.hpp"
#include <control_centre/outlet_settings.hpp>
#include <control_centre/threshold.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

#include <capture/capture.hpp>
#include <grid/falling_limb.hpp>
#include <installation/installation.hpp>
#include <profile/load.hpp>
#include <waveform/synthesizer.hpp>
#include <wire/codec.hpp>

namespace gsbench::station {
namespace {

std::string formatted_utc(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), format, &utc);
  return {text.data(), length};
}

// Time and a random part: sorts by time and is unique across machines.
std::string new_run_id() {
  return formatted_utc("%Y%m%dT%H%M%SZ-") + fmt::format("{:08x}", std::random_device()());
}

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

// "500 MW", "-20°", "40 %": at most four digits.
std::string figure(double value, const char* unit) {
  return fmt::format("{:.4g}{}", value, unit);
}

// The instants of the stimulus, in order of time.
std::vector<record::Mark> stimulus_marks(const profile::Plan& plan) {
  const auto tick = [&plan](double at_s) {
    return waveform::tick_at(at_s, plan.stimulus.sample_rate_hz);
  };
  std::vector<record::Mark> marks;
  for (const grid::PowerChange& loss : plan.stimulus.losses) {
    const bool lost = loss.power_mw > 0.0;
    const std::string what =
        fmt::format("{} {}{}", figure(std::fabs(loss.power_mw), " MW"), lost ? "lost" : "shed",
                    loss.ramp_s > 0.0 ? " over " + figure(loss.ramp_s, " s") : "");
    marks.push_back({tick(loss.at_s), lost ? "loss" : "shed", loss.power_mw, what});
    if (loss.ramp_s > 0.0 && loss.at_s + loss.ramp_s < plan.stimulus.duration_s) {
      marks.push_back({tick(loss.at_s + loss.ramp_s), "ramp end", loss.power_mw, "end of " + what});
    }
  }
  for (const waveform::Oscillation& oscillation : plan.stimulus.oscillations) {
    const double amplitude_mhz = 1e3 * oscillation.amplitude_hz;
    const std::string what = figure(oscillation.frequency_hz, " Hz") + " oscillation";
    marks.push_back({tick(oscillation.at_s), "oscillation", amplitude_mhz,
                     what + ", ± " + figure(amplitude_mhz, " mHz")});
    if (std::isfinite(oscillation.duration_s)) {
      marks.push_back(
          {tick(oscillation.at_s + oscillation.duration_s), "oscillation", 0.0, "end of " + what});
    }
  }
  for (const waveform::PhaseJump& jump : plan.stimulus.signal.phase_jumps) {
    marks.push_back(
        {tick(jump.at_s), "phase jump", jump.degrees, figure(jump.degrees, "° phase step")});
  }
  for (const waveform::AmplitudeStep& step : plan.stimulus.signal.amplitude_steps) {
    marks.push_back(
        {tick(step.at_s), "amplitude", step.level_pct, "voltage " + figure(step.level_pct, " %")});
    if (std::isfinite(step.duration_s)) {
      marks.push_back({tick(step.at_s + step.duration_s), "amplitude", 100.0, "voltage restored"});
    }
  }
  for (const waveform::Flicker& flicker : plan.stimulus.signal.flickers) {
    const std::string what = figure(flicker.frequency_hz, " Hz") + " flicker";
    marks.push_back({tick(flicker.at_s), "flicker", flicker.depth_pct,
                     what + ", ΔV/V " + figure(flicker.depth_pct, " %")});
    if (std::isfinite(flicker.duration_s)) {
      marks.push_back({tick(flicker.at_s + flicker.duration_s), "flicker", 0.0, "end of " + what});
    }
  }
  for (const waveform::Tone& tone : plan.stimulus.signal.tones) {
    const std::string what =
        figure(tone.frequency_hz, " Hz") + (tone.pulses.empty() ? " tone" : " keyed tone");
    marks.push_back({tick(tone.at_s), "tone", tone.amplitude_pct,
                     what + ", " + figure(tone.amplitude_pct, " %")});
    if (std::isfinite(tone.duration_s)) {
      marks.push_back({tick(tone.at_s + tone.duration_s), "tone", 0.0, "end of " + what});
    }
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const record::Mark& a, const record::Mark& b) { return a.tick < b.tick; });
  return marks;
}

// Values calculated for the plan's grid, beside those of the publication.
std::vector<record::Comparison> comparisons(const grid::Grid& grid) {
  const grid::Reference& reference = grid.reference;
  const grid::SfrModel model(grid);
  const double threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
  std::vector<record::Comparison> all;
  if (reference.threshold_mw) {
    all.push_back({"threshold loss, eq. (15)", "MW", threshold_mw, *reference.threshold_mw, ""});
  }
  if (reference.t_nadir_s) {
    all.push_back({"time of the nadir", "s", grid::nadir(model, threshold_mw).t_s,
                   *reference.t_nadir_s, reference.note});
  }
  const std::vector<control_centre::Condition> rows =
      control_centre::conditions(model, grid.threshold_hz, grid.condition_row_hz);
  for (std::size_t row = 0; row < rows.size() && row < reference.condition_rocof_hz_s.size();
       ++row) {
    all.push_back({fmt::format("condition {:.2f} … {:.2f} Hz, ROCOF below", rows[row].from_hz,
                               rows[row].to_hz),
                   "Hz/s", rows[row].rocof_below_hz_s, reference.condition_rocof_hz_s[row], ""});
  }
  return all;
}

record::Recording kept(const profile::Recording& recording) {
  record::Recording kept;
  kept.file = recording.file;
  kept.sha256 = recording.sha256;
  kept.time = recording.format.time;
  kept.frequency = recording.format.frequency;
  kept.voltage = recording.format.voltage;
  kept.nominal_voltage = recording.format.nominal_voltage.value_or(0.0);
  kept.replaces_profile = recording.replaces_profile;
  if (!recording.file.empty()) {
    kept.options = profile::trace_options(recording.format);
    kept.text = recording.played_text;
    kept.rows = recording.rows;
    kept.gaps = recording.gaps;
  }
  return kept;
}

}  // namespace

std::string utc_now() {
  return formatted_utc("%Y-%m-%dT%H:%M:%SZ");
}

record::Sent sent(gs::wire::Downlink message, std::int64_t tick) {
  const char* kind = message.kind == gs::wire::DownlinkKind::kSettings  ? "settings"
                     : message.kind == gs::wire::DownlinkKind::kCommand ? "command"
                                                                        : "ask self test";
  record::Sent kept = {tick, kind, {}};
  message.session = 1;
  kept.message.resize(gs::wire::kLongestMessage);
  kept.message.resize(gs::wire::encode(message, 0, kept.message.data(), kept.message.size()));
  return kept;
}

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
  run.software = software();
  run.gsbench_version = installation::version();
  run.firmware_sha256 = GSBENCH_FIRMWARE_SHA256;
  run.profile = plan.name;
  run.profile_title = plan.title;
  run.profile_source = plan.source;
  run.profile_sha256 = plan.sha256;
  run.profile_text = plan.text;
  run.grid = plan.grid.name;
  run.grid_sha256 = plan.grid.sha256;
  run.grid_text = plan.grid_text;
  run.recording = kept(plan.stimulus.recording);
  run.station = station.name();
  run.noise = noise_text(plan, station.source().limits());
  run.seed = plan.seed;
  run.sample_rate_hz = plan.stimulus.sample_rate_hz;
  run.duration_ticks = plan.duration_ticks();
  run.nominal_hz = plan.grid.nominal_hz;
  run.comparisons = comparisons(plan.grid);
  run.stimulus = stimulus_marks(plan);
  run.reference = capture::reference_trace(*plan.reference(), plan.duration_ticks(),
                                           plan.stimulus.sample_rate_hz);
  return run;
}

}  // namespace gsbench::station
