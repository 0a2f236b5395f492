#include "criteria.hpp"

#include <outlet/outlet.hpp>
#include <outlet/shedding.hpp>

namespace gs::outlet {
namespace {

// Time from a report's phasor to the open relay: the front end's delay, and 8 ms of the relay.
constexpr float kLead_s = kFrontEndDelay_s + 0.008f;

void remember(State& state, const Measurement& measurement) {
  switch (measurement.validity) {
    case Validity::kValid:
      push(state.history, measurement.frequency_hz);
      break;
    case Validity::kHeld:
      note_gap(state.history);
      break;
    case Validity::kInvalid:
      // Frequencies from before a dead bus do not apply to the time after it.
      if (state.history.filled > 0) {
        state.before_gap = baseline(state);
        state.history = History{};
      }
      break;
  }
}

// Leaves only the voltage.
void invalidate_frequency(Measurement& measurement) {
  measurement.frequency_hz = kNotANumber;
  measurement.rocof_hz_s = kNotANumber;
  measurement.validity = Validity::kInvalid;
}

// Puts accepted settings into force.
void put_in_force(Config& config, const Settings& settings) {
  config.settings = settings;
  config.has_settings = true;
  config.follower.response = settings.response;
  config.follower.step = grid_step(settings.response, kReport_s);
  config.follower.scale_mw = settings.threshold_mw;
  config.follower.phase_sigma_rad = settings.tracker.phase_noise_rad;
  config.look_ahead = grid_step(settings.response, kLookAhead_s);
  config.lead = grid_step(settings.response, kLead_s + settings.delay_s);
}

bool event_under_way(const State& state) {
  const GridFollower& follower = state.follower;
  return state.phase == Phase::kEstimating || follower.changed || follower.rival_lives ||
         is_behind(follower);
}

}  // namespace

bool configure(const Hardware& hardware, Config& config) {
  // Field by field: a temporary Config would not fit onto an outlet's stack.
  config.hardware = hardware;
  config.settings = Settings{};
  config.has_settings = false;
  return make_front_end(hardware, config.front_end);
}

SettingsError apply(Config& config, State& state, const Settings& settings) {
  const SettingsError error = validate(settings, static_cast<float>(config.hardware.nominal_hz));
  if (error != SettingsError::kNone) {
    return error;
  }
  const std::uint32_t newest = config.has_settings ? accepted(config).version : kNoSettings;
  if (!is_newer(settings.version, newest)) {
    return SettingsError::kStale;
  }
  config.has_next = config.has_settings && event_under_way(state);
  if (config.has_next) {
    config.next = settings;
  } else {
    put_in_force(config, settings);
    // In a quiet grid the control centre knows which load is off, and P^A no longer includes it.
    if (state.phase == Phase::kQuiet) {
      state.account = ShedAccount{};
    }
  }
  return SettingsError::kNone;
}

bool renew(Config& config, const State& state) {
  if (!config.has_next || event_under_way(state)) {
    return false;
  }
  config.has_next = false;
  put_in_force(config, config.next);
  return true;
}

const Settings& accepted(const Config& config) {
  return config.has_next ? config.next : config.settings;
}

void lose_track(State& state) {
  state.front_end = FrontEndState{};
  state.tracker = TrackerState{};
  clear(state.follower);
}

void reset(State& state) {
  lose_track(state);
  state.history = History{};
  state.before_gap = Baseline{};
  state.estimator = EstimatorState{};
  state.account = ShedAccount{};
  state.least_loss_mw = kNoLoss_mw;
  state.undisturbed = 0;
  state.phase = Phase::kQuiet;
  state.steady_reports = 0;
  state.below_switch_off = 0;
  state.relay = RelayState{};
  state.reports = 0;
}

bool command(State& state, bool close) {
  if (close) {
    state.account = ShedAccount{};
  }
  return command(state.relay, close);
}

std::size_t step(const Config& config, State& state, const std::int16_t* samples, std::size_t count,
                 Report& report, bool& ready) {
  const std::size_t taken = feed(config.front_end, state.front_end, samples, count, ready);
  if (config.has_settings && config.settings.method == kByGridState) {
    follow_up(config.follower, state.follower, ready ? kReportParts : state.front_end.subsum);
  }
  if (!ready) {
    return taken;
  }
  report = Report{};
  report.number = state.reports++;
  const float nominal_hz = static_cast<float>(config.hardware.nominal_hz);
  const Phasor z = phasor(state.front_end);
  report.measurement = track(config.settings.tracker, nominal_hz, state.tracker, z);
  if (!config.hardware.has_crystal) {
    invalidate_frequency(report.measurement);
  }
  remember(state, report.measurement);
  const int window = config.settings.rocof_samples;
  report.line = state.history.unbroken >= window ? fit_line(state.history, 0, window)
                                                 : Line{kNotANumber, kNotANumber};
  if (config.has_settings) {
    act(config, state, z, report);
  }
  report.phase = state.phase;
  report.baseline = state.estimator.baseline;
  report.hits = state.estimator.hits;
  report.lse_loss_mw = state.estimator.lse_loss_mw;
  report.loss_instant_s = loss_instant_s(state.estimator);
  if (config.settings.method == kByPaper) {
    report.loss_mw = state.estimator.ekf.loss_mw;
    report.loss_sigma_mw = loss_sigma_mw(state.estimator);
    report.trust = trust(config.settings, state.estimator);
  }
  report.relay_closed = state.relay.closed;
  report.cause = state.relay.cause;
  return taken;
}

}  // namespace gs::outlet
