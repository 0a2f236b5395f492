#include <algorithm>

#include <measures/catalogue.hpp>

namespace gsbench::measures {

const std::vector<Measure>& catalogue() {
  static const std::vector<Measure> all = {
      {"tracker.delay", "ms",
       "Shift of the true frequency that brings it nearest to the measured one, where it moves by "
       "more than 0.05 Hz/s.",
       "10 valid frequency measurements while the frequency moves"},
      {"tracker.error.max", "mHz",
       "Largest difference of a valid frequency from the reference at its instant: the report's, "
       "less the delay the outlet declares.",
       "10 valid frequency measurements"},
      {"tracker.error.rms", "mHz", "RMS of the same differences.",
       "10 valid frequency measurements"},
      {"tracker.bias", "mHz", "Mean of the same differences.", "10 valid frequency measurements"},
      {"tracker.rocof_error.rms", "Hz/s",
       "RMS difference of the tracker's ROCOF from the true one at its instant.",
       "10 valid frequency measurements"},
      {"validity.valid_share", "%", "Share of the reports after the first second that are valid.",
       "10 reports after the first second"},
      {"validity.dead_bus_claims", "",
       "Valid frequency reports after the voltage has been below 10 % for over 60 ms.", "nothing"},
      {"event.count", "", "Events the outlet detected in the whole run.", "nothing"},
      {"event.false", "",
       "Events before which the true frequency had not fallen by half of the least drop that makes "
       "one.",
       "the drop that the outlet was set to"},
      {"event.delay", "ms",
       "From the first loss to the first event after it, by the outlet's stamp.",
       "a loss in the profile, an event after it"},
      {"condition.hits", "",
       "Measurements that met a load-shedding condition, at the first decision.", "a decision"},
      {"lse.loss", "MW", "Lost power by the least-squares estimate of the first event, eq. (18).",
       "an event"},
      {"lse.error", "%", "The same against the power really lost by then.",
       "an event, losses in the profile"},
      {"ekf.loss", "MW", "Lost power by the EKF at the first decision.", "a decision"},
      {"ekf.error", "%", "The same against the power really lost by then.",
       "a decision, losses in the profile"},
      {"ekf.t_x_error", "ms",
       "Instant of the loss by the EKF at the first decision, less the true one.",
       "a decision, a loss in the profile"},
      {"decision.delay", "ms",
       "From the first loss to the decision on it, for or against, by the outlet's stamp.",
       "a loss in the profile, a decision after it"},
      {"decision.cause",
       "",
       "Which of the three criteria opened the relay first.",
       "nothing",
       {"none", "loss", "frequency", "command"}},
      {"relay.delay", "ms", "From the first loss to the contact's opening, by the relay sense.",
       "a loss in the profile, an opening after it"},
      {"relay.delay_reported", "ms", "The same as the outlet reports it.",
       "a loss in the profile, the outlet's report of an opening"},
      {"relay.report_difference", "ms",
       "By how much the contact's first opening, by the relay sense, is later than the outlet "
       "reports.",
       "an opening, reported and sensed"},
      {"relay.operate_time", "ms",
       "From the outlet's order to its relay to the contact's opening, by the relay sense.",
       "an opening"},
      {"relay.end",
       "",
       "Where the contact stands at the end, by the relay sense.",
       "a relay sense",
       {"closed", "open"}},
      {"relay.edges", "", "Lasting changes of the contact, bounces aside, by the relay sense.",
       "a relay sense"},
      {"relay.chatter", "", "Edges of the contact beyond one for each lasting change.",
       "a relay sense"},
      {"command.delay", "ms", "From the first command sent to the contact's change.", "a command"},
      {"trip.time", "s", "When the contact first opened, from the start of the run.", "an opening"},
      {"clock.drift", "ppm",
       "By how much the outlet's sample clock is fast, from dips of the voltage before and after "
       "the run.",
       "an outlet that counts its own samples"},
      {"clock.uncertainty", "ms",
       "How well the outlet's stamps are known on the run's time base, expanded (k = 2).",
       "an outlet that counts its own samples"},
  };
  return all;
}

const Measure* find(const std::string& name) {
  const auto found = std::find_if(catalogue().begin(), catalogue().end(),
                                  [&](const Measure& measure) { return measure.name == name; });
  return found == catalogue().end() ? nullptr : &*found;
}

}  // namespace gsbench::measures
