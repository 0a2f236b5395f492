#include "synthetic_case.hpp"

#include <algorithm>
#include <limits>

#include <measures/catalogue.hpp>

namespace gsbench::judge::test {
namespace {

constexpr std::int64_t kReportTicks = 16;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

void add_report(SyntheticCase& c, std::int64_t tick, bool valid, int sign) {
  constexpr double kDelay_s = 0.028;
  const double t_s = 1e-3 * static_cast<double>(tick) - kDelay_s;
  record::MeasurementTrace& trace = c.outlet.reports.trace;
  trace.tick.push_back(tick);
  trace.voltage_pu.push_back(1.0F);
  trace.validity.push_back(valid ? 1 : 0);
  trace.frequency_hz.push_back(
      valid ? static_cast<float>(c.reference->frequency_hz(t_s) + 1e-3 + 2e-3 * sign) : kNaN);
  trace.rocof_hz_s.push_back(valid ? static_cast<float>(c.reference->rocof_hz_s(t_s) + 0.1 * sign)
                                   : kNaN);
}

void add_reports(SyntheticCase& c) {
  int sign = 1;
  for (std::int64_t report = 1; report * kReportTicks < 6000; ++report) {
    const bool valid = report >= 7 && !(report >= 70 && report < 74);
    add_report(c, report * kReportTicks, valid, sign);
    sign = valid ? -sign : sign;
  }
}

SyntheticCase quiet(double falls_from_s) {
  SyntheticCase c;
  c.plan.stimulus.sample_rate_hz = 1000;
  c.plan.stimulus.duration_s = 6.0;
  c.reference = std::make_shared<FallingReference>(falls_from_s);
  c.outlet.id = "outlet-1";
  c.outlet.group = "all";
  c.outlet.took_part = true;
  c.outlet.link = "simulated";
  c.outlet.settings = {{"tracker_delay_s", 0.028}, {"event_drop_hz", 0.020}};
  // 0.3 and 0.4 combine to 0.5, so a test can distinguish one uncertainty from two combined.
  c.uncertainty.relay_sense_ms = 0.3;
  c.uncertainty.command_ms = 0.6;
  c.uncertainty.frequency_mhz = 0.1;
  c.outlet.clock = {30.0, 8.0, 0.4};
  add_reports(c);
  return c;
}

}  // namespace

Case SyntheticCase::view() const {
  Case c{plan, *reference, outlet, uncertainty};
  c.add(outlet.reports);
  return c;
}

double FallingReference::frequency_hz(double t_s) const {
  return 50.0 - 0.4 * std::clamp(t_s - from_s_, 0.0, 1.0);
}

double FallingReference::rocof_hz_s(double t_s) const {
  return t_s >= from_s_ && t_s < from_s_ + 1.0 ? -0.4 : 0.0;
}

void SyntheticCase::add_mark(std::int64_t tick, const std::string& kind, double value,
                             const std::string& text) {
  const auto after = std::find_if(outlet.reports.marks.begin(), outlet.reports.marks.end(),
                                  [&](const record::Mark& mark) { return mark.tick > tick; });
  outlet.reports.marks.insert(after, {tick, kind, value, text});
}

void SyntheticCase::remove_marks(const std::string& kind) {
  outlet.reports.marks.erase(
      std::remove_if(outlet.reports.marks.begin(), outlet.reports.marks.end(),
                     [&](const record::Mark& mark) { return mark.kind == kind; }),
      outlet.reports.marks.end());
}

void SyntheticCase::move_marks(const std::string& kind, std::int64_t by_ticks) {
  for (record::Mark& mark : outlet.reports.marks) {
    if (mark.kind == kind) {
      mark.tick += by_ticks;
    }
  }
  std::stable_sort(outlet.reports.marks.begin(), outlet.reports.marks.end(),
                   [](const record::Mark& a, const record::Mark& b) { return a.tick < b.tick; });
}

void SyntheticCase::set_marks(const std::string& kind, double value) {
  for (record::Mark& mark : outlet.reports.marks) {
    if (mark.kind == kind) {
      mark.value = value;
    }
  }
}

void SyntheticCase::cut_trace(std::size_t reports) {
  record::MeasurementTrace& trace = outlet.reports.trace;
  trace.tick.resize(reports);
  trace.frequency_hz.resize(reports);
  trace.rocof_hz_s.resize(reports);
  trace.voltage_pu.resize(reports);
  trace.validity.resize(reports);
}

SyntheticCase loss_of_500_mw() {
  SyntheticCase c = quiet(3.0);
  c.plan.stimulus.losses = {{3.0, 500.0}};
  c.add_mark(3120, "event", 50.0);
  c.add_mark(3280, "lse", 450.0, "MW");
  c.add_mark(3920, "decision", 163.0, "shed");
  c.add_mark(3920, "decision.loss", 515.0, "MW");
  c.add_mark(3920, "decision.hits", 30.0);
  c.add_mark(3920, "decision.trust", 1.0, "trusted");
  c.add_mark(3920, "relay.reported", 0.0, "loss");
  c.add_mark(3928, "relay.sense", 0.0, "open");
  // The measures use the last estimate up to the decision, not the last one of the run.
  c.outlet.reports.estimates.tick = {3296, 3920, 3936};
  c.outlet.reports.estimates.loss_mw = {460.0F, 515.0F, 516.0F};
  c.outlet.reports.estimates.loss_sigma_mw = {80.0F, 8.0F, 8.0F};
  c.outlet.reports.estimates.event_tick = {0, 0, 0};
  c.outlet.reports.estimates.loss_after_event_s = {2.95F, 3.010F, 3.2F};
  c.outlet.reports.estimates.trusted = {0, 1, 1};
  return c;
}

SyntheticCase commanded() {
  SyntheticCase c = quiet(1e9);
  c.add_mark(2000, "command", 0.0, "switch off");
  c.add_mark(2005, "relay.reported", 0.0, "command");
  c.add_mark(2012, "relay.sense", 0.0, "open");
  return c;
}

profile::Expectation limits(const std::string& measure, std::optional<double> min,
                            std::optional<double> max, const char* unit) {
  const measures::Measure* known = measures::find(measure);
  profile::Expectation expectation;
  expectation.measure = measure;
  expectation.unit = unit != nullptr ? unit : known != nullptr ? known->unit : "";
  expectation.min = min;
  expectation.max = max;
  return expectation;
}

record::Verdict verdict(SyntheticCase c, const profile::Expectation& expectation) {
  c.plan.expectations = {expectation};
  judge_outlet(c.view(), c.outlet);
  return c.outlet.verdict;
}

}  // namespace gsbench::judge::test
