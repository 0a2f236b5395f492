#include <outlet/arithmetic.hpp>
#include <outlet/decision.hpp>
#include <outlet/name_table.hpp>
#include <outlet/outlet.hpp>
#include <outlet/shedding.hpp>

namespace gs::outlet {
namespace {

// After a decision, f must be steady for half a second before the detector is armed again.
constexpr std::uint16_t kSteadyReports = 31;
// Five drops make an event only if no report was held so shortly before: a disturbance of the
// voltage leaves a transient of the tracked frequency behind.
constexpr std::uint8_t kUndisturbedReports = 20;
// From a phasor to the open relay: the front end's delay and 8 ms.
constexpr float kLead_s = kFrontEndDelay_s + 0.008f;
// A decision by the grid's state is due with this σ of the lost power, per threshold loss, or this
// many reports later: then as far as it is sure, two σ.
constexpr float kSureSigma = 0.034f;
constexpr int kLatestReports = 20;
constexpr float kSureSigmas = 2.0f;
// An event without an onset of the follower was none.
constexpr int kReportsWithoutOnset = 60;

void open_relay(State& state, Report& report, Cause cause) {
  if (state.relay_closed) {
    state.relay_closed = false;
    state.cause = cause;
    report.happened |= kRelay;
  }
}

void end_event(State& state) {
  state.phase = Phase::kCooling;
  state.steady_reports = 0;
}

// Criterion (1) as the paper has it: sheds if enough conditions were met, the estimate is trusted,
// and more is required than less important outlets shed.
void decide_by_paper(const Settings& settings, State& state, Report& report) {
  report.required_mw = required_mw(state.estimator.ekf.loss_mw, settings.threshold_mw);
  report.trust = trust(settings, state.estimator);
  report.happened |= kDecision;
  if (enough_hits(state.estimator.hits, settings.condition_hits) &&
      report.trust == Trust::kTrusted && must_shed(report.required_mw, settings.accumulated_mw)) {
    open_relay(state, report, Cause::kLoss);
  }
  end_event(state);
}

void estimate(const Config& config, State& state, Report& report, bool valid) {
  EstimatorState& estimator = state.estimator;
  const bool had_lse = estimator.started;
  const int had_updates = estimator.ekf.count;
  observe(config.settings, static_cast<float>(config.hardware.nominal_hz), estimator, valid,
          report.measurement.frequency_hz, report.line);
  if (estimator.started && !had_lse) {
    report.happened |= kLse;
  }
  if (config.settings.method == kByPaper && estimator.ekf.count > had_updates) {
    report.happened |= kEstimate;
  }
  if (config.settings.method == kByPaper && complete(config.settings, estimator)) {
    decide_by_paper(config.settings, state, report);
  }
}

bool is_sure(const Settings& settings, float loss_sigma_mw) {
  return loss_sigma_mw <= kSureSigma * settings.threshold_mw;
}

// Criterion (1) by the grid's state: sheds if more is required to keep the nadir at f_s than less
// important outlets shed, now and before. Due once after each change of the lost power.
void decide_by_grid_state(const Config& config, State& state, const Followed& followed,
                          Report& report) {
  GridFollower& follower = state.follower;
  const Settings& settings = config.settings;
  const bool is_event = state.phase == Phase::kEstimating;
  if (!follower.changed) {
    if (is_event && state.estimator.reports >= kReportsWithoutOnset) {
      report.happened |= kDecision;
      end_event(state);
    }
    return;
  }
  const bool sure = is_sure(settings, followed.loss_sigma_mw);
  const int due = settings.decision_reports + (sure ? 0 : kLatestReports);
  if (follower.since_onset < due) {
    return;
  }
  follower.changed = false;
  const auto nominal_hz = static_cast<float>(config.hardware.nominal_hz);
  const Shedding needed = shedding(config.look_ahead, advanced(config.lead, followed.state),
                                   settings.threshold_hz + settings.nadir_margin_hz - nominal_hz);
  const float doubt_mw = sure ? 0.0f : kSureSigmas * followed.loss_sigma_mw;
  const float required_mw = maximum(needed.required_mw - doubt_mw, 0.0f);
  if (!is_event && !(required_mw > 0.0f)) {
    return;
  }
  report.happened |= kDecision;
  report.required_mw = required_mw;
  report.nadir_hz = nominal_hz + needed.nadir_hz;
  report.shed_before_mw = state.shed_before_mw;
  if (required_mw > 0.0f && must_shed(state.shed_before_mw + required_mw, settings.accumulated_mw)) {
    open_relay(state, report, Cause::kLoss);
  }
  state.shed_before_mw += required_mw;
  end_event(state);
}

Followed follow_grid(const Config& config, State& state, const Phasor& z) {
  if (state.tracker.dead || state.tracker.age == 0) {
    return {};
  }
  return follow(config.follower, state.follower, angle_of(z.quadrature, z.in_phase) / kTwoPi,
                root(z.in_phase * z.in_phase + z.quadrature * z.quadrature),
                !state.tracker.coasting, state.tracker.omega_rad_s / kTwoPi);
}

void cool_down(State& state, const Report& report, bool valid) {
  const bool steady =
      valid && report.line.slope_hz_s > -kSteady_hz_s && report.line.slope_hz_s < kSteady_hz_s;
  state.steady_reports =
      steady ? static_cast<std::uint16_t>(state.steady_reports + 1) : static_cast<std::uint16_t>(0);
  if (state.steady_reports >= kSteadyReports) {
    state.phase = Phase::kQuiet;
  }
}

// Criterion (2), independent of the estimate.
void watch_switch_off_frequency(const Settings& settings, State& state, Report& report,
                                bool valid) {
  if (valid && stays_below(report.measurement.frequency_hz, settings.switch_off_hz,
                         settings.switch_off_samples, state.below_switch_off)) {
    open_relay(state, report, Cause::kFrequency);
  }
}

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
      state.history = History{};
      break;
  }
}

