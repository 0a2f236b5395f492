#include "example_references.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <limits>
#include <random>
#include <thread>

#include <gtest/gtest.h>

namespace gsbench::waveform {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
// The rounding of a float near 1 is 6·10⁻⁸; the error of the sine polynomial, 1.4·10⁻¹¹, is
// negligible.
constexpr double kFloat = 1.2e-7;

// All features, with times at and between samples and block boundaries.
SignalSpec busy_signal() {
  SignalSpec spec;
  spec.harmonics = en50160_harmonics();
  spec.harmonics.insert(spec.harmonics.end(),
                        {{2.5, 3.0, 70.0}, {0.37, 1.0, 0.0}, {66, 0.5, 10.0}});
  spec.amplitude_steps = {{0.05, 0.2, 70.0}, {0.1003, 0.01, 0.0}, {0.3, kForever, 110.0}};
  spec.phase_jumps = {{0.2, 20.0}, {0.41234, -60.0}};
  spec.tones = {{0.0301, 0.4, 316.7, 5.0, 40.0}, {0.3, kForever, 1175.0, 2.0, 0.0}};
  spec.tones.push_back({0.05, kForever, 216.7, 3.0, 0.0, {{0.0, 0.1001}, {0.2, 0.3}}});
  spec.flickers = {{0.0203, 0.5, 8.8, 4.0, false}, {0.1, kForever, 13.0, 2.0, true}};
  spec.dc_offset_pct = 1.0;
  spec.initial_phase_deg = 30.0;
  return spec;
}

std::shared_ptr<const ReferenceSignal> busy_reference() {
  std::vector<recording::TracePoint> points;
  points.reserve(60);
  for (int i = 0; i < 60; ++i) {
    points.push_back({0.0137 * i, 50.0 + 0.5 * std::sin(i), 1.0 - 0.01 * (i % 7)});
  }
  return reference_from_points(50.0, points);
}

bool same_bits(const std::vector<float>& a, const float* b) {
  return std::memcmp(a.data(), b, a.size() * sizeof(float)) == 0;
}

TEST(Synthesizer, DoesNotDependOnTheDivisionIntoBlocks) {
  for (const SignalSpec& spec : {SignalSpec{}, busy_signal()}) {
    const Synthesizer synthesizer(busy_reference(), spec, 8000);
    const std::vector<float> whole = render(synthesizer, 0, 8000);
    std::mt19937 generator(1);
    for (int trial = 0; trial < 2000; ++trial) {
      const std::size_t first = generator() % 8000;
      const std::size_t count = 1 + generator() % std::min<std::size_t>(8000 - first, 400);
      ASSERT_TRUE(same_bits(render(synthesizer, static_cast<std::int64_t>(first), count),
                            whole.data() + first))
          << first << " + " << count;
    }
    for (std::size_t tick = 0; tick < 2000; ++tick) {
      ASSERT_TRUE(
          same_bits(render(synthesizer, static_cast<std::int64_t>(tick), 1), whole.data() + tick));
    }
  }
}

TEST(Synthesizer, IsTheSameOnEveryThread) {
  const Synthesizer synthesizer(busy_reference(), busy_signal(), 8000);
  const std::vector<float> alone = render(synthesizer, 0, 8000);
  std::vector<float> together(alone.size());
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int part = 0; part < 4; ++part) {
    threads.emplace_back([&synthesizer, &together, part] {
      synthesizer.render(2000 * part, 2000, together.data() + 2000 * part);
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_TRUE(same_bits(alone, together.data()));
}

// Coefficient of e^(i2πft) over whole periods, as amplitude and phase of a sine.
std::complex<double> sine_at(const std::vector<float>& samples, double frequency_hz,
                             double rate_hz) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double angle = 2.0 * M_PI * frequency_hz * static_cast<double>(i) / rate_hz;
    sum += static_cast<double>(samples[i]) * std::polar(1.0, -angle);
  }
  return sum * std::complex<double>(0.0, 2.0 / static_cast<double>(samples.size()));
}

TEST(Synthesizer, PutsEachHarmonicAtItsMultipleOfTheActualFrequency) {
  SignalSpec spec;
  spec.harmonics = en50160_harmonics();
  spec.harmonics.push_back({50, 2.5, -120.0});
  for (const double frequency_hz : {50.0, 47.0, 53.0}) {
    const Synthesizer synthesizer(constant(50.0, frequency_hz), spec, 8000);
    const std::vector<float> samples = render(synthesizer, 16000, 8000);
    EXPECT_LT(std::abs(sine_at(samples, frequency_hz, 8000.0) - 1.0), kFloat);
    for (int order = 2; order <= 52; ++order) {
      const auto given =
          std::find_if(spec.harmonics.begin(), spec.harmonics.end(),
                       [order](const Harmonic& harmonic) { return harmonic.order == order; });
      const std::complex<double> expected =
          given == spec.harmonics.end()
              ? 0.0
              : std::polar(given->amplitude_pct / 100.0, given->phase_deg / 180.0 * M_PI);
      EXPECT_LT(std::abs(sine_at(samples, order * frequency_hz, 8000.0) - expected), kFloat)
          << "order " << order << " of " << frequency_hz << " Hz";
    }
  }
}

TEST(Synthesizer, KeepsThePhaseOfAnyRealOrderInProportionAlsoWhileTheFrequencyChanges) {
  SignalSpec plain;
  plain.initial_phase_deg = 30.0;
  plain.phase_jumps = {{0.2, 100.0}, {0.4, -300.0}};
  SignalSpec spec = plain;
  spec.harmonics = {{2.5, 3.0, 70.0}, {0.37, 2.0, 0.0}, {1.02, 1.0, -45.0}, {66, 0.5, 10.0}};
  const auto reference = busy_reference();
  constexpr std::int64_t kFirst = 100'000'000;  // after 3.5 hours, the phase is as exact
  for (const std::int64_t first : {std::int64_t{0}, kFirst}) {
    const std::vector<float> fundamental = render({reference, plain, 8000}, first, 8000);
    const std::vector<float> samples = render({reference, spec, 8000}, first, 8000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double t_s = static_cast<double>(first + static_cast<std::int64_t>(i)) / 8000.0;
      const double steps_deg = (t_s >= 0.2 ? 100.0 : 0.0) - (t_s >= 0.4 ? 300.0 : 0.0);
      const auto fraction =
          static_cast<long double>(reference->excess_cycles(t_s) + (30.0 + steps_deg) / 360.0);
      const long double cycles = 50.0L * static_cast<long double>(t_s) + fraction;
      const double voltage_pu = reference->voltage_pu(t_s);
      double expected = static_cast<double>(fundamental[i]);
      for (const Harmonic& harmonic : spec.harmonics) {
        const auto phase = static_cast<double>(
                               std::fmod(static_cast<long double>(harmonic.order) * cycles, 1.0L)) +
                           harmonic.phase_deg / 360.0;
        expected += voltage_pu * harmonic.amplitude_pct / 100.0 * std::sin(2.0 * M_PI * phase);
      }
      ASSERT_NEAR(static_cast<double>(samples[i]), expected, 2.0 * kFloat) << first << " + " << i;
    }
  }
}

TEST(Synthesizer, ModulatesTheAmplitudeButNotOffsetAndTones) {
  SignalSpec spec;
  spec.harmonics = {{5, 6.0, 180.0}, {2.5, 3.0, 0.0}};
  const std::vector<float> plain = render({constant(50, 50), spec, 8000}, 0, 8000);
  spec.dc_offset_pct = 5.0;
  spec.tones = {{0.0, kForever, 316.7, 5.0, 0.0}};
  SignalSpec others = spec;
  others.amplitude_steps = {{0.0, kForever, 0.0}};
  const std::vector<float> unmodulated = render({constant(50, 50), others, 8000}, 0, 8000);
  spec.flickers = {{0.1, 0.6, 8.8, 10.0, false}, {0.25, 0.5, 10.0, 4.0, true}};
  const Synthesizer synthesizer(constant(50, 50), spec, 8000);
  const std::vector<float> samples = render(synthesizer, 0, 8000);
  for (std::size_t tick = 0; tick < samples.size(); ++tick) {
    const double t_s = static_cast<double>(tick) / 8000.0;
    double factor = 1.0;
    if (tick >= 800 && tick < 5600) {
      factor *= 1.0 + 0.05 * std::sin(2.0 * M_PI * 8.8 * (t_s - 0.1));
    }
    if (tick >= 2000 && tick < 6000) {
      factor *= (tick - 2000) / 400 % 2 == 0 ? 1.02 : 0.98;
    }
    ASSERT_NEAR(static_cast<double>(samples[tick]),
                factor * static_cast<double>(plain[tick]) + static_cast<double>(unmodulated[tick]),
                3.0 * kFloat)  // of signal, modulation and tone
        << tick;
    ASSERT_NEAR(synthesizer.amplitude_pu(static_cast<std::int64_t>(tick)), factor, 1e-9) << tick;
  }
}

TEST(Synthesizer, KeysAToneWithoutAStepOfItsPhase) {
  SignalSpec spec;
  spec.tones = {{0.1, 0.5, 216.7, 9.0, 30.0}};
  const std::vector<float> on = render({constant(50, 50), spec, 8000}, 0, 8000);
  const std::vector<float> off = render({constant(50, 50), {}, 8000}, 0, 8000);
  spec.tones[0].pulses = {{0.0, 0.05}, {0.1, 0.2}, {0.45, 0.6}};  // the last is cut by the tone
  const std::vector<float> samples = render({constant(50, 50), spec, 8000}, 0, 8000);
  for (std::size_t tick = 0; tick < samples.size(); ++tick) {
    const bool is_on = (tick >= 800 && tick < 1200) || (tick >= 1600 && tick < 2400) ||
                       (tick >= 4400 && tick < 4800);
    ASSERT_EQ(samples[tick], (is_on ? on : off)[tick]) << tick;
  }
}

TEST(Synthesizer, AppliesAPhaseStepFromTheFirstSampleAtOrAfterItsTime) {
  SignalSpec shifted;
  shifted.initial_phase_deg = 20.0;
  const std::vector<float> before = render({constant(50, 50), {}, 8000}, 0, 8000);
  const std::vector<float> after = render({constant(50, 50), shifted, 8000}, 0, 8000);
  struct Case {
    double at_s;
    std::size_t first_jumped;
  };
  for (const Case& jump : {Case{0.3, 2400}, Case{0.1 + 0.2, 2400}, Case{0.300001, 2401},
                           Case{0.299999, 2400}, Case{0.0, 0}, Case{0.29988, 2400}}) {
    SignalSpec spec;
    spec.phase_jumps = {{jump.at_s, 20.0}};
    const std::vector<float> samples = render({constant(50, 50), spec, 8000}, 0, 8000);
    for (std::size_t tick = 0; tick < samples.size(); ++tick) {
      ASSERT_EQ(samples[tick], tick < jump.first_jumped ? before[tick] : after[tick])
          << jump.at_s << " s, tick " << tick;
    }
  }
}

TEST(Synthesizer, AddsPhaseStepsAndShiftsHarmonicsInProportion) {
  SignalSpec spec;
  spec.harmonics = {{3, 10.0, 15.0}};
  SignalSpec jumped = spec;
  jumped.phase_jumps = {{0.2, 50.0}, {0.1, -20.0}};
  spec.initial_phase_deg = 30.0;
  const std::vector<float> expected = render({constant(50, 50), spec, 8000}, 1600, 1600);
  EXPECT_EQ(render({constant(50, 50), jumped, 8000}, 1600, 1600), expected);
}

TEST(Synthesizer, ScalesTheWholeSignalDuringDipsAndMultipliesOverlappingOnes) {
  SignalSpec spec;
  spec.harmonics = {{5, 6.0, 180.0}};
  const std::vector<float> plain = render({constant(50, 50), spec, 8000}, 0, 8000);
  spec.amplitude_steps = {{0.5, 0.2, 40.0}, {0.1, kForever, 50.0}, {0.9, 0.02, 0.0}};
  const std::vector<float> stepped = render({constant(50, 50), spec, 8000}, 0, 8000);
  for (std::size_t tick = 0; tick < plain.size(); ++tick) {
    double level = tick < 800 ? 1.0 : 0.5;
    if (tick >= 4000 && tick < 5600) {
      level *= 0.4;
    }
    if (tick >= 7200 && tick < 7360) {
      level = 0.0;
    }
    ASSERT_NEAR(static_cast<double>(stepped[tick]), level * static_cast<double>(plain[tick]),
                kFloat)
        << tick;
  }
}

TEST(Synthesizer, DoesNotScaleTheDcOffsetDuringDips) {
  SignalSpec spec;
  spec.dc_offset_pct = -2.0;
  spec.amplitude_steps = {{0.0, kForever, 0.0}};
  for (const float sample : render({constant(50, 50), spec, 8000}, 0, 1000)) {
    ASSERT_EQ(sample, -0.02f);
  }
}

TEST(Synthesizer, AddsTonesDuringTheirTimeAlsoToADip) {
  SignalSpec spec;
  spec.amplitude_steps = {{0.2, 0.3, 40.0}};
  const std::vector<float> plain = render({constant(50, 50), spec, 8000}, 0, 8000);
  // 0.10003 s is between two samples: the first at or after it has a phase above 30°.
  spec.tones = {{0.10003, 0.2, 216.7, 9.0, 30.0}, {0.25, kForever, 3000.0, 1.5, -90.0}};
  const std::vector<float> samples = render({constant(50, 50), spec, 8000}, 0, 8000);
  const auto tone = [](double amplitude, double hz, double since_s, double degrees) {
    return amplitude * std::sin(2.0 * M_PI * (hz * since_s + degrees / 360.0));
  };
  for (std::size_t tick = 0; tick < samples.size(); ++tick) {
    const double t_s = static_cast<double>(tick) / 8000.0;
    double added = 0.0;
    if (tick >= 801 && tick < 2401) {
      added += tone(0.09, 216.7, t_s - 0.10003, 30.0);
    }
    if (tick >= 2000) {
      added += tone(0.015, 3000.0, t_s - 0.25, -90.0);
    }
    ASSERT_NEAR(static_cast<double>(samples[tick]), static_cast<double>(plain[tick]) + added,
                kFloat)
        << tick;
  }
}

TEST(Synthesizer, FollowsTheRecordedVoltageBetweenPoints) {
  const std::shared_ptr<const ReferenceSignal> reference = reference_from_points(
      50.0, {{0.0, 50.0, 1.0}, {0.1, 50.0, 0.8}, {0.13333, 50.0, 0.0}, {0.5, 50.0, 0.02}});
  const std::vector<float> plain = render({constant(50, 50), {}, 8000}, 0, 8000);
  const std::vector<float> samples = render({reference, {}, 8000}, 0, 8000);
  for (std::size_t tick = 0; tick < samples.size(); ++tick) {
    const double voltage_pu = reference->voltage_pu(static_cast<double>(tick) / 8000.0);
    ASSERT_NEAR(static_cast<double>(samples[tick]), voltage_pu * static_cast<double>(plain[tick]),
                kFloat)
        << tick;
  }
}

TEST(Synthesizer, AcceptsThousandsOfAmplitudeSteps) {
  SignalSpec spec;
  for (int i = 0; i < 20'000; ++i) {
    spec.amplitude_steps.push_back({0.1 * i, 0.05, 99.0});
  }
  const std::vector<float> plain = render({constant(50, 50), {}, 8000}, 0, 800);
  const std::vector<float> samples = render({constant(50, 50), spec, 8000}, 1'999 * 8000, 800);
  for (std::size_t tick = 0; tick < samples.size(); ++tick) {
    ASSERT_NEAR(static_cast<double>(samples[tick]),
                (tick < 400 ? 0.99 : 1.0) * static_cast<double>(plain[tick]), kFloat);
  }
}

}  // namespace
}  // namespace gsbench::waveform
