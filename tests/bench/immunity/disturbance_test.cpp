// Drawn disturbances: each kind is what its name says, and covers its ranges from end to end.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gmock/gmock.h>

#include <immunity/disturbance.hpp>

namespace gsbench::immunity {
namespace {

constexpr double kNominal_hz = 50.0;
constexpr std::uint32_t kOfEachKind = 2000;

std::vector<Disturbance> many(Kind kind) {
  std::vector<Disturbance> all;
  for (std::uint32_t n = 0; n < kOfEachKind; ++n) {
    const auto number =
        static_cast<std::uint32_t>(n * kKinds.size() + static_cast<std::size_t>(kind));
    all.push_back(draw(kNominal_hz, 1, number));
    EXPECT_EQ(all.back().kind, kind);
  }
  return all;
}

// All values of something in all disturbances of a kind.
template <class Values>
std::vector<double> values_of(Kind kind, const Values& values) {
  std::vector<double> all;
  for (const Disturbance& d : many(kind)) {
    values(d, all);
  }
  return all;
}

// Within low … high. The lowest and highest of 2000 values are within the outer hundredth, in the
// logarithm if it is uniform there: the probability to miss it is 2·0.99^2000 = 4·10⁻⁹.
void expect_covered(std::vector<double> values, double low, double high, bool logarithmic = false) {
  ASSERT_GE(values.size(), kOfEachKind);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  EXPECT_GE(*least, low);
  EXPECT_LE(*most, high);
  const auto at = [&](double part) {
    return logarithmic ? low * std::pow(high / low, part) : low + (high - low) * part;
  };
  // The rounding of values, at most 0.5, is not counted among the hundredth.
  const double rounding = logarithmic ? 0.005 : 0.5;
  EXPECT_LT(*least, at(0.01) + rounding);
  EXPECT_GT(*most, at(0.99) - rounding);
}

TEST(Disturbance, DependsOnSeedAndNumberAlone) {
  for (std::uint32_t number = 0; number < kKinds.size(); ++number) {
    const Disturbance one = draw(kNominal_hz, 7, number);
    const Disturbance again = draw(kNominal_hz, 7, number);
    EXPECT_EQ(one.kind, kKinds[number].kind);
    EXPECT_EQ(one.begin_s, again.begin_s);
    EXPECT_EQ(one.end_s, again.end_s);
    EXPECT_NE(one.begin_s, draw(kNominal_hz, 8, number).begin_s);
    EXPECT_NE(one.begin_s,
              draw(kNominal_hz, 7, number + static_cast<std::uint32_t>(kKinds.size())).begin_s);
  }
}

TEST(Disturbance, TheTableOfKindsIsInTheirOrder) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kKinds[i].kind), i);
  }
}

TEST(Disturbance, BeginsAtAnyPhaseOfTheWaveAndOfTheReportsOnceOutletsHaveSettled) {
  for (const KindRow& row : kKinds) {
    std::set<int> waves;
    std::set<int> reports;
    for (const Disturbance& d : many(row.kind)) {
      ASSERT_GT(d.begin_s, kSettled_s);
      ASSERT_GE(d.end_s, d.begin_s);
      ASSERT_TRUE(d.losses.empty());
      waves.insert(static_cast<int>(36.0 * std::fmod(kNominal_hz * d.begin_s, 1.0)));
      reports.insert(static_cast<int>(16.0 * std::fmod(d.begin_s / 0.016, 1.0)));
    }
    EXPECT_EQ(waves.size(), 36U) << row.name;
    EXPECT_EQ(reports.size(), 16U) << row.name;
  }
}

TEST(Dips, CoverAllResidualsAndDurations) {
  for (const Kind kind :
       {Kind::kDip, Kind::kTwoDips, Kind::kDipInStages, Kind::kDipWithPhaseSteps}) {
    const bool single = kind == Kind::kDip || kind == Kind::kDipWithPhaseSteps;
    expect_covered(
        values_of(kind,
                  [&](const Disturbance& d, std::vector<double>& values) {
                    ASSERT_EQ(d.signal.amplitude_steps.size(), single ? 1U : 2U);
                    for (const waveform::AmplitudeStep& step : d.signal.amplitude_steps) {
                      values.push_back(step.level_pct);
                    }
                  }),
        0.0, 95.0);
    expect_covered(
        values_of(kind,
                  [](const Disturbance& d, std::vector<double>& values) {
                    for (const waveform::AmplitudeStep& step : d.signal.amplitude_steps) {
                      values.push_back(step.duration_s);
                    }
                  }),
        0.005, single ? 3.0 : 1.0, true);
  }
  for (const Disturbance& d : many(Kind::kTwoDips)) {
    const auto& steps = d.signal.amplitude_steps;
    EXPECT_GT(steps[1].at_s, steps[0].at_s + steps[0].duration_s + 0.004);
    EXPECT_EQ(d.end_s, steps[1].at_s + steps[1].duration_s);
  }
  for (const Disturbance& d : many(Kind::kDipInStages)) {
    const auto& steps = d.signal.amplitude_steps;
    EXPECT_EQ(steps[1].at_s, steps[0].at_s + steps[0].duration_s);
  }
}

