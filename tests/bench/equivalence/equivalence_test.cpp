// Comparison of records whose deviations are known.
#include <cmath>

#include <gtest/gtest.h>

#include <equivalence/equivalence.hpp>
#include <profile/load.hpp>
#include <waveform/reference_signal.hpp>

namespace gsbench::test {
namespace {

constexpr double kTrackerDelay_s = 0.028;
constexpr double kVoltageDelay_s = 0.010;

profile::Plan plan() {
  return profile::load_profile("regression/equivalence");
}

// An outlet that reports the profile's frequency and amplitude, shifted.
record::RunRecord run(const std::string& station, double shift_mhz, double shift_pct) {
  const profile::Plan planned = plan();
  const auto reference = planned.reference();
  const waveform::Synthesizer synthesizer = planned.synthesizer();
  record::RunRecord run;
  run.station = station;
  record::OutletRecord& outlet = run.outlets.emplace_back();
  outlet.id = station + "-1";
  outlet.settings = {{"tracker_delay_s", kTrackerDelay_s}, {"voltage_delay_s", kVoltageDelay_s}};
  for (std::int64_t tick = 128; tick < planned.duration_ticks(); tick += 128) {
    const double t_s = static_cast<double>(tick) / 8000.0;
    const auto at_s = [&](double delay_s) { return std::fmax(t_s - delay_s, 0.0); };
    outlet.reports.trace.tick.push_back(tick);
    outlet.reports.trace.validity.push_back(1);
    outlet.reports.trace.rocof_hz_s.push_back(0.0F);
    outlet.reports.trace.frequency_hz.push_back(
        static_cast<float>(reference->frequency_hz(at_s(kTrackerDelay_s)) + 1e-3 * shift_mhz));
    outlet.reports.trace.voltage_pu.push_back(static_cast<float>(
        synthesizer.amplitude_pu(std::llround(8000.0 * at_s(kVoltageDelay_s))) + 0.01 * shift_pct));
  }
  return run;
}

TEST(Equivalence, MeasuresFromTheReferenceAndFromTheFirstOutlet) {
  const auto rows =
      equivalence::compare(plan(), {run("first", 1.0, 0.0), run("second", 4.0, -0.5)});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].run, 1U);
  EXPECT_EQ(rows[1].outlet, "second-1");
  // Reports are floats: 4 µHz.
  EXPECT_NEAR(rows[0].frequency_mhz.rms, 1.0, 0.005);
  EXPECT_NEAR(rows[0].from_first_mhz.largest, 0.0, 0.005);
  EXPECT_NEAR(rows[1].frequency_mhz.largest, 4.0, 0.005);
  EXPECT_NEAR(rows[1].from_first_mhz.rms, 3.0, 0.005);
  EXPECT_NEAR(rows[0].voltage_pct.largest, 0.0, 1e-4);
  EXPECT_NEAR(rows[1].voltage_pct.rms, 0.5, 1e-4);
  EXPECT_NEAR(rows[1].voltage_pct.largest, 0.5, 1e-4);
}

TEST(Equivalence, TakesOffTheDriftOfTheOutletsClock) {
  // A crystal that is 40 ppm fast measures a frequency that is 40 ppm, 2 mHz, too low.
  record::RunRecord fast = run("fast", -2.0, 0.0);
  fast.outlets[0].clock.drift_ppm = 40.0;
  const auto rows = equivalence::compare(plan(), {run("first", 0.0, 0.0), fast});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_LT(rows[1].frequency_mhz.largest, 0.03);
  EXPECT_LT(rows[1].from_first_mhz.largest, 0.03);
}

TEST(Equivalence, CountsValidReportsOnly) {
  record::RunRecord mixed = run("mixed", 0.0, 0.0);
  record::MeasurementTrace& trace = mixed.outlets[0].reports.trace;
  trace.validity[300] = 0;
  trace.frequency_hz[300] = NAN;
  const auto rows = equivalence::compare(plan(), {mixed});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_LT(rows[0].frequency_mhz.largest, 0.005);
}

TEST(Equivalence, LeavesOutOutletsWithoutReports) {
  record::RunRecord silent = run("silent", 0.0, 0.0);
  silent.outlets[0].reports.trace = {};
  EXPECT_TRUE(equivalence::compare(plan(), {silent}).empty());
}

}  // namespace
}  // namespace gsbench::test
