#include <algorithm>

#include <judge/reading.hpp>
#include <outlet/settings.hpp>

namespace gsbench::judge {
namespace {

constexpr const char* kNoLse = "the outlet reported no least-squares estimate (LSE)";
constexpr const char* kNoDecision = "the outlet reported no decision";

Reading loss_of(const record::Mark* mark, const char* reason) {
  return mark == nullptr ? not_done(reason) : number(mark->value);
}

// before_mw is the part of the estimate that was lost before the profile.
Reading relative_error(const Case& c, const record::Mark* mark, const char* reason,
                       double before_mw) {
  if (mark == nullptr) {
    return not_done(reason);
  }
  const double lost_mw = c.lost_mw(mark->tick);
  if (!(lost_mw > 0.0)) {
    return not_known("the profile contains no loss of power before the estimate");
  }
  return number(100.0 * (mark->value - before_mw - lost_mw) / lost_mw);
}

// Of the first decision after the loss; of the first one at all if the profile has no loss.
const record::Mark* of_decision(const Case& c, const char* kind) {
  return c.first_mark(kind, std::max<std::int64_t>(c.first_loss_tick().value_or(0), 0));
}

const record::Mark* decided_loss(const Case& c) {
  return of_decision(c, "decision.loss");
}

Reading lse_error(const Case& c) {
  return relative_error(c, c.first_mark("lse"), kNoLse, 0.0);
}

// By the grid's state, ΔP includes the power that was lost before the profile.
Reading ekf_error(const Case& c) {
  const auto method = c.outlet.settings.find("method");
  const bool all = method != c.outlet.settings.end() && method->second == gs::outlet::kByGridState;
  return relative_error(c, decided_loss(c), kNoDecision, all ? c.lost_before_mw() : 0.0);
}

Reading t_x_error(const Case& c, std::int64_t loss_tick) {
  if (c.first_mark("decision") == nullptr) {
    return not_done(kNoDecision);
  }
  if (!c.traces.loss_instant_s) {
    return not_done("the outlet reported no EKF estimate before its decision");
  }
  const double error_s = *c.traces.loss_instant_s - c.seconds(loss_tick);
  return number(1e3 * error_s, c.outlet.clock.uncertainty_ms);
}

Reading decision_delay(const Case& c, std::int64_t loss_tick) {
  return stamped_after(c, loss_tick, c.first_mark("decision", loss_tick),
                       "the outlet reported no decision after the loss");
}

Reading decision_trust(const Case& c) {
  const record::Mark* trust = of_decision(c, "decision.trust");
  return trust == nullptr ? not_done(kNoDecision) : text(trust->text);
}

Reading decision_cause(const Case& c) {
  const record::Mark* opened = c.first_reported_opening();
  return text(opened == nullptr ? "none" : opened->text);
}

}  // namespace

Readings estimate_readings() {
  return {
      {"lse.loss", [](const Case& c) { return loss_of(c.first_mark("lse"), kNoLse); }},
      {"lse.error", lse_error},
      {"ekf.loss", [](const Case& c) { return loss_of(decided_loss(c), kNoDecision); }},
      {"ekf.error", ekf_error},
      {"ekf.t_x_error", after_loss<t_x_error>},
      {"decision.delay", after_loss<decision_delay>},
      {"decision.trust", decision_trust},
      {"decision.cause", decision_cause},
  };
}

}  // namespace gsbench::judge
