// The output of emulated generators, step by step.
#include "generator_bench.hpp"

#include <random>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using emulation::GeneratorFunction;
using emulation::GeneratorModel;
using testing::Each;
using testing::ElementsAre;
using Codes = std::vector<std::int16_t>;

constexpr double kTau = 6.283185307179586;

// 2 V peak at 50 Hz into an open circuit.
const std::vector<std::string> kSine = {"OUTP:LOAD INF", "VOLT 4", "FREQ 50", "OUTP ON"};

TEST(GeneratorOutput, IsTheMeanOfASineOverEachStepInItsOwnTime) {
  GeneratorBench bench(GeneratorModel::k33522b, 100.0);
  bench.say(kSine);
  bench.say({"BURS:NCYC INF", "TRIG:SOUR BUS", "BURS:STAT ON", "OUTP ON"});
  EXPECT_THAT(bench.output(1), ElementsAre(0.0));
  bench.client->say("*TRG");
  EXPECT_EQ(bench.ask("OUTP?"), "1");
  const std::vector<double> volts = bench.output(10 * 64000);
  const auto mean = [](std::size_t step, double ppm) {
    const double turns = 50 * (1 + ppm * 1e-6) / 64000;
    const double from = kTau * turns * static_cast<double>(step);
    return 2 * (std::cos(from) - std::cos(from + kTau * turns)) / (kTau * turns);
  };
  double worst = 0;
  double without_clock_error = 0;
  for (std::size_t i = 0; i < volts.size(); ++i) {
    worst = std::max(worst, std::abs(volts[i] - mean(i, 100)));
    without_clock_error = std::max(without_clock_error, std::abs(volts[i] - mean(i, 0)));
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_NEAR(without_clock_error, 2 * 2 * std::sin(kTau * 0.05 / 2), 0.01);  // 0.05 cycles in 10 s
}

// Against sums over 1000 instants of each step.
class GeneratorPoints : public testing::TestWithParam<bool> {};

TEST_P(GeneratorPoints, AreHeldOrJoinedWithExactMeans) {
  const bool joined = GetParam();
  GeneratorBench bench(GeneratorModel::k33522b, -50.0);
  Codes codes(97);
  std::mt19937 random(1);
  for (auto& code : codes) {
    code = static_cast<std::int16_t>(static_cast<int>(random() % 60001) - 30000);
  }
  bench.say({"OUTP:LOAD INF", "VOLT 4", "FORM:BORD SWAP",
             "DATA:ARB:DAC points, " + block(bytes_of(codes)), "FUNC:ARB points",
             joined ? "FUNC:ARB:FILT NORM" : "FUNC:ARB:FILT OFF"});
  // 0.16, 1.6 and 160 points a step.
  for (const double rate_hz : {10240.0, 102400.0, 10240000.0}) {
    bench.say({"OUTP OFF", "FUNC SIN", "FUNC:ARB:SRAT " + std::to_string(rate_hz), "FUNC ARB",
               "OUTP ON"});
    const std::vector<double> volts = bench.output(300);
    constexpr int kInstants = 1000;
    for (std::size_t step = 0; step < volts.size(); ++step) {
      double sum = 0;
      for (int i = 0; i < kInstants; ++i) {
        const double time_s = (static_cast<double>(step) + (i + 0.5) / kInstants) / 64000;
        const double at = std::fmod(time_s * rate_hz * (1 - 50e-6), 97.0);
        const auto point = static_cast<std::size_t>(at);
        const double part = joined ? at - static_cast<double>(point) : 0.0;
        sum += codes[point] * (1 - part) + codes[(point + 1) % 97] * part;
      }
      // The sum misses a jump by half an instant.
      const double tolerance = 2 * 2.0 * std::max(1.0, rate_hz / 64000) / kInstants;
      ASSERT_NEAR(volts[step], sum / kInstants * 2 / 32767, tolerance) << rate_hz << " " << step;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(HeldAndJoined, GeneratorPoints, testing::Bool());

TEST(GeneratorOutput, HasTheMeansOfSquareAndRamp) {
  GeneratorBench bench(GeneratorModel::k33522b);
  bench.say({"OUTP:LOAD INF", "VOLT 4", "VOLT:OFFS 1", "FUNC SQU", "FUNC:SQU:DCYC 25", "FREQ 640",
             "OUTP ON"});
  const std::vector<double> square = bench.output(100);
  EXPECT_NEAR(square[10], 3.0, 1e-6);
  EXPECT_NEAR(square[60], -1.0, 1e-6);
  bench.say({"FUNC RAMP", "FUNC:RAMP:SYMM 80"});
  const std::vector<double> ramp = bench.output(100);
  EXPECT_NEAR(ramp[40], 1 + 2 * (2 * 40.5 / 80 - 1), 1e-5);
  EXPECT_NEAR(ramp[90], 1 + 2 * (1 - 2 * 10.5 / 20), 1e-5);
  bench.say({"FUNC DC"});
  EXPECT_NEAR(bench.mean(10), 1.0, 1e-6);
}

TEST(GeneratorOutput, IsZeroWhenSwitchedOff) {
  GeneratorBench bench(GeneratorModel::k33522b);
  bench.say({"VOLT:OFFS 1", "OUTP ON"});
  EXPECT_GT(bench.mean(64), 1.9);  // twice the offset: nothing but an open circuit is connected
  bench.say({"OUTP OFF"});
  EXPECT_THAT(bench.output(1000), Each(0.0));
}

TEST(GeneratorOutput, GoesOnWithItsPhaseWhenFrequencyOrAmplitudeChange) {
  GeneratorBench bench(GeneratorModel::k33522b);
  bench.say(kSine);
  const std::vector<double> before = bench.output(333);
  bench.say({"FREQ 51"});
  const std::vector<double> after = bench.output(1);
  EXPECT_NEAR(after[0] - before.back(), before[332] - before[331], 0.002);
  bench.say({"VOLT 2"});
  EXPECT_NEAR(bench.output(1)[0], after[0] / 2, 0.01);
}

TEST(GeneratorOutput, FollowsTheFrontPanel) {
  GeneratorBench bench(GeneratorModel::kSdg2042x);
  emulation::PanelChange change;
  change.output_on = true;
  change.amplitude_vpp = 3.0;
  change.function = GeneratorFunction::kSquare;
  change.frequency_hz = 0.5;
  bench.generator->press(change);
  EXPECT_NEAR(bench.mean(100), 1.5, 1e-6);
  EXPECT_EQ(bench.ask("C1:OUTP?"), "C1:OUTP ON,LOAD,HZ,PLRT,NOR");
  change = {};
  change.load_ohm = 50.0;
  bench.generator->press(change);
  EXPECT_NEAR(bench.settings().amplitude_vpp, 1.5, 1e-12);
  EXPECT_NEAR(bench.mean(100), 1.5, 1e-6);
}

TEST(GeneratorOutput, CommandsTakeEffectNowAndNotBefore) {
  emulation::GeneratorOptions options;
  options.model = GeneratorModel::k33522b;
  const auto generator = emulation::Generator::start(options).take();
  GeneratorClient client(generator->port());
  client.say("FUNC DC;:VOLT:OFFS 1");
  EXPECT_EQ(client.ask("OUTP?"), "0");
  float first = 0;
  generator->render(0, 1, &first);
  const std::int64_t before = options.time.now();
  EXPECT_EQ(client.ask("OUTP ON;OUTP?"), "1");
  const std::int64_t after = options.time.now();
  std::vector<float> volts(static_cast<std::size_t>(after + 10));
  generator->render(1, volts.size(), volts.data());
  const auto on = std::find_if(volts.begin(), volts.end(), [](float volt) { return volt > 1.0F; });
  const std::int64_t step = on - volts.begin() + 1;
  EXPECT_GE(step, before);
  EXPECT_LE(step, after);
}

}  // namespace
}  // namespace gsbench::test
