// Phase steps, dips, interruptions and a dead bus must not be measured as a change of frequency.
#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <outlet/arithmetic.hpp>

namespace gs::outlet {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

using gsbench::waveform::SignalSpec;

struct Course {
  int held = 0;
  int invalid = 0;
  int events = 0;
  bool tripped = false;
  double largest_error_mhz = 0.0;  // of valid measurements
  double last_bad_s = 0.0;  // last report worse than 20 mHz or not valid, after the disturbance
};

// 20 mHz are eight standard deviations of a measurement in 1 % noise.
constexpr double kGood_mhz = 20.0;

Course course_of(const test::MainsSpec& spec, double disturbance_s) {
  Course course;
  for (const Report& report : test::reports_of(spec, 2.5, test::ieee24_settings())) {
    const double t_s = test::report_s(report) - disturbance_s;
    if (t_s < -0.1) {
      continue;
    }
    course.tripped = course.tripped || !report.relay_closed;
    course.events += (report.happened & kEvent) != 0 ? 1 : 0;
    bool good = false;
    switch (report.measurement.validity) {
      case Validity::kInvalid:
        ++course.invalid;
        EXPECT_TRUE(std::isnan(report.measurement.frequency_hz));
        EXPECT_TRUE(std::isnan(report.measurement.rocof_hz_s));
        break;
      case Validity::kHeld:
        ++course.held;
        EXPECT_TRUE(std::isfinite(report.measurement.frequency_hz));
        break;
      case Validity::kValid: {
        const double error_mhz =
            1e3 * std::abs(static_cast<double>(report.measurement.frequency_hz) -
                           spec.reference->frequency_hz(test::measured_s(report)));
        course.largest_error_mhz = std::max(course.largest_error_mhz, error_mhz);
        good = error_mhz <= kGood_mhz;
        break;
      }
    }
    EXPECT_TRUE(std::isfinite(report.measurement.voltage_pu));
    if (!good) {
      course.last_bad_s = std::max(course.last_bad_s, t_s);
    }
  }
  return course;
}

// The worst over several points on wave and seeds.
Course worst_course(const std::function<void(SignalSpec&, double)>& disturb) {
  Course worst;
  for (int i = 0; i < 10; ++i) {
    const double disturbance_s = 1.0 + 0.00137 * i;
    test::MainsSpec spec = {test::steady(50.0, 50.0), {}, 1.0, static_cast<std::uint64_t>(i) + 1};
    disturb(spec.signal, disturbance_s);
    const Course course = course_of(spec, disturbance_s);
    worst.held = std::max(worst.held, course.held);
    worst.invalid = std::max(worst.invalid, course.invalid);
    worst.events += course.events;
    worst.tripped = worst.tripped || course.tripped;
    worst.largest_error_mhz = std::max(worst.largest_error_mhz, course.largest_error_mhz);
    worst.last_bad_s = std::max(worst.last_bad_s, course.last_bad_s);
  }
  return worst;
}

// The filter's 56 ms spread a step of 4° over several reports, at most 2° each. This is more than
// twice innovation_gate_rad.
TEST(TrackerDisturbance, CoastsOverPhaseStepsOfFourDegreesAndMore) {
  for (const double degrees : {-60.0, -20.0, -10.0, -4.0, 4.0, 10.0, 20.0, 60.0}) {
    const Course course = worst_course([&](SignalSpec& signal, double at_s) {
      signal.phase_jumps = {{at_s, degrees}};
    });
    EXPECT_FALSE(course.tripped) << degrees;
    EXPECT_EQ(course.invalid, 0) << degrees;
    EXPECT_GE(course.held, 3) << degrees;
    EXPECT_LE(course.held, 8) << degrees;
    // Without the gate, a step of 4° would read as 0.1 Hz or more.
    EXPECT_LT(course.largest_error_mhz, 60.0) << degrees;
    EXPECT_LT(course.last_bad_s, 0.3) << degrees;
  }
}

// Smaller steps are within the gate, like changes of a grid. They appear as a swing of the
// frequency, which may look like an event but must not trip.
TEST(TrackerDisturbance, SmallerPhaseStepsDisturbTheFrequencyButDoNotTrip) {
  for (const double degrees : {-2.0, -1.0, 1.0, 2.0}) {
    const Course course = worst_course([&](SignalSpec& signal, double at_s) {
      signal.phase_jumps = {{at_s, degrees}};
    });
    EXPECT_FALSE(course.tripped) << degrees;
    EXPECT_LT(course.largest_error_mhz, 60.0 * std::abs(degrees)) << degrees;
    EXPECT_LT(course.last_bad_s, 0.4) << degrees;
  }
}

// A fault in the network and its clearing: the voltage dips with a phase step, and both return
// when the fault is cleared, before the tracker has recovered from the onset.
TEST(TrackerDisturbance, DoesNotTripOnAFaultAndItsClearing) {
  for (const double level_pct : {5.0, 12.0, 40.0, 70.0}) {
    for (const double degrees : {-60.0, -20.0, 20.0, 60.0}) {
      for (const double duration_s : {0.06, 0.1, 0.15, 0.2}) {
        const Course course = worst_course([&](SignalSpec& signal, double at_s) {
          signal.amplitude_steps = {{at_s, duration_s, level_pct}};
          signal.phase_jumps = {{at_s, degrees}, {at_s + duration_s, -degrees}};
        });
        EXPECT_FALSE(course.tripped) << level_pct << " % " << degrees << "° " << duration_s;
        EXPECT_LT(course.last_bad_s, duration_s + 0.6)
            << level_pct << " % " << degrees << "° " << duration_s;
      }
    }
  }
}

TEST(TrackerDisturbance, DoesNotTripOnTwoPhaseStepsInTheSameDirection) {
  for (const double degrees : {-180.0, -60.0, -20.0, 20.0, 60.0}) {
    for (const double apart_s : {0.03, 0.06, 0.1, 0.15, 0.2}) {
      const Course course = worst_course([&](SignalSpec& signal, double at_s) {
        signal.phase_jumps = {{at_s, degrees}, {at_s + apart_s, degrees}};
      });
      EXPECT_FALSE(course.tripped) << degrees << "° " << apart_s;
      EXPECT_LT(course.last_bad_s, apart_s + 0.7) << degrees << "° " << apart_s;
    }
  }
}

// Test pattern after IEC 61000-4-11, without phase steps.
TEST(TrackerDisturbance, DoesNotTripOnDips) {
  struct Dip {
    double level_pct;
    double duration_s;
  };
  for (const Dip dip : {Dip{0.0, 0.01}, Dip{0.0, 0.02}, Dip{12.0, 0.5}, Dip{40.0, 0.2},
                        Dip{70.0, 0.5}, Dip{80.0, 1.0}}) {
    const Course course = worst_course([&](SignalSpec& signal, double at_s) {
      signal.amplitude_steps = {{at_s, dip.duration_s, dip.level_pct}};
    });
    EXPECT_FALSE(course.tripped) << dip.level_pct;
    // At 12 % voltage the relative noise is eight times higher.
    EXPECT_LT(course.largest_error_mhz, dip.level_pct == 12.0 ? 300.0 : 150.0) << dip.level_pct;
    EXPECT_LT(course.last_bad_s, dip.duration_s + 0.4) << dip.level_pct;
  }
}

TEST(TrackerDisturbance, MeasuresThroughAmplitudeStepsOfTenPerCent) {
  for (const double level_pct : {90.0, 110.0}) {
    const Course course = worst_course([&](SignalSpec& signal, double at_s) {
      signal.amplitude_steps = {{at_s, kForever, level_pct}};
    });
    EXPECT_LT(course.largest_error_mhz, kGood_mhz) << level_pct;
    EXPECT_EQ(course.events, 0);
    EXPECT_EQ(course.invalid, 0);
  }
}

TEST(TrackerDisturbance, ReportsNoFrequencyOnADeadBusAndReacquiresItAfterwards) {
  for (const double level_pct : {0.0, 5.0}) {
    for (int i = 0; i < 10; ++i) {
      const double dead_s = 1.0 + 0.00137 * i;
      const double alive_s = dead_s + 1.0;
      test::MainsSpec spec = {test::ramp(50.0, 49.0, alive_s + 0.5, -0.5), {}, 1.0};
      spec.seed = static_cast<std::uint64_t>(i) + 1;
      spec.signal.amplitude_steps = {{dead_s, alive_s - dead_s, level_pct}};
      for (const Report& report : test::reports_of(spec, 4.0, test::ieee24_settings())) {
        const double t_s = test::report_s(report);
        // The front end's window is 56 ms; the report comes at most 16 ms later.
        if (t_s > dead_s + 0.072 && t_s <= alive_s) {
          ASSERT_EQ(report.measurement.validity, Validity::kInvalid) << t_s;
          ASSERT_TRUE(std::isnan(report.measurement.frequency_hz));
          ASSERT_NEAR(static_cast<double>(report.measurement.voltage_pu), 0.01 * level_pct, 0.02);
        }
        // 56 ms to fill the filter, 16 reports to settle, up to three restarts while it fills.
        if (t_s > alive_s + 0.056 + 19 * 0.016) {
          ASSERT_EQ(report.measurement.validity, Validity::kValid) << t_s;
          ASSERT_NEAR(static_cast<double>(report.measurement.frequency_hz),
                      spec.reference->frequency_hz(test::measured_s(report)), 0.03)
              << t_s;
        }
      }
    }
  }
}

TEST(TrackerDisturbance, FollowsRampsOfTenHertzPerSecond) {
  for (const double hz_per_s : {-10.0, -5.0, -1.0, 1.0, 10.0}) {
    const double turn_hz = hz_per_s < 0.0 ? 45.5 : 54.5;
    const test::MainsSpec spec = {test::ramp(50.0, turn_hz, 1.0, hz_per_s), {}, 1.0};
    const double end_s = 1.0 + (turn_hz - 50.0) / hz_per_s;
    int on_the_ramp = 0;
    for (const Report& report : test::reports_of(spec, end_s + 1.0, test::ieee24_settings())) {
      const double t_s = test::measured_s(report);
      if (report.number < 40 || report.measurement.validity != Validity::kValid) {
        continue;
      }
      const double error_hz =
          static_cast<double>(report.measurement.frequency_hz) - spec.reference->frequency_hz(t_s);
      // At the corners the tracker's memory of 80 ms causes an error of 80 ms of the ramp.
      EXPECT_LT(std::abs(error_hz), 0.08 * std::abs(hz_per_s) + 0.02) << hz_per_s << " " << t_s;
      if (t_s > 1.3 && t_s < end_s - 0.03) {
        ++on_the_ramp;
        EXPECT_LT(std::abs(error_hz), 0.05) << hz_per_s << " " << t_s;
      }
    }
    EXPECT_GT(on_the_ramp, 5) << hz_per_s;
  }
}

TEST(TrackerDisturbance, MeasuresTheRocofOfASteadyRamp) {
  const test::MainsSpec spec = {test::ramp(50.0, 48.0, 1.0, -1.0), {}, 1.0};
  double sum = 0.0;
  int count = 0;
  for (const Report& report : test::reports_of(spec, 2.9, test::ieee24_settings())) {
    if (test::measured_s(report) < 1.5) {
      continue;
    }
    sum += static_cast<double>(report.measurement.rocof_hz_s);
    ++count;
    // Test pattern after IEC/IEEE 60255-118-1, P class: 0.4 Hz/s.
    EXPECT_NEAR(static_cast<double>(report.measurement.rocof_hz_s), -1.0, 0.4);
  }
  EXPECT_NEAR(sum / count, -1.0, 0.02);
}

Phasor phasor(float amplitude, float turns) {
  Phasor phasor;
  phasor.in_phase = amplitude * std::cos(kTwoPi * turns);
  phasor.quadrature = amplitude * std::sin(kTwoPi * turns);
  phasor.voltage_pu = amplitude;
  phasor.complete = true;
  return phasor;
}

// For any voltage the results stay within their bounds, and a clean voltage is acquired again.
TEST(TrackerDisturbance, StaysWithinBoundsForAnyVoltage) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  const TrackerSettings settings;
  for (int run = 0; run < 2000; ++run) {
    TrackerState state;
    const int kind = run % 4;
    for (int k = 0; k < 60; ++k) {
      // Amplitudes over eight decades; noise only; random phase; two alternating amplitudes.
      float amplitude = std::pow(10.0F, 8.0F * unit(generator) - 4.0F);
      if (kind == 1) {
        amplitude = unit(generator);
      }
      if (kind == 2) {
        amplitude = 1.0F;
      }
      if (kind == 3) {
        amplitude = k % 2 == 0 ? 0.12F : 30000.0F;
      }
      const Measurement m = track(settings, 50.0F, state, phasor(amplitude, unit(generator)));
      if (m.validity == Validity::kInvalid) {
        ASSERT_TRUE(std::isnan(m.frequency_hz) && std::isnan(m.rocof_hz_s));
      } else {
        ASSERT_TRUE(std::abs(m.frequency_hz - 50.0F) <= 15.01F) << m.frequency_hz;
        ASSERT_TRUE(std::abs(m.rocof_hz_s) <= 30.01F) << m.rocof_hz_s;
      }
    }
    // 51 Hz: 0.016 turns per report. 16 reports to hold, 16 to settle, and some to acquire.
    Measurement m;
    for (int k = 0; k < 60; ++k) {
      m = track(settings, 50.0F, state, phasor(1.0F, 0.016F * static_cast<float>(k)));
    }
    ASSERT_EQ(m.validity, Validity::kValid) << run;
    ASSERT_NEAR(m.frequency_hz, 51.0F, 1e-2F) << run;
  }
}

TEST(TrackerDisturbance, ANaNPhasorIsADeadBus) {
  TrackerState state;
  Phasor broken = phasor(1.0F, 0.0F);
  broken.in_phase = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(track(TrackerSettings{}, 50.0F, state, broken).validity, Validity::kInvalid);
}

}  // namespace
}  // namespace gs::outlet
