// What a head plays: ramp, nominal voltage, stimulus, and no step between them.
#include <head_driver_test/head_rig.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::HasSubstr;

// Largest step between two codes: the slope of 230 V RMS at 50 Hz, and the rounding.
int largest_step(const std::vector<std::uint16_t>& codes, std::size_t first, std::size_t end) {
  int largest = 0;
  for (std::size_t i = first + 1; i < end; ++i) {
    largest = std::max(largest, std::abs(int{codes[i]} - int{codes[i - 1]}));
  }
  return largest;
}

class HeadPlays : public testing::Test {
 protected:
  HeadPlays() { mains_.duration_s = 2.0; }

  HeadRig rig_;
  Mains mains_;
};

TEST_F(HeadPlays, RampNominalVoltageAndEverySampleOfTheStimulus) {
  mains_.falls_hz_s = 0.5;
  mains_.added = {0.01F, 11};
  rig_.start(mains_);
  rig_.play(mains_);
  EXPECT_TRUE(rig_.source().stop().ok());
  const std::vector<std::uint16_t> expected = rig_.expected(mains_);
  // A sample may be rounded the other way.
  EXPECT_LE(largest_difference(rig_.codes(), expected, expected.size()), 1);
  // With a sample too much or too little before the stimulus, they differ.
  std::vector<std::uint16_t> shifted = expected;
  shifted.erase(shifted.begin(), shifted.begin() + kCodesPerSample);
  EXPECT_GT(largest_difference(rig_.codes(), shifted, shifted.size()), 60);
}

TEST_F(HeadPlays, NoStepFromRampToStimulusAndAfterIt) {
  rig_.start(mains_, 10);
  rig_.play(mains_);
  ASSERT_TRUE(rig_.source().stop().ok());
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(rig_.source().hold().ok());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const std::int64_t end = rig_.tick_0_sample() + mains_.total_ticks();
  const std::vector<std::uint16_t> codes = rig_.codes();
  const auto after = static_cast<std::size_t>((end + 400) * kCodesPerSample);
  ASSERT_GT(codes.size(), after);
  // 1709 steps of amplitude: 8.4 from code to code at the zero crossing.
  EXPECT_LE(largest_step(codes, 0, after), 10);
  EXPECT_GE(largest_step(codes, 0, after), 8);
}

TEST_F(HeadPlays, AlsoAStimulusThatBeginsWithAnotherPhase) {
  struct Shifted final : Mains {
    void render(std::int64_t first_tick, std::size_t count, float* out) const override {
      Mains::render(first_tick + 37, count, out);
    }
  } shifted;
  shifted.duration_s = 0.5;
  rig_.start(shifted);
  rig_.play(shifted);
  const std::vector<std::uint16_t> codes = rig_.codes();
  EXPECT_LE(largest_step(codes, 0, codes.size()), 10);
}

TEST_F(HeadPlays, NominalVoltageWhenStoppedEarly) {
  mains_.falls_hz_s = 2.0;
  rig_.start(mains_);
  advance(rig_.source(), 12000);
  ASSERT_TRUE(rig_.source().stop().ok());
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(rig_.source().hold().ok());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const std::vector<std::uint16_t> codes = rig_.codes();
  EXPECT_LE(largest_step(codes, 0, codes.size()), 10);
  // The last 320 ms: 16 periods of 50 Hz, which returns to the same code.
  const std::size_t last = codes.size() - 1;
  for (std::size_t i = 0; i < 1280; i += 64) {
    EXPECT_NEAR(codes[last - i], codes[last - i - 16 * 1280], 2) << i;
  }
}

TEST_F(HeadPlays, SixtyHertz) {
  mains_.nominal = 60;
  mains_.duration_s = 0.5;
  rig_.start(mains_);
  rig_.play(mains_);
  const std::vector<std::uint16_t> expected = rig_.expected(mains_);
  EXPECT_LE(largest_difference(rig_.codes(), expected, expected.size()), 1);
}

TEST_F(HeadPlays, UntilMakeSafeAndThenNothing) {
  rig_.start(mains_);
  advance(rig_.source(), 4000);
  ASSERT_TRUE(rig_.source().make_safe().ok());
  EXPECT_EQ(rig_.head->observe().state, gs::head::State::kOff);
  const std::int64_t off = rig_.head->observe().code;
  EXPECT_TRUE(until([&] { return rig_.head->observe().code > off + 64 * 20; }));
  // What the DMA still had: 2 ms at most.
  EXPECT_LE(rig_.head->observe().last_driven, off + 128);
  EXPECT_GT(rig_.head->observe().last_driven, off - 64 * 20);
}

TEST_F(HeadPlays, WithTheStatedAmplitude) {
  rig_.start(mains_);
  rig_.play(mains_);
  const std::vector<std::uint16_t> codes = rig_.codes();
  const auto highest = *std::max_element(codes.begin(), codes.end());
  // 230 V · √2 / 260 = 1.2510 V of 1.444 V.
  EXPECT_NEAR(highest - 2048, 1.2510 / 1.444 * 1792.0, 1.0);
}

TEST(HeadOptions, ThatCannotPlayNominalVoltageAreRefusedWithTheNumbers) {
  const auto refusal = [](const std::function<void(head::HeadOptions&)>& change) {
    head::HeadOptions options;
    options.port = "tcp://127.0.0.1:1";
    change(options);
    const auto created = head::Head::create(options);
    return created.ok() ? std::string() : created.error();
  };
  EXPECT_EQ(refusal([](head::HeadOptions&) {}), "");
  EXPECT_THAT(refusal([](head::HeadOptions& o) { o.gain = 190.0; }),
              HasSubstr("325.3 V peak, is beyond full scale: 1.444 V at the DAC with a gain of 190 "
                        "is 274.4 V"));
  EXPECT_THAT(refusal([](head::HeadOptions& o) { o.voltage_limit_v = 229.0; }),
              HasSubstr("230 V RMS, is beyond the voltage limit of 229 V RMS"));
  EXPECT_THAT(refusal([](head::HeadOptions& o) { o.gain = 0.0; }), HasSubstr("gain is 0"));
}

TEST(HeadLimits, AreThoseOfTheDacOrTheInterlock) {
  head::HeadOptions options;
  options.port = "tcp://127.0.0.1:1";
  options.voltage_limit_v = 253.0;
  EXPECT_NEAR(head::Head::create(options).take()->source().limits().full_scale_pu, 1.1, 1e-9);
  options.voltage_limit_v = 500.0;
  EXPECT_NEAR(head::Head::create(options).take()->source().limits().full_scale_pu,
              1.444 * 260.0 / (230.0 * std::sqrt(2.0)), 1e-9);
}

}  // namespace
}  // namespace gsbench::test
