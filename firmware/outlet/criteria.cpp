// The criteria of §5.5: when an event begins, and when an outlet decides to shed.
#include "criteria.hpp"

#include <outlet/arithmetic.hpp>
#include <outlet/decision.hpp>
#include <outlet/shedding.hpp>

namespace gs::outlet {
namespace {

// After a decision, f must be steady for half a second before event_detected() counts again. A
// significant change of the lost power (method 1) begins an event at once.
constexpr std::uint16_t kSteadyReports = 31;
// With method 1, event_detected() counts only after this many reports without a disturbance of the
// voltage, which leaves a transient in the tracked frequency.
constexpr std::uint8_t kUndisturbedReports = 20;
// The voltage is undisturbed if the relative change of its amplitude is within ± kSteadyAmplitude
// (ten times its noise at 1 %), and the amplitude is above kLeastAmplitude, per unit: noise rotates
// a shorter phasor by a larger angle.
constexpr float kSteadyAmplitude = 0.005f;
constexpr float kLeastAmplitude = 0.7f;
// The estimate is sure if its σ is at most kSureSigma of the threshold loss. If it is not sure when
// the decision is due, the outlet waits up to kLatestReports more. Then it decides with
// kSureSigmas·σ subtracted from the required power.
constexpr float kSureSigma = 0.034f;
constexpr int kLatestReports = 20;
constexpr float kSureSigmas = 2.0f;
// More is lost if the lost power has grown by more than both limits: σ of the estimate, and parts
// of the threshold loss.
constexpr float kMoreSigmas = 3.0f;
constexpr float kMorePart = 0.05f;
// Parts of the power that the newest decision required, for was_shed().
constexpr float kVisiblePart = 0.25f;
constexpr float kHidingPart = 0.5f;
// With method 1, an interruption of the voltage is bridged for 0.8 s. After the voltage returned, a
// phase counts once the front end's window of 56 ms holds only the new voltage.
constexpr std::uint16_t kLongestGap = 50;
constexpr int kReportsOfWindow = 4;
// With method 1, an event ends after this many reports without a confirmed onset.
constexpr int kReportsWithoutOnset = 60;

void switch_off(const Settings& settings, State& state, Report& report, Cause cause) {
  report.shed = cause == Cause::kLoss && state.relay.closed && !state.relay.opening;
  if (open(settings, state.relay, cause, report.measurement.frequency_hz)) {
    report.happened |= kRelay;
  }
}

void end_event(State& state) {
  state.phase = Phase::kCooling;
  state.steady_reports = 0;
}

// Criterion (1) of the paper: sheds if enough reports met a condition, the estimate is trusted, and
// more is required than less important outlets shed.
void decide_by_paper(const Settings& settings, State& state, Report& report) {
  report.required_mw = required_mw(state.estimator.ekf.loss_mw, settings.threshold_mw);
  report.trust = trust(settings, state.estimator);
  report.happened |= kDecision;
  if (enough_hits(state.estimator.hits, settings.condition_hits) &&
      report.trust == Trust::kTrusted && must_shed(report.required_mw, settings.accumulated_mw)) {
    switch_off(settings, state, report, Cause::kLoss);
  }
  end_event(state);
}

// Runs the paper's estimator. It runs with method 1 as well, which reports its LSE, hits and
// instant of the loss.
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

// What is required beyond doubt: a change that is not larger than this is a slow course of the
// frequency, which the model takes for lost power.
float certain_mw(const Settings& settings, float loss_sigma_mw) {
  return maximum(kMoreSigmas * loss_sigma_mw, kMorePart * settings.threshold_mw);
}

// Whether the load that the newest decision required was shed. The lost power then fell by at least
// kVisiblePart of it, at the latest before the next change; or it rose by at least kHidingPart of
// it, since a further loss hid the fall. Otherwise that load is part of what is required now.
bool was_shed(const Settings& settings, const State& state, const Followed& followed) {
  const ShedAccount& account = state.account;
  const float loss_mw = followed.state.loss_mw;
  const float least_mw =
      state.follower.decided ? loss_mw : minimum(loss_mw, state.follower.loss_before_change_mw);
  const float hidden_mw =
      maximum(certain_mw(settings, followed.loss_sigma_mw), kHidingPart * account.required_mw);
  return account.decided_loss_mw - least_mw > kVisiblePart * account.required_mw ||
         loss_mw - account.decided_loss_mw > hidden_mw;
}

// Whether the lost power is above the lower of State::least_loss_mw and its value before this
// change. Load that others shed, power that returns and slow control only lower it.
bool more_is_lost(const Settings& settings, State& state, const Followed& followed) {
  const float loss_mw = followed.state.loss_mw;
  const float least_mw = state.follower.decided
                             ? state.least_loss_mw
                             : minimum(state.least_loss_mw, state.follower.loss_before_change_mw);
  const bool more = loss_mw > least_mw + certain_mw(settings, followed.loss_sigma_mw);
  state.least_loss_mw = more ? loss_mw : minimum(least_mw, loss_mw);
  return more;
}

// Criterion (1) by the grid's state. The sum of what is required now to keep the nadir at f_s, and
// of what was shed after earlier decisions, is compared with P^A.
//
// A decision is due decision_reports after the first onset of a change, if the estimate is sure; or
// a report later, if the last reports are processed again. It is the last one of the change if no
// onset was found in that time. Otherwise power is still being lost, or the voltage was disturbed,
// and the next decision follows after as many reports, in which the shed load has become visible.
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
  if (is_behind(follower)) {
    return;
  }
  const bool sure = is_sure(settings, followed.loss_sigma_mw);
  const int due = settings.decision_reports + (sure ? 0 : kLatestReports);
  const bool is_due = follower.since_change >= due;
  const bool is_last = is_due && follower.since_onset >= due;
  if (!is_last && !(is_due && sure)) {
    return;
  }
  ShedAccount& account = state.account;
  account.shed_mw += was_shed(settings, state, followed) ? account.required_mw : 0.0f;
  account.required_mw = 0.0f;
  const bool more = more_is_lost(settings, state, followed);
  follower.changed = !is_last;
  follower.decided = true;
  follower.since_change = 0;
  const auto nominal_hz = static_cast<float>(config.hardware.nominal_hz);
  const Shedding needed = shedding(config.look_ahead, advanced(config.lead, followed.state),
                                   settings.threshold_hz + settings.nadir_margin_hz - nominal_hz);
  const float doubt_mw = sure ? 0.0f : kSureSigmas * followed.loss_sigma_mw;
  // If no more is lost, others have shed too little, or slow control moves the frequency.
  const bool is_required =
      more || needed.required_mw > certain_mw(settings, followed.loss_sigma_mw);
  const float required_mw = is_required ? maximum(needed.required_mw - doubt_mw, 0.0f) : 0.0f;
  if (!(required_mw > 0.0f) && !(is_event && is_last)) {
    return;
  }
  report.happened |= kDecision;
  report.required_mw = required_mw;
  report.nadir_hz = nominal_hz + needed.nadir_hz;
  report.shed_before_mw = account.shed_mw;
  if (required_mw > 0.0f && must_shed(account.shed_mw + required_mw, settings.accumulated_mw)) {
    switch_off(settings, state, report, Cause::kLoss);
  }
  account.required_mw = required_mw;
  account.decided_loss_mw = followed.state.loss_mw;
  if (is_last) {
    end_event(state);
  }
}

// The follower continues through an interruption of the voltage of at most kLongestGap reports.
bool bridges_gap(const GridFollower& follower) {
  return follower.count > 0 && follower.gap < kLongestGap;
}

Followed follow_grid(const Config& config, State& state, const Phasor& z) {
  const TrackerState& tracker = state.tracker;
  const bool measured = !tracker.dead && !tracker.coasting && tracker.age >= kReportsOfWindow;
  return follow(config.follower, state.follower, angle_of(z.quadrature, z.in_phase) / kTwoPi,
                root(z.in_phase * z.in_phase + z.quadrature * z.quadrature), measured,
                tracker.omega_rad_s / kTwoPi);
}

// Counts the reports since the voltage was last disturbed: the report was held, its amplitude
// changed, or its amplitude was low. The first report of a dip can pass the tracker's gate, and its
// phase error looks like a drop of the frequency.
void watch_voltage(State& state, bool valid) {
  const float change = state.tracker.last_innovation_amplitude;
  const bool steady = valid && state.tracker.amplitude > kLeastAmplitude &&
                      change > -kSteadyAmplitude && change < kSteadyAmplitude;
  state.undisturbed = static_cast<std::uint8_t>(!steady                    ? 0
                                                : state.undisturbed < 0xFF ? state.undisturbed + 1
                                                                           : 0xFF);
}

bool event_begins(const Config& config, const State& state, bool valid, const Followed& followed) {
  const bool by_state = config.settings.method == kByGridState;
  if (by_state && followed.significant &&
      state.follower.filter.x[kLoss] > state.follower.loss_before_mw) {
    return true;
  }
  return state.phase == Phase::kQuiet && valid &&
         (!by_state || state.undisturbed >= kUndisturbedReports) &&
         event_detected(config.settings, state.history);
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

// Criterion (2). It does not depend on the estimate.
void watch_switch_off_frequency(const Settings& settings, State& state, Report& report,
                                bool valid) {
  if (valid && stays_below(report.measurement.frequency_hz, settings.switch_off_hz,
                           settings.switch_off_samples, state.below_switch_off)) {
    switch_off(settings, state, report, Cause::kFrequency);
  }
}

void note_estimate(const Settings& settings, const State& state, const Followed& followed,
                   Report& report) {
  report.loss_mw = followed.state.loss_mw;
  report.loss_sigma_mw = followed.loss_sigma_mw;
  const bool sure = !is_behind(state.follower) && is_sure(settings, followed.loss_sigma_mw);
  report.trust = !state.follower.changed ? Trust::kNotYet
                 : sure                  ? Trust::kTrusted
                                         : Trust::kUncertain;
  if (state.phase == Phase::kEstimating && followed.valid) {
    report.happened |= kEstimate;
  }
}

}  // namespace

Baseline baseline(const State& state) {
  const History& history = state.history;
  if (covers_baseline(history)) {
    return baseline(history);
  }
  if (state.before_gap.frequency_hz > 0.0f) {
    return state.before_gap;
  }
  return {at(history, history.filled - 1), 0.0f};
}

void act(const Config& config, State& state, const Phasor& z, Report& report) {
  const Settings& settings = config.settings;
  const bool valid = report.measurement.validity == Validity::kValid;
  const bool by_state = settings.method == kByGridState;
  if (!by_state && state.follower.count > 0) {
    clear(state.follower);
  }
  watch_voltage(state, valid);
  switch (run(settings, state.relay, report.measurement.frequency_hz)) {
    case RelayChange::kNone:
      break;
    case RelayChange::kRestored:
      state.account = ShedAccount{};
      [[fallthrough]];
    case RelayChange::kOpened:
      report.happened |= kRelay;
  }
  if (report.measurement.validity == Validity::kInvalid &&
      !(by_state && bridges_gap(state.follower))) {
    if (state.phase == Phase::kEstimating) {
      report.happened |= kAborted;
    }
    state.phase = Phase::kQuiet;
    state.below_switch_off = 0;
    state.before_gap = Baseline{};
    clear(state.follower);
    return;
  }
  watch_switch_off_frequency(settings, state, report, valid);
  const Followed followed = by_state ? follow_grid(config, state, z) : Followed{};
  if (state.phase != Phase::kEstimating && event_begins(config, state, valid, followed)) {
    begin(state.estimator, baseline(state));
    state.phase = Phase::kEstimating;
    report.happened |= kEvent;
  }
  if (by_state) {
    note_estimate(settings, state, followed, report);
  }
  if (state.phase == Phase::kEstimating) {
    estimate(config, state, report, valid);
  } else if (state.phase == Phase::kCooling) {
    cool_down(state, report, valid);
  }
  if (by_state) {
    decide_by_grid_state(config, state, followed, report);
  }
}

}  // namespace gs::outlet
