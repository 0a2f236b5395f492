#include <outlet/decision.hpp>
#include <outlet/name_table.hpp>
#include <outlet/outlet.hpp>

namespace gs::outlet {
namespace {

// After a decision, f must be steady for half a second before the detector is armed again.
constexpr std::uint16_t kSteadyReports = 31;

void open_relay(State& state, Report& report, Cause cause) {
  if (state.relay_closed) {
    state.relay_closed = false;
    state.cause = cause;
    report.happened |= kRelay;
  }
}

// Criterion (1): sheds if enough conditions were met, the estimate is trusted, and more is required
// than less important outlets shed.
void decide(const Settings& settings, State& state, Report& report) {
  report.required_mw = required_mw(state.estimator.ekf.loss_mw, settings.threshold_mw);
  report.trust = trust(settings, state.estimator);
  report.happened |= kDecision;
  if (enough_hits(state.estimator.hits, settings.condition_hits) &&
      report.trust == Trust::kTrusted && must_shed(report.required_mw, settings.accumulated_mw)) {
    open_relay(state, report, Cause::kLoss);
  }
  state.phase = Phase::kCooling;
  state.steady_reports = 0;
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
  if (estimator.ekf.count > had_updates) {
    report.happened |= kEstimate;
  }
  if (complete(config.settings, estimator)) {
    decide(config.settings, state, report);
  }
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
  if (!valid) {
    state.below_switch_off = 0;
  } else if (stays_below(report.measurement.frequency_hz, settings.switch_off_hz,
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

void act(const Config& config, State& state, Report& report) {
  const Settings& settings = config.settings;
  const bool valid = report.measurement.validity == Validity::kValid;
  if (report.measurement.validity == Validity::kInvalid) {
    if (state.phase == Phase::kEstimating) {
      report.happened |= kAborted;
    }
    state.phase = Phase::kQuiet;
    state.below_switch_off = 0;
    return;
  }
  watch_switch_off_frequency(settings, state, report, valid);
  if (state.phase == Phase::kQuiet && valid && event_detected(settings, state.history)) {
    begin(state.estimator, baseline(state.history));
    state.phase = Phase::kEstimating;
    report.happened |= kEvent;
  }
  if (state.phase == Phase::kEstimating) {
    estimate(config, state, report, valid);
  } else if (state.phase == Phase::kCooling) {
    cool_down(state, report, valid);
  }
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
  const std::uint32_t in_force = config.has_settings ? config.settings.version : kNoSettings;
  if (settings.version <= in_force) {
    return SettingsError::kStale;
  }
  config.settings = settings;
  config.has_settings = true;
  state.phase = Phase::kQuiet;
  state.below_switch_off = 0;
  return SettingsError::kNone;
}

void lose_track(State& state) {
  state.front_end = FrontEndState{};
  state.tracker = TrackerState{};
}

bool command(State& state, bool close) {
  const bool changes = state.relay_closed != close;
  state.relay_closed = close;
  if (changes) {
    state.cause = close ? Cause::kNone : Cause::kCommand;
  }
  return changes;
}

std::size_t step(const Config& config, State& state, const std::int16_t* samples, std::size_t count,
                 Report& report, bool& ready) {
  const std::size_t taken = feed(config.front_end, state.front_end, samples, count, ready);
  if (!ready) {
    return taken;
  }
  report = Report{};
  report.number = state.reports++;
  const float nominal_hz = static_cast<float>(config.hardware.nominal_hz);
  report.measurement =
      track(config.settings.tracker, nominal_hz, state.tracker, phasor(state.front_end));
  if (!config.hardware.has_crystal) {
    invalidate_frequency(report.measurement);
  }
  remember(state, report.measurement);
  const int window = config.settings.rocof_samples;
  report.line = state.history.unbroken >= window ? fit_line(state.history, 0, window)
                                                 : Line{kNotANumber, kNotANumber};
  if (config.has_settings) {
    act(config, state, report);
  }
  report.phase = state.phase;
  report.baseline = state.estimator.baseline;
  report.hits = state.estimator.hits;
  report.lse_loss_mw = state.estimator.lse_loss_mw;
  report.loss_mw = state.estimator.ekf.loss_mw;
  report.loss_sigma_mw = loss_sigma_mw(state.estimator);
  report.loss_instant_s = loss_instant_s(state.estimator);
  report.trust = trust(config.settings, state.estimator);
  report.relay_closed = state.relay_closed;
  report.cause = state.cause;
  return taken;
}

}  // namespace gs::outlet
