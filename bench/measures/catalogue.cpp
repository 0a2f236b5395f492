#include <algorithm>

#include <measures/catalogue.hpp>

namespace gsbench::measures {
namespace {

constexpr bool kByContact = false;  // needs_link

}  // namespace

const std::vector<Measure>& catalogue() {
  static const std::vector<Measure> all = {
      {"tracker.delay", "ms",
       "Time shift at which the reported frequency fits the reference best (least RMS error). "
       "Of the reports during which the reference moves faster than 0.05 Hz/s, the first 2000 "
       "count.",
       "10 valid reports while the reference moves faster than 0.05 Hz/s"},
      {"tracker.error.max", "mHz",
       "Largest absolute error of the valid reported frequencies. "
       "The reference is taken at the time stamp minus the delay that the outlet declares.",
       "10 valid reports"},
      {"tracker.error.rms", "mHz",
       "RMS error of the valid reported frequencies. "
       "The reference is taken at the time stamp minus the delay that the outlet declares.",
       "10 valid reports"},
      {"tracker.bias", "mHz",
       "Mean error of the valid reported frequencies. "
       "The reference is taken at the time stamp minus the delay that the outlet declares.",
       "10 valid reports"},
      {"tracker.rocof_error.rms", "Hz/s",
       "RMS error of the valid reported ROCOF. "
       "The reference is taken at the time stamp minus the delay that the outlet declares.",
       "10 valid reports"},
      {"validity.valid_share", "%",
       "Share of valid reports among all reports after the first second.",
       "10 reports after the first second"},
      {"validity.dead_bus_claims", "",
       "Reports marked valid although the voltage had been below 10 % of nominal for more than 60 "
       "ms.",
       "nothing"},
      {"event.count", "", "Frequency events that the outlet detected during the run.", "nothing"},
      {"event.false", "",
       "Detected events for which the reference did not fall by at least half of event_drop_hz. "
       "The fall is measured over the 0.5 s that end at the time stamp minus the declared delay.",
       "the outlet's setting event_drop_hz"},
      {"event.delay", "ms",
       "Time from the first loss to the first event after it, by the outlet's time stamp.",
       "a loss in the profile and an event after it"},
      {"condition.hits", "",
       "Measurements that met a load-shedding condition, as reported with the first decision.",
       "a decision"},
      {"lse.loss", "MW",
       "Lost power of the first least-squares estimate (LSE), eq. (18), after the first event.",
       "a least-squares estimate, which follows an event"},
      {"lse.error", "%",
       "Relative error of the first least-squares estimate (LSE). "
       "The reference is the power lost in the profile up to that estimate.",
       "a least-squares estimate, which follows an event, and a loss in the profile before it"},
      {"ekf.loss", "MW",
       "Estimate of the lost power (ΔP) at the first decision, from the loss on if the profile has "
       "one.",
       "a decision"},
      {"ekf.error", "%",
       "Relative error of the estimated lost power (ΔP) at the first decision after the loss. "
       "The reference is the power lost in the profile up to that decision and, by the grid's "
       "state, what was lost before at frequency_before_hz.",
       "a loss in the profile and a decision after it"},
      {"ekf.t_x_error", "ms",
       "Error of t_x, the instant of the loss, as estimated by the EKF at the first decision. "
       "Positive if t_x is later than the first loss in the profile.",
       "a loss in the profile and a decision"},
      {"decision.delay", "ms",
       "Time from the first loss to the next decision, to shed or not, by the outlet's time stamp.",
       "a loss in the profile and a decision after it"},
      {"decision.trust",
       "",
       "Whether the outlet trusted its estimate of the lost power at the first decision, from the "
       "loss on if the profile has one, or why not, as reported by the outlet.",
       "a decision",
       {"trusted", "not yet estimated", "frequency not steady before the event",
        "measurements do not follow the model", "estimate at a physical bound", "too uncertain"}},
      {"decision.cause",
       "",
       "Criterion that first opened the relay, as reported by the outlet.",
       "nothing",
       {"none", "loss", "frequency", "command"}},
      {"relay.delay",
       "ms",
       "Time from the first loss to the opening of the relay contact, by the relay sense.",
       "a loss in the profile and an opening after it",
       {},
       kByContact},
      {"relay.delay_reported", "ms",
       "Time from the first loss to the outlet's command to open its relay, as reported by the "
       "outlet.",
       "a loss in the profile and a reported command to open after it"},
      {"relay.report_difference", "ms",
       "Time from the reported command to open to the opening of the contact, by the relay sense. "
       "The first of each from the first loss on count; without a loss, of the whole run.",
       "a reported command to open and a sensed opening"},
      {"relay.operate_time", "ms",
       "Time from the reported command to open to the opening of the contact, by the relay sense. "
       "The first command and the first opening of the run count.",
       "a reported command to open and a sensed opening"},
      {"relay.end",
       "",
       "Position of the relay contact at the end of the run, by the relay sense.",
       "a relay sense",
       {"closed", "open"},
       kByContact},
      {"relay.edges",
       "",
       "Number of lasting changes of the relay contact, by the relay sense; bounces are not "
       "counted.",
       "a relay sense",
       {},
       kByContact},
      {"relay.chatter",
       "",
       "Number of extra edges of the relay contact (bounces), by the relay sense: all edges minus "
       "one for each lasting change.",
       "a relay sense",
       {},
       kByContact},
      {"command.delay", "ms",
       "Time from the first command to the first change of the contact in the commanded direction, "
       "by the relay sense.",
       "a command in the profile and a change of the contact in its direction after it"},
      {"trip.time",
       "s",
       "Time from the start of the run to the first opening of the contact, by the relay sense.",
       "an opening",
       {},
       kByContact},
      {"relay.operate_hz",
       "Hz",
       "Frequency of the reference when the contact first opens, by the relay sense. "
       "It is below the pick-up value of a relay by what the frequency falls during its delay.",
       "an opening",
       {},
       kByContact},
      {"clock.drift", "ppm",
       "Rate error of the outlet's sample clock; positive if it runs fast. "
       "It is measured from dips of the voltage before and after the run.",
       "an outlet with a sample clock of its own"},
      {"clock.uncertainty", "ms",
       "Expanded uncertainty (k = 2) of the outlet's time stamps on the time base of the run.",
       "an outlet with a sample clock of its own"},
  };
  return all;
}

std::vector<std::string> measured_by_contact() {
  std::vector<std::string> names;
  for (const Measure& measure : catalogue()) {
    if (!measure.needs_link) {
      names.push_back(measure.name);
    }
  }
  return names;
}

const Measure* find(const std::string& name) {
  const auto found = std::find_if(catalogue().begin(), catalogue().end(),
                                  [&](const Measure& measure) { return measure.name == name; });
  return found == catalogue().end() ? nullptr : &*found;
}

}  // namespace gsbench::measures