TEST(Dips, MayStepThePhaseAtTheirEndsByTheSameOrAnotherAngleOrNot) {
  int same = 0;
  int other = 0;
  int none = 0;
  for (const Disturbance& d : many(Kind::kDipWithPhaseSteps)) {
    const auto& jumps = d.signal.phase_jumps;
    ASSERT_THAT(jumps.size(), testing::AnyOf(1U, 2U));
    EXPECT_EQ(jumps[0].at_s, d.begin_s);
    EXPECT_EQ(jumps.back().at_s, jumps.size() == 2 ? d.end_s : d.begin_s);
    same += jumps.size() == 2 && jumps[1].degrees == -jumps[0].degrees ? 1 : 0;
    other += jumps.size() == 2 && jumps[1].degrees != -jumps[0].degrees ? 1 : 0;
    none += jumps.size() == 1 ? 1 : 0;
  }
  // 1000, 500 and 500 ± 5 σ.
  EXPECT_NEAR(same, 1000, 112);
  EXPECT_NEAR(other, 500, 97);
  EXPECT_NEAR(none, 500, 97);
}

TEST(Interruptions, LeaveNoVoltageForAllDurations) {
  expect_covered(values_of(Kind::kInterruption,
                           [](const Disturbance& d, std::vector<double>& values) {
                             ASSERT_EQ(d.signal.amplitude_steps.size(), 1U);
                             ASSERT_EQ(d.signal.amplitude_steps[0].level_pct, 0.0);
                             values.push_back(d.signal.amplitude_steps[0].duration_s);
                           }),
                 0.005, 3.0, true);
}

TEST(PhaseSteps, CoverBothDirectionsAndReturnOnlyIfTheirNameSaysSo) {
  for (const Kind kind : {Kind::kPhaseStep, Kind::kReturningPhaseStep}) {
    expect_covered(values_of(kind,
                             [&](const Disturbance& d, std::vector<double>& values) {
                               double sum_deg = 0.0;
                               for (const waveform::PhaseJump& jump : d.signal.phase_jumps) {
                                 sum_deg += jump.degrees;
                               }
                               const double degrees = d.signal.phase_jumps.at(0).degrees;
                               ASSERT_EQ(sum_deg, kind == Kind::kPhaseStep ? degrees : 0.0);
                               values.push_back(degrees);
                             }),
                   -60.0, 60.0);
  }
}

TEST(Flicker, CoversDepthsAndFrequencies) {
  expect_covered(values_of(Kind::kRectangularFlicker,
                           [](const Disturbance& d, std::vector<double>& values) {
                             values.push_back(100.0 - d.signal.amplitude_steps.at(0).level_pct);
                           }),
                 0.2, 10.0);
  expect_covered(values_of(Kind::kRectangularFlicker,
                           [](const Disturbance& d, std::vector<double>& values) {
                             values.push_back(0.5 / d.signal.amplitude_steps.at(0).duration_s);
                           }),
                 0.499, 33.4, true);
  expect_covered(values_of(Kind::kSinusoidalFlicker,
                           [](const Disturbance& d, std::vector<double>& values) {
                             ASSERT_EQ(d.signal.tones.size(), 2U);
                             ASSERT_EQ(d.signal.tones[0].amplitude_pct,
                                       d.signal.tones[1].amplitude_pct);
                             values.push_back(4.0 * d.signal.tones[0].amplitude_pct);
                           }),
                 0.2, 10.0);
  expect_covered(values_of(Kind::kSinusoidalFlicker,
                           [](const Disturbance& d, std::vector<double>& values) {
                             values.push_back(d.signal.tones[1].frequency_hz - kNominal_hz);
                             ASSERT_NEAR(kNominal_hz - d.signal.tones[0].frequency_hz,
                                         values.back(), 1e-9);
                           }),
                 0.4999, 33.3001, true);
}

