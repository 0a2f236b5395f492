// The emulated relay sense at the outlets' terminals: where it puts tick 0, and what it says if it
// cannot.
#include <test_support/clocked_source.hpp>

#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include <emulation/terminal_sense.hpp>

namespace gsbench::test {
namespace {

using emulation::DipFinder;
using emulation::TerminalSense;
using emulation::TrueTime;
using testing::HasSubstr;

constexpr double kTurn = 6.283185307179586;

// Nominal voltage of 50 Hz with a dip to 60 % from 0.5 s to 0.7 s.
struct WithADip final : source::Stimulus {
  double voltage_pu(double t_s) const {
    return (t_s >= 0.5 && t_s < 0.7 ? 0.6 : 1.0) * std::sin(kTurn * (50.0 * t_s + phase_turns));
  }
  std::int64_t sample_rate_hz() const override { return 8000; }
  std::int64_t total_ticks() const override { return 8000; }
  int nominal_hz() const override { return 50; }
  source::Noise noise() const override { return {}; }
  double frequency_hz(std::int64_t) const override { return 50.0; }
  double amplitude_pu(std::int64_t tick) const override {
    return has_dip && tick >= 4000 && tick < 5600 ? 0.6 : 1.0;
  }
  void render(std::int64_t first_tick, std::size_t count, float* out) const override {
    for (std::size_t i = 0; i < count; ++i) {
      out[i] = static_cast<float>(
          voltage_pu(static_cast<double>(first_tick + static_cast<std::int64_t>(i)) / 8000.0));
    }
  }
  bool has_dip = true;
  double phase_turns = 0.0;  // of the voltage at the start of the dip
};

class AtTheTerminals : public testing::Test {
 protected:
  // Silence, a soft rise over 0.5 s, nominal voltage, then the stimulus from `start_s` on, with the
  // source's clock 200 ppm fast, at `scale` of its voltage.
  void play(double start_s, double scale, double noise_pu = 0.0) {
    play(sense_, start_s, scale, noise_pu);
  }
  void play(TerminalSense& sense, double start_s, double scale, double noise_pu) const {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<float> pu(static_cast<std::size_t>((start_s + 1.0) * TrueTime::kRate_hz));
    for (std::size_t step = 0; step < pu.size(); ++step) {
      const double t_s = (static_cast<double>(step) + 0.5) / TrueTime::kRate_hz;
      const double rise = std::min(std::max((t_s - 0.2) / 0.5, 0.0), 1.0);
      pu[step] =
          static_cast<float>(scale * rise * stimulus_.voltage_pu((t_s - start_s) * (1.0 + 200e-6)) +
                             noise_pu * noise(random));
    }
    for (std::size_t step = 0; step < pu.size(); step += 128) {
      sense.seen(pu.data() + step, std::min<std::size_t>(128, pu.size() - step));
    }
  }
  double tick_0_s() const { return sense_.alignment().count_at_tick_0 / TrueTime::kRate_hz; }

