// Shows that each limit can fail: a record passes, and a mutant of it fails.

#include "synthetic_case.hpp"

#include <limits>
#include <optional>
#include <set>

#include <gtest/gtest.h>

namespace gsbench::judge::test {
namespace {

struct Mutant {
  const char* measure;
  std::optional<double> min;
  std::optional<double> max;
  Change spoil;
  const char* equals = nullptr;
  bool of_command = false;  // true: the record with a command; false: the one with a loss
};

Change moved(const char* kind, std::int64_t by_ticks) {
  return [=](SyntheticCase& c) { c.move_marks(kind, by_ticks); };
}

Change with_value(const char* kind, double value) {
  return [=](SyntheticCase& c) { c.set_marks(kind, value); };
}

Change mark_added(std::int64_t tick, const char* kind, double value) {
  return [=](SyntheticCase& c) { c.add_mark(tick, kind, value); };
}

Change frequencies_moved(float by_hz) {
  return [=](SyntheticCase& c) {
    for (float& frequency_hz : c.outlet.reports.trace.frequency_hz) {
      frequency_hz += by_hz;
    }
  };
}

void one_wild_report(SyntheticCase& c) {
  c.outlet.reports.trace.frequency_hz[100] += 0.05F;
}

void wild_rocof(SyntheticCase& c) {
  for (float& rocof_hz_s : c.outlet.reports.trace.rocof_hz_s) {
    rocof_hz_s *= 3.0F;
  }
}

// Reports what it measured 50 ms earlier.
void late_tracker(SyntheticCase& c) {
  for (std::int64_t& tick : c.outlet.reports.trace.tick) {
    tick += 50;
  }
}

void half_invalid(SyntheticCase& c) {
  for (std::size_t i = 0; i < c.outlet.reports.trace.validity.size(); i += 2) {
    c.outlet.reports.trace.validity[i] = 0;
  }
}

void dead_bus(SyntheticCase& c) {
  c.plan.stimulus.signal.amplitude_steps = {{2.0, 1.0, 0.0}};
}

void wrong_instant(SyntheticCase& c) {
  c.outlet.reports.estimates.loss_after_event_s[1] = 3.1F;
}

void bounces(SyntheticCase& c) {
  c.add_mark(3929, "relay.sense", 1.0);
  c.add_mark(3930, "relay.sense", 0.0);
}

const std::vector<Mutant>& mutants() {
  static const std::vector<Mutant> all = {
      {"tracker.delay", 0.0, 40.0, late_tracker},
      {"tracker.error.max", 0.5, 10.0, one_wild_report},
      {"tracker.error.rms", 0.5, 4.0, frequencies_moved(0.01F)},
      {"tracker.bias", -2.0, 2.0, frequencies_moved(-0.01F)},
      {"tracker.rocof_error.rms", {}, 0.2, wild_rocof},
      {"validity.valid_share", 98.0, {}, half_invalid},
      {"validity.dead_bus_claims", {}, 0.0, dead_bus},
      {"event.count", 1.0, 1.0, mark_added(5000, "event", 49.6)},
      {"event.count", 1.0, 1.0, [](SyntheticCase& c) { c.remove_marks("event"); }},
      {"event.false", {}, 0.0, mark_added(1000, "event", 50.0)},
      {"event.delay", 30.0, 160.0, moved("event", 41)},
      {"event.delay", 30.0, 160.0, moved("event", -91)},
      {"condition.hits", 16.0, {}, with_value("decision.hits", 15.0)},
      {"lse.loss", 200.0, 700.0, with_value("lse", 199.0)},
      {"lse.error", -60.0, 40.0, with_value("lse", 701.0)},
      {"ekf.loss", 480.0, 520.0, with_value("decision.loss", 521.0)},
      {"ekf.error", -4.0, 4.0, with_value("decision.loss", 479.0)},
      {"ekf.t_x_error", -40.0, 40.0, wrong_instant},
      {"decision.delay", 200.0, 960.0, moved("decision", 41)},
      {"decision.trust",
       {},
       {},
       [](SyntheticCase& c) {
         c.remove_marks("decision.trust");
         c.add_mark(3920, "decision.trust", 0.0, "too uncertain");
       },
       "trusted"},
      {"decision.cause",
       {},
       {},
       [](SyntheticCase& c) { c.remove_marks("relay.reported"); },
       "loss"},
      {"relay.delay", {}, 960.0, moved("relay.sense", 33)},
      {"relay.delay_reported", {}, 960.0, moved("relay.reported", 41)},
      {"relay.report_difference", -20.0, 20.0, moved("relay.reported", -13)},
      {"relay.operate_time", 0.1, 20.0, moved("relay.sense", -9)},
      {"relay.end", {}, {}, mark_added(5000, "relay.sense", 1.0), "open"},
      {"relay.edges", 1.0, 1.0, mark_added(5000, "relay.sense", 1.0)},
      {"relay.chatter", {}, 0.0, bounces},
      {"command.delay", {}, 50.0, moved("relay.sense", 40), nullptr, true},
      {"trip.time", 3.0, 4.0, moved("relay.sense", 1000)},
      {"relay.operate_hz", 49.61, 49.64, moved("relay.sense", 60)},
      {"clock.drift", -100.0, 100.0, [](SyntheticCase& c) { c.outlet.clock.drift_ppm = 109.0; }},
      {"clock.uncertainty", {}, 0.5, [](SyntheticCase& c) { c.outlet.clock.uncertainty_ms = 0.6; }},
  };
  return all;
}

TEST(Mutants, FailAlthoughTheOriginalRecordPasses) {
  for (const Mutant& mutant : mutants()) {
    SyntheticCase c = mutant.of_command ? commanded() : loss_of_500_mw();
    profile::Expectation expectation = limits(mutant.measure, mutant.min, mutant.max);
    if (mutant.equals != nullptr) {
      expectation.equals = mutant.equals;
    }
    EXPECT_EQ(verdict(c, expectation), record::Verdict::kPass) << mutant.measure;
    mutant.spoil(c);
    EXPECT_EQ(c.read(mutant.measure).missing, "") << mutant.measure << " must fail by its value";
    EXPECT_EQ(verdict(c, expectation), record::Verdict::kFail) << mutant.measure;
  }
}

TEST(Mutants, ExistForEveryMeasureOfTheCatalogue) {
  std::set<std::string> spoiled;
  for (const Mutant& mutant : mutants()) {
    spoiled.insert(mutant.measure);
  }
  for (const measures::Measure& measure : measures::catalogue()) {
    EXPECT_EQ(spoiled.count(measure.name), 1U) << measure.name;
  }
}

// A valid report must contain numbers: otherwise the outlet fails in every measure that reads them.
TEST(Mutants, NaNInAValidReportFailsEveryMeasureThatReadsIt) {
  SyntheticCase c = loss_of_500_mw();
  c.outlet.reports.trace.frequency_hz[200] = std::numeric_limits<float>::quiet_NaN();
  c.outlet.reports.trace.rocof_hz_s[200] = std::numeric_limits<float>::infinity();
  for (const char* name : {"tracker.delay", "tracker.error.max", "tracker.error.rms",
                           "tracker.bias", "tracker.rocof_error.rms"}) {
    EXPECT_EQ(verdict(c, limits(name, {}, 1e300)), record::Verdict::kFail) << name;
  }
}

}  // namespace
}  // namespace gsbench::judge::test
