// What a generator cannot play is refused with value and limit, and what is just possible is not.
#include <source_scpi/planner.hpp>
#include <test_support/mains.hpp>

#include <gmock/gmock.h>

#include <station/instrument_file.hpp>

namespace gsbench::scpi {
namespace {

using gsbench::test::Mains;
using testing::AllOf;
using testing::HasSubstr;

class Refusals : public testing::Test {
 protected:
  Refusals() { mains_.duration_s = 1.0; }

  // The refusal; empty if it is planned.
  std::string refusal() const {
    const auto plan = make_plan(mains_, instrument_, options_);
    return plan.ok() ? "" : plan.error();
  }

  Mains mains_;
  Instrument instrument_ = station::load_instrument("siglent-sdg2000x");
  PlanOptions options_;
};

TEST_F(Refusals, NameTheMemory) {
  instrument_.memory.points = 20000;
  options_.tolerances.voltage_pu = 0.2;
  // 1 kSa/s, 20 points a period, is the lowest rate: 20 s with 11.5 s before and 0.51 s after.
  mains_.duration_s = 7.9;
  EXPECT_EQ(refusal(), "");
  mains_.duration_s = 8.1;
  EXPECT_THAT(refusal(),
              AllOf(HasSubstr("the memory holds 20000 points, 20.00 s at the lowest usable "
                              "rate of 1000 Sa/s"),
                    HasSubstr("the waveform takes 20.11 s, of which the stimulus is "
                              "8.10 s")));
}

// Ten minutes of samples take a second, and a day's gigabytes.
TEST_F(Refusals, OfWhatIsTooLongNeedNoSamples) {
  struct NotRendered final : Mains {
    void render(std::int64_t, std::size_t, float*) const override {
      ADD_FAILURE() << "samples were computed";
    }
  } mains;
  mains.duration_s = 100000.0;
  EXPECT_THAT(make_plan(mains, instrument_, options_).error(),
              HasSubstr("the waveform takes 100012.01 s, of which the stimulus is 100000.00 s"));
  // 1000 s fit, but the clock is 2 ms off then.
  mains.duration_s = 1000.0;
  EXPECT_THAT(make_plan(mains, instrument_, options_).error(),
              HasSubstr("the time would deviate by up to 2.024 ms"));
}

TEST_F(Refusals, NameTheRate) {
  instrument_.rate.highest_hz = 999.0;
  EXPECT_THAT(refusal(), HasSubstr("plays at most 999 points a second; at least 1000 are needed"));
  instrument_.rate.highest_hz = 8000.0;
  EXPECT_EQ(refusal(), "");
}

TEST_F(Refusals, NameAnAmplitudeThatIsTooHigh) {
  // 6.506 Vpp with a gain of 100; 20 Vpp with 32.53.
  options_.wiring.gain = 32.6;
  EXPECT_EQ(refusal(), "");
  options_.wiring.gain = 32.5;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("20.017 Vpp are needed"), HasSubstr("at most 20 Vpp")));
}

TEST_F(Refusals, NameAnAmplitudeThatIsTooLow) {
  options_.wiring.gain = 330000.0;
  EXPECT_EQ(refusal(), "");
  options_.wiring.gain = 700000.0;
  EXPECT_THAT(refusal(),
              AllOf(HasSubstr("0.00092934 Vpp are needed"), HasSubstr("at least 0.002")));
}

TEST_F(Refusals, NameAnAmplitudeThatIsRoundedUpBeyondTheVoltageLimit) {
  options_.wiring.gain = 100000.0;
  options_.wiring.voltage_limit_v = 230.0;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("0.007 Vpp, rounded up to steps of 0.001 Vpp"),
                               HasSubstr("the voltage limit is 325.27 V")));
}

TEST_F(Refusals, NameTheVoltageLimit) {
  options_.wiring.voltage_limit_v = 253.0;
  mains_.level_pu = 1.0997;
  EXPECT_EQ(refusal(), "");
  mains_.level_pu = 1.101;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("358.12 V peak at the outlets are beyond the voltage "
                                         "limit of 357.8 V peak (253 V RMS)")));
}

TEST_F(Refusals, NameTheFrequency) {
  instrument_.accuracy.clock_ppm = 25.0;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("by its clock alone, ±25 ppm, the frequency would "
                                         "deviate by up to 1.25 mHz"),
                               HasSubstr("the tolerance is 1 mHz")));
  options_.tolerances.frequency_hz = 0.0013;
  EXPECT_EQ(refusal(), "");
}

TEST_F(Refusals, NameTheVoltage) {
  instrument_.rate.interpolation = Interpolation::kHold;
  options_.tolerances.voltage_pu = 0.0045;
  EXPECT_EQ(refusal(), "") << "more than 32 kSa/s are used if they are needed";
  instrument_.rate.highest_hz = 32000.0;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("at 32000 Sa/s, the highest rate of the instrument, the "
                                         "voltage would deviate by up to 0.7"),
                               HasSubstr("the tolerance is 0.45 %")));
  instrument_.rate.highest_hz = 75e6;
  options_.tolerances.voltage_pu = 0.0001;
  EXPECT_THAT(refusal(), HasSubstr("at 128000 Sa/s, 16 times the rate of the stimulus, the most "
                                   "that is used, the voltage"));
  options_.tolerances.voltage_pu = 0.01;
  EXPECT_EQ(refusal(), "");
}

TEST_F(Refusals, NameTheTime) {
  options_.tolerances.time_s = 20e-6;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("by its clock, ±2 ppm, over the 13.0 s of the waveform, "
                                         "of which the stimulus is 1.0 s and the time for outlets "
                                         "to boot 10.0 s, the time would deviate by up to "
                                         "0.02602 ms"),
                               HasSubstr("the tolerance is 0.02 ms")));
  options_.tolerances.time_s = 27e-6;
  EXPECT_EQ(refusal(), "");
}

TEST_F(Refusals, OfASmallInstrumentNameTheVoltageAtTheRateThatFits) {
  instrument_ = station::load_instrument("siglent-sdg1000x");
  options_.boot_s = 1.0;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("the highest rate at which the 4.0 s of the waveform fit "
                                         "the memory of 16384 points, "),
                               HasSubstr("the voltage would deviate by up to 3.")));
  options_.boot_s = 30.0;
  EXPECT_THAT(refusal(), HasSubstr("the memory holds 16384 points, 16.38 s"));
  options_.boot_s = 1.0;
  options_.tolerances.voltage_pu = 0.05;
  EXPECT_EQ(refusal(), "");
}

TEST_F(Refusals, ConcernAlsoADipOnly) {
  // The time for booting has nominal voltage.
  mains_.level_pu = 0.0001;
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace gsbench::scpi