// The peak of each half-wave follows 1 + m·sin(ω·τ + ψ), and the phase does not move: with the
// wrong phases of the side bands, the modulation would be one of the phase.
TEST(Flicker, ModulatesTheAmplitudeAndNotThePhase) {
  for (const Disturbance& d : many(Kind::kSinusoidalFlicker)) {
    const double m = 0.02 * d.signal.tones[0].amplitude_pct;
    const waveform::Synthesizer synthesizer(
        waveform::reference_from_points(kNominal_hz, {{0.0, kNominal_hz}}), d.signal,
        kSampleRate_hz);
    const std::int64_t from = waveform::tick_at(d.begin_s, kSampleRate_hz);
    const std::int64_t end = waveform::tick_at(d.end_s, kSampleRate_hz);
    std::vector<float> samples(static_cast<std::size_t>(end - from));
    synthesizer.render(from, samples.size(), samples.data());
    double least = 1.0;
    double most = 1.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::int64_t in_cycle = (from + static_cast<std::int64_t>(i)) % 160;
      const auto value = static_cast<double>(samples[i]);
      if (in_cycle == 0) {
        // Half a degree of rounding in each phase leaves m·0.0087.
        ASSERT_NEAR(value, 0.0, 0.01 * m);
      } else if (in_cycle == 40) {
        least = std::min(least, value);
        most = std::max(most, value);
      }
    }
    EXPECT_GE(least, 1.0 - 1.001 * m);
    EXPECT_LE(most, 1.0 + 1.001 * m);
  }
}

TEST(Harmonics, AreSwitchedOnUpToTheirLimits) {
  std::size_t at_limits = 0;
  for (const Disturbance& d : many(Kind::kHarmonics)) {
    ASSERT_EQ(d.signal.tones.size(), 24U);
    EXPECT_EQ(d.signal.tones[3].frequency_hz, 250.0);
    EXPECT_LE(d.signal.tones[3].amplitude_pct, 6.0);
    EXPECT_EQ(d.signal.tones[3].at_s, d.begin_s);
    at_limits += d.signal.tones[3].amplitude_pct == 6.0 && d.signal.tones[5].amplitude_pct == 5.0;
  }
  EXPECT_NEAR(static_cast<double>(at_limits), kOfEachKind / 3.0, 105.0) << "5 σ";
}

TEST(MainsSignalling, CoversLevelsAndFrequencies) {
  const auto each = [](double waveform::Tone::*member) {
    return values_of(Kind::kMainsSignalling,
                     [member](const Disturbance& d, std::vector<double>& values) {
                       values.push_back(d.signal.tones.at(0).*member);
                     });
  };
  expect_covered(each(&waveform::Tone::amplitude_pct), 0.5, 9.0);
  expect_covered(each(&waveform::Tone::frequency_hz), 110.0, 3000.0, true);
  expect_covered(each(&waveform::Tone::duration_s), 0.02, 1.0, true);
}

TEST(Oscillations, CoverFrequenciesAmplitudesAndAbruptOnesAllPhases) {
  for (const Kind kind : {Kind::kOscillation, Kind::kAbruptOscillation}) {
    const auto each = [kind](double waveform::Oscillation::*member) {
      return values_of(kind, [member](const Disturbance& d, std::vector<double>& values) {
        values.push_back(d.oscillations.at(0).*member);
      });
    };
    expect_covered(each(&waveform::Oscillation::frequency_hz), 0.1, 1.0, true);
    std::vector<double> amplitudes_mhz = each(&waveform::Oscillation::amplitude_hz);
    for (double& amplitude : amplitudes_mhz) {
      amplitude *= 1e3;
    }
    expect_covered(amplitudes_mhz, 1.0, 60.0 + 1e-9);
    if (kind == Kind::kAbruptOscillation) {
      expect_covered(each(&waveform::Oscillation::phase_deg), -180.0, 180.0);
    }
  }
  for (const Disturbance& d : many(Kind::kOscillation)) {
    const waveform::Oscillation& o = d.oscillations.at(0);
    EXPECT_THAT(o.phase_deg, testing::AnyOf(0.0, 180.0));
    EXPECT_NEAR(o.deviation_hz(std::nextafter(d.end_s, 0.0)), 0.0, 1e-5) << "no step at the end";
  }
}

}  // namespace
}  // namespace gsbench::immunity
