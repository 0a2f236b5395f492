// Plans of the shipped instruments: rates, amplitudes, deviations. Expected values are computed
// from the signal, not by the planner's code.
#include "codes.hpp"
#include <source_scpi/planner.hpp>
#include <test_support/mains.hpp>

#include <cmath>

#include <gmock/gmock.h>

#include <station/instrument_file.hpp>

namespace gsbench::scpi {
namespace {

using gsbench::test::Mains;
using station::load_instrument;
using testing::Contains;
using testing::HasSubstr;

constexpr double kSqrt2 = 1.4142135623730951;

Plan plan_of(const source::Stimulus& stimulus, const Instrument& instrument,
             const PlanOptions& options = {}) {
  auto plan = make_plan(stimulus, instrument, options);
  EXPECT_TRUE(plan.ok()) << plan.error();
  return plan.ok() ? plan.take() : Plan();
}

class PlansOf : public testing::TestWithParam<const char*> {
 protected:
  const Instrument instrument_ = load_instrument(GetParam());
  Mains mains_;
};

INSTANTIATE_TEST_SUITE_P(Shipped, PlansOf,
                         testing::Values("siglent-sdg2000x", "rigol-dg1000z", "keysight-33500b"));

TEST_P(PlansOf, HaveFourPointsATickIfTheMemoryIsLarge) {
  mains_.duration_s = 5.0;
  const Plan plan = plan_of(mains_, instrument_);
  EXPECT_EQ(plan.rate_hz, 32000.0);
  EXPECT_EQ(plan.lead_s, 0.5 + 10.0 + 1.0);
  EXPECT_NEAR(plan.duration_s, 11.5 + 5.0 + 0.5 + 0.01, 1e-9);
  EXPECT_EQ(plan.codes.size(), static_cast<std::size_t>(std::lround(17.01 * 32000.0)) + 1);
}

// 30 degrees at a zero crossing, between the ticks 16 000 and 16 001.
struct PhaseStep final : Mains {
  void render(std::int64_t first_tick, std::size_t count, float* out) const override {
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t tick = first_tick + static_cast<std::int64_t>(i);
      const double turns =
          0.25 + static_cast<double>(tick % 160) / 160.0 + (tick > 16000 ? 1.0 / 12 : 0);
      out[i] = static_cast<float>(std::cos(6.283185307179586 * turns));
    }
  }
};

// At the later tick instead, the frequency over 200 ms would be 1.3 mHz to 1.7 mHz wrong.
TEST_P(PlansOf, PutAStepOfThePhaseInTheMiddleBetweenTicks) {
  PhaseStep stimulus;
  stimulus.duration_s = 4.0;
  const Plan plan = plan_of(stimulus, instrument_);
  EXPECT_EQ(plan.rate_hz, 32000.0);
  EXPECT_LT(plan.played.frequency_hz, 0.0006);
}

// At 8 kSa/s, held points put the step half a tick off.
TEST_P(PlansOf, HaveAHigherRateIfAToleranceNeedsIt) {
  PhaseStep stimulus;
  stimulus.duration_s = 4.0;
  Instrument instrument = instrument_;
  instrument.rate.interpolation = Interpolation::kHold;
  instrument.memory.points = 244000;  // 15.23 kSa/s for 16.01 s
  PlanOptions options;
  options.tolerances.voltage_pu = 0.03;
  options.tolerances.frequency_hz = 0.003;
  const Plan usual = plan_of(stimulus, instrument, options);
  EXPECT_EQ(usual.rate_hz, 8000.0);
  options.tolerances.frequency_hz = 0.9 * usual.played.frequency_hz;
  const Plan plan = plan_of(stimulus, instrument, options);
  EXPECT_GT(plan.rate_hz, 15200.0);
  EXPECT_LE(plan.codes.size(), 244000U);
  EXPECT_LT(plan.played.frequency_hz, 0.6 * usual.played.frequency_hz);
}

TEST_P(PlansOf, FillTheDacWithTheLargestSample) {
  mains_.duration_s = 2.0;
  mains_.level_pu = 1.08;
  const Plan plan = plan_of(mains_, instrument_);
  // 230 V · √2 · 1.08, through a gain of 100, peak to peak.
  const double needed_vpp = 2.0 * 230.0 * kSqrt2 * 1.08 / 100.0;
  EXPECT_GE(plan.amplitude_vpp, needed_vpp - 1e-6);
  EXPECT_LE(plan.amplitude_vpp, needed_vpp + instrument_.amplitude.resolution_vpp);
  double highest = 0.0;
  for (const std::int32_t code : plan.codes) {
    highest = std::fmax(highest, std::fabs(level_of(code, instrument_)));
  }
  EXPECT_LE(highest, 1.0);
  // Not more than the rounding of the amplitude below full scale.
  EXPECT_GT(highest, needed_vpp / (needed_vpp + instrument_.amplitude.resolution_vpp) - 2e-4);
}

TEST_P(PlansOf, BeginAndEndWithZeroVolts) {
  mains_.duration_s = 1.0;
  const Plan plan = plan_of(mains_, instrument_);
  for (const std::int32_t code : {plan.codes.front(), plan.codes.back()}) {
    EXPECT_LE(std::fabs(code - instrument_.middle_code()), 1.0);
  }
}

TEST_P(PlansOf, PlayTheStimulusWhereTheySay) {
  mains_.duration_s = 2.0;
  mains_.level_pu = 0.9;
  mains_.falls_hz_s = 0.5;
  const Plan plan = plan_of(mains_, instrument_);
  std::vector<float> ideal(static_cast<std::size_t>(mains_.total_ticks()));
  mains_.render(0, ideal.size(), ideal.data());
  const double scale_pu = 0.5 * plan.amplitude_vpp * 100.0 / (230.0 * kSqrt2);
  // A held point begins at the tick and has the voltage of half a point later.
  for (std::size_t n = 0; n < ideal.size(); n += 7) {
    const auto point = static_cast<std::size_t>(
        std::lround((plan.lead_s + static_cast<double>(n) / 8000.0) * plan.rate_hz));
    EXPECT_NEAR(scale_pu * level_of(plan.codes[point], instrument_), static_cast<double>(ideal[n]),
                0.006)
        << n;
  }
}

TEST_P(PlansOf, KeepTheFrequencyFarBelowAMillihertz) {
  mains_.duration_s = 5.0;
  mains_.falls_hz_s = 0.5;
  const Plan plan = plan_of(mains_, instrument_);
  const double clock_hz = 50.0e-6 * instrument_.accuracy.clock_ppm;
  EXPECT_GE(plan.played.frequency_hz, clock_hz);
  EXPECT_LT(plan.played.frequency_hz, clock_hz + 1e-4);
}

TEST(PlannedVoltage, DeviatesByHalfAPointIfPointsAreHeld) {
  Mains mains;
  mains.duration_s = 2.0;
  const Instrument instrument = load_instrument("keysight-33500b");
  // 2π · 50 Hz · half of 1/32 kHz, and the DAC's step.
  EXPECT_NEAR(plan_of(mains, instrument).played.voltage_pu, 314.16 / 64000.0, 1e-4);
}

TEST(PlannedVoltage, DeviatesByTheSagittaIfPointsAreJoined) {
  Mains mains;
  mains.duration_s = 2.0;
  Instrument instrument = load_instrument("siglent-sdg2000x");
  instrument.quirks = {};
  const double chord_pu = std::pow(314.16 / 32000.0, 2.0) / 8.0;
  const double found_pu = plan_of(mains, instrument).played.voltage_pu;
  EXPECT_GT(found_pu, chord_pu);
  EXPECT_LT(found_pu, chord_pu + 6e-5);
}

TEST(PlannedVoltage, StatesTheAccuracyOfTheAmplitudeApart) {
  Mains mains;
  mains.duration_s = 2.0;
  mains.level_pu = 1.05;
  Instrument instrument = load_instrument("siglent-sdg2000x");
  PlanOptions options;
  options.tolerances.voltage_pu = 0.006;
  double waveform_pu = 0.0;
  for (const double accuracy_pct : {0.0, 2.0}) {
    instrument.accuracy.amplitude_pct = accuracy_pct;
    const Plan plan = plan_of(mains, instrument, options);
    EXPECT_NEAR(plan.played.amplitude_pu, 0.0105 * accuracy_pct, 1e-6);
    EXPECT_TRUE(waveform_pu == 0.0 || plan.played.voltage_pu == waveform_pu);
    waveform_pu = plan.played.voltage_pu;
    EXPECT_GT(waveform_pu, 0.0);
  }
}

TEST(PlannedVoltage, CountsCodesThatWereMoved) {
  Mains mains;
  mains.duration_s = 2.0;
  const Instrument instrument = load_instrument("siglent-sdg2000x");
  const Plan plan = plan_of(mains, instrument);
  EXPECT_GT(plan.largest_nudge, 100);
  // 128 of 32 767 at most.
  EXPECT_GT(plan.played.voltage_pu, 100.0 / 32767.0);
  EXPECT_LT(plan.played.voltage_pu, 160.0 / 32767.0);
  EXPECT_THAT(plan.played.how, Contains(HasSubstr("codes that contain a newline are moved by")));
}

TEST(PlannedTime, GrowsWithTheClocksErrorAndTheDuration) {
  Mains mains;
  mains.duration_s = 10.0;
  Instrument instrument = load_instrument("siglent-sdg2000x");
  instrument.accuracy.clock_ppm = 20.0;
  PlanOptions options;
  options.tolerances.frequency_hz = 0.01;
  const Plan plan = plan_of(mains, instrument, options);
  EXPECT_NEAR(plan.played.time_s, 20e-6 * 22.01, 1e-9);
  EXPECT_NEAR(plan.played.frequency_hz, 20e-6 * 50.0, 1e-4);
}

TEST(PlannedNoise, IsPlayedAndFitsTheRange) {
  Mains mains;
  mains.duration_s = 2.0;
  const Instrument instrument = load_instrument("keysight-33500b");
  const Plan quiet = plan_of(mains, instrument);
  mains.added = {0.01F, 7};
  const Plan noisy = plan_of(mains, instrument);
  EXPECT_GT(noisy.amplitude_vpp, 1.01 * quiet.amplitude_vpp);
  EXPECT_LT(noisy.amplitude_vpp, 1.08 * quiet.amplitude_vpp);
  EXPECT_NEAR(noisy.played.voltage_pu, quiet.played.voltage_pu, 1e-4);
  double squares = 0.0;
  const auto first = static_cast<std::size_t>(quiet.lead_s * quiet.rate_hz);
  constexpr std::size_t kPoints = 60000;
  for (std::size_t i = first; i < first + kPoints; ++i) {
    const double difference =
        noisy.amplitude_vpp * level_of(noisy.codes[i], instrument) / quiet.amplitude_vpp -
        level_of(quiet.codes[i], instrument);
    squares += difference * difference;
  }
  EXPECT_NEAR(std::sqrt(squares / kPoints), 0.01, 0.0005);
}

TEST(PlannedRate, FallsWithTheLengthInWholeMultiples) {
  Mains mains;
  PlanOptions options;
  options.tolerances.voltage_pu = 0.05;
  const Instrument instrument = load_instrument("keysight-33500b");
  for (const auto& [duration_s, rate_hz] : {std::pair(15.0, 32000.0), std::pair(25.0, 24000.0),
                                            std::pair(45.0, 16000.0), std::pair(100.0, 8000.0)}) {
    mains.duration_s = duration_s;
    const Plan plan = plan_of(mains, instrument, options);
    EXPECT_EQ(plan.rate_hz, rate_hz);
    EXPECT_LE(plan.codes.size(), 1000000U);
  }
  mains.duration_s = 150.0;
  const Plan filled = plan_of(mains, instrument, options);
  EXPECT_LT(filled.rate_hz, 8000.0);
  EXPECT_GT(filled.codes.size(), 999900U);
}

TEST(PlannedRate, OfAFixedMemoryIsAFrequencyInItsSteps) {
  Mains mains;
  mains.duration_s = 1.0;
  PlanOptions options;
  options.boot_s = 0.5;
  options.tolerances.voltage_pu = 0.1;
  const Instrument instrument = load_instrument("siglent-sdg1000x");
  const Plan plan = plan_of(mains, instrument, options);
  EXPECT_EQ(plan.codes.size(), 16384U);
  // 3.51 s of waveform.
  EXPECT_NEAR(plan.rate_hz, 16384.0 / 3.51, 2.0);
  EXPECT_NEAR(plan.frequency_hz, std::round(plan.frequency_hz * 1e6) / 1e6, 1e-12);
  EXPECT_LT(plan.played.frequency_hz, 0.0005);
}

TEST(Plans, SayHowTheyPlay) {
  Mains mains;
  mains.duration_s = 2.0;
  const Plan plan = plan_of(mains, load_instrument("siglent-sdg2000x"));
  const std::vector<std::string>& how = plan.played.how;
  EXPECT_EQ(how.front(), "448321 points at 32000 Sa/s, played once");
  EXPECT_THAT(how, Contains(HasSubstr("10 s for outlets to boot")));
  EXPECT_THAT(how, Contains(HasSubstr("6.506 Vpp at the instrument's terminals")));
  EXPECT_THAT(how, Contains(HasSubstr("upload of 896642 bytes, verified by reading it back")));
  EXPECT_THAT(how, Contains(HasSubstr("accuracy from the instrument's table: clock ±2 ppm")));
}

}  // namespace
}  // namespace gsbench::scpi
