#include <algorithm>
#include <cmath>
#include <cstdint>

#include <judge/case.hpp>

namespace gsbench::judge {
namespace {

constexpr std::uint8_t kValid = 1;

// Time for the tracker to settle after start-up; earlier reports do not count.
constexpr double kSettle_s = 1.0;

// The bus is dead below this voltage. A valid report counts as a false claim once the bus has been
// dead for longer than the tracker's window.
constexpr double kDeadBus_pu = 0.10;
constexpr double kDeadBusStep_s = 0.002;
constexpr int kDeadBusSteps = 30;
constexpr double kTrackerWindow_s = kDeadBusSteps * kDeadBusStep_s;

constexpr double kMoving_hz_s = 0.05;
constexpr std::size_t kMostMoving = 2000;

bool bus_is_dead(const Case& c, double t_s) {
  bool dead = t_s > kTrackerWindow_s;
  for (int step = 0; dead && step <= kDeadBusSteps; ++step) {
    dead = c.reference_voltage_pu(t_s - step * kDeadBusStep_s) < kDeadBus_pu;
  }
  return dead;
}

void add_valid(Case& c, const ValidReport& report) {
  TraceSums& traces = c.traces;
  const double true_s = std::max(report.t_s - c.tracker_delay_s(), 0.0);
  traces.frequency.add(report.frequency_hz - c.reference.frequency_hz(true_s));
  traces.rocof.add(report.rocof_hz_s - c.reference.rocof_hz_s(true_s));
  if (report.t_s > kLongestDelay_s && traces.moving.size() < kMostMoving &&
      std::fabs(c.reference.rocof_hz_s(report.t_s)) > kMoving_hz_s) {
    traces.moving.push_back(report);
  }
  traces.dead_bus_claims += bus_is_dead(c, report.t_s) ? 1 : 0;
}

void add_reports(Case& c, const record::MeasurementTrace& trace) {
  for (std::size_t i = 0; i < trace.tick.size(); ++i) {
    const double t_s = c.seconds(trace.tick[i]);
    const bool valid = trace.validity[i] == kValid;
    if (valid) {
      add_valid(c, {t_s, static_cast<double>(trace.frequency_hz[i]),
                    static_cast<double>(trace.rocof_hz_s[i])});
    }
    if (t_s >= kSettle_s) {
      ++c.traces.settled;
      c.traces.settled_valid += valid ? 1 : 0;
    }
  }
}

void add_estimates(Case& c, const record::EstimateTrace& estimates) {
  const record::Mark* decision = c.first_mark("decision");
  for (std::size_t i = 0; decision != nullptr && i < estimates.tick.size(); ++i) {
    if (estimates.tick[i] <= decision->tick) {
      c.traces.loss_instant_s =
          record::loss_instant_s(estimates, i, static_cast<double>(c.plan.stimulus.sample_rate_hz));
    }
  }
}

}  // namespace

void ErrorSums::add(double error) {
  ++count;
  largest = std::max(largest, std::fabs(error));
  sum += error;
  squares += error * error;
}

double ErrorSums::mean() const {
  return sum / static_cast<double>(count);
}

double ErrorSums::rms() const {
  return std::sqrt(squares / static_cast<double>(count));
}

void Case::add(const record::Reports& piece) {
  add_reports(*this, piece.trace);
  add_estimates(*this, piece.estimates);
}

}  // namespace gsbench::judge