  WithADip stimulus_;
  ClockedSource source_;
  TrueTime time_;
  TerminalSense sense_{stimulus_, source_, 200.0, time_};
};

TEST_F(AtTheTerminals, TheDipGivesTick0WithinTenMicroseconds) {
  play(1.2345, 1.0);
  EXPECT_NEAR(tick_0_s(), 1.2345, 10e-6);
  EXPECT_NEAR(sense_.alignment().counts_per_tick, 8.0 * (1.0 - 200e-6), 1e-6);
}

// The source's clock on this machine, which is 10 ms wrong here, has no influence.
TEST_F(AtTheTerminals, TheDipGivesTheTickOfAnInstantOfThisMachine) {
  source_.clock = {time_.start + std::chrono::milliseconds(1010), 1.0 / 8000.0, 0.01};
  play(1.0, 1.0);
  const auto count = sense_.count_at(time_.start + std::chrono::milliseconds(2000));
  // 0.2 ms of 1 s: the source's clock is fast. Half a tick of rounding for each.
  EXPECT_NEAR(static_cast<double>(sense_.alignment().tick_of(count.value())), 8001.6, 0.5);
  EXPECT_NEAR(sense_.alignment().uncertainty_between_ticks, 1.5, 1e-9);
}

TEST_F(AtTheTerminals, AnErrorOfTheAmplitudeDoesNotMoveTick0) {
  play(1.5, 0.97);
  EXPECT_NEAR(tick_0_s(), 1.5, 20e-6);
}

TEST_F(AtTheTerminals, NoiseMovesTick0WithinTheStatedUncertainty) {
  play(1.5, 1.0, 0.01);
  EXPECT_NEAR(tick_0_s(), 1.5, sense_.alignment().uncertainty_ticks / 8000.0);
  EXPECT_NEAR(sense_.alignment().uncertainty_ticks, 2.4 + 1.0, 1e-9);
}

// A dip need not start at a zero crossing. Elsewhere it is a step, whose instant is known to half a
// tick, 62.5 µs.
TEST_F(AtTheTerminals, ADipAtAnyPhaseGivesTick0) {
  for (double phase_turns = 0.0; phase_turns < 1.0; phase_turns += 1.0 / 24.0) {
    stimulus_.phase_turns = phase_turns;
    for (const auto& [noise_pu, within_s] : {std::pair(0.0, 75e-6), std::pair(0.01, 300e-6)}) {
      TerminalSense sense(stimulus_, source_, 200.0, time_);
      play(sense, 1.3, 1.0, noise_pu);
      EXPECT_NEAR(sense.alignment().count_at_tick_0 / TrueTime::kRate_hz, 1.3, within_s)
          << phase_turns << ", noise " << noise_pu;
    }
  }
}

TEST_F(AtTheTerminals, EdgesWaitForTheDip) {
  std::vector<relay::Edge> edges;
  sense_.moved(3, 1000, false);
  EXPECT_TRUE(sense_.poll(edges).ok());
  EXPECT_TRUE(edges.empty());
  play(1.5, 1.0);
  sense_.moved(1, 2 * TrueTime::kRate_hz, true);
  EXPECT_TRUE(sense_.poll(edges).ok());
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].channel, 3U);
  EXPECT_TRUE(edges[1].closed);
  // 2 s is tick 4000 from 1.5 s on, of a clock that is 200 ppm fast: 0.8 ticks more.
  EXPECT_NEAR(static_cast<double>(sense_.alignment().tick_of(edges[1].count)), 4000.8, 1.0);
}

TEST_F(AtTheTerminals, WithoutADipTheSourcesClockOnTheHostGivesTick0) {
  stimulus_.has_dip = false;
  TerminalSense sense(stimulus_, source_, 0.0, time_);
  EXPECT_FALSE(sense.is_aligned_by_dips());
  EXPECT_TRUE(sense_.is_aligned_by_dips());
  source_.known.host_clock_uncertainty_s = 0.01;
  EXPECT_NEAR(sense.alignment().uncertainty_ticks, 81.0, 1e-9) << "as later in the run";
  EXPECT_NE(sense.not_known_yet(), "");
  EXPECT_EQ(sense_.not_known_yet(), "");
  std::vector<relay::Edge> edges;
  sense.moved(0, 100, false);
  EXPECT_TRUE(sense.poll(edges).ok());
  EXPECT_TRUE(edges.empty()) << "before the start";
  source_.clock = {time_.start + std::chrono::milliseconds(1500), 1.0 / 8000.0, 0.01};
  EXPECT_TRUE(sense.poll(edges).ok());
  EXPECT_EQ(edges.size(), 1U);
  EXPECT_NEAR(sense.alignment().count_at_tick_0, 1.5 * 64000, 1e-3);
  EXPECT_NEAR(sense.alignment().uncertainty_ticks, 81.0, 1e-9);
}

TEST_F(AtTheTerminals, ADipThatDoesNotComeIsAnError) {
  std::vector<relay::Edge> edges;
  const auto now = std::chrono::steady_clock::now();
  source_.clock = {now - std::chrono::milliseconds(400), 1.0 / 8000.0, 0.001};
  EXPECT_TRUE(sense_.poll(edges).ok()) << "not yet due";
  source_.clock = {now - std::chrono::seconds(3), 1.0 / 8000.0, 0.001};
  EXPECT_THAT(sense_.poll(edges).error(), HasSubstr("dip of the stimulus was not seen"));
}

}  // namespace
}  // namespace gsbench::test