// Leaves only the voltage.
void invalidate_frequency(Measurement& measurement) {
  measurement.frequency_hz = kNotANumber;
  measurement.rocof_hz_s = kNotANumber;
  measurement.validity = Validity::kInvalid;
}

bool event_begins(const Config& config, const State& state, bool valid, const Followed& followed) {
  const bool by_state = config.settings.method == kByGridState;
  if (by_state && followed.significant &&
      state.follower.filter.x[kLoss] > state.follower.loss_before_mw) {
    return true;
  }
  return state.phase == Phase::kQuiet && valid &&
         !(by_state && state.undisturbed < kUndisturbedReports) &&
         event_detected(config.settings, state.history);
}

void act(const Config& config, State& state, const Phasor& z, Report& report) {
  const Settings& settings = config.settings;
  const bool valid = report.measurement.validity == Validity::kValid;
  state.undisturbed = static_cast<std::uint8_t>(
      report.measurement.validity != Validity::kValid ? 0
      : state.undisturbed < 0xFF                      ? state.undisturbed + 1
                                                      : state.undisturbed);
  if (report.measurement.validity == Validity::kInvalid) {
    if (state.phase == Phase::kEstimating) {
      report.happened |= kAborted;
    }
    state.phase = Phase::kQuiet;
    state.below_switch_off = 0;
    state.follower.count = 0;
    return;
  }
  watch_switch_off_frequency(settings, state, report, valid);
  const Followed followed =
      settings.method == kByGridState ? follow_grid(config, state, z) : Followed{};
  if (state.phase != Phase::kEstimating && event_begins(config, state, valid, followed)) {
    begin(state.estimator, baseline(state.history));
    state.phase = Phase::kEstimating;
    report.happened |= kEvent;
  }
  if (state.phase == Phase::kEstimating) {
    estimate(config, state, report, valid);
  } else if (state.phase == Phase::kCooling) {
    cool_down(state, report, valid);
  }
  if (settings.method == kByGridState) {
    report.loss_mw = followed.state.loss_mw;
    report.loss_sigma_mw = followed.loss_sigma_mw;
    report.trust = !state.follower.changed                          ? Trust::kNotYet
                   : is_sure(settings, followed.loss_sigma_mw) ? Trust::kTrusted
                                                                    : Trust::kUncertain;
    if (state.phase == Phase::kEstimating && followed.valid) {
      report.happened |= kEstimate;
    }
    decide_by_grid_state(config, state, followed, report);
  }
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
  config.lead = grid_step(settings.response, kLead_s);
}

bool event_under_way(const State& state) {
  return state.phase == Phase::kEstimating || state.follower.changed;
}

}  // namespace

const char* to_string(Cause cause) {
  static constexpr const char* kNames[] = {"none", "loss", "frequency", "command"};
  return name_of<Cause::kCommand>(cause, kNames);
}

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
  if (settings.version <= newest) {
    return SettingsError::kStale;
  }
  config.has_next = config.has_settings && event_under_way(state);
  if (config.has_next) {
    config.next = settings;
  } else {
    put_in_force(config, settings);
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
  state.follower.count = 0;
}

bool command(State& state, bool close) {
  const bool changes = state.relay_closed != close;
  state.relay_closed = close;
  if (changes) {
    state.cause = close ? Cause::kNone : Cause::kCommand;
    state.shed_before_mw = close ? 0.0f : state.shed_before_mw;
  }
  return changes;
}

std::size_t step(const Config& config, State& state, const std::int16_t* samples, std::size_t count,
                 Report& report, bool& ready) {
  const std::size_t taken = feed(config.front_end, state.front_end, samples, count, ready);
  if (config.has_settings && config.settings.method == kByGridState) {
    // One filter a millisecond; the rest before the next report.
    follow_swing(config.follower, state.follower,
                 ready ? kSwingFilters : state.front_end.subsum - state.follower.bank_next);
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
  report.relay_closed = state.relay_closed;
  report.cause = state.cause;
  return taken;
}

}  // namespace gs::outlet
