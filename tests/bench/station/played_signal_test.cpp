#include "plans.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <app/application.hpp>
#include <station/played_signal.hpp>

namespace gsbench::station {
namespace {

using test::plan;

std::vector<float> rendered(const PlayedSignal& signal, std::int64_t first, std::int64_t count) {
  std::vector<float> samples(static_cast<std::size_t>(count));
  signal.render(first, samples.size(), samples.data());
  return samples;
}

// Starts off-nominal and with a phase offset.
profile::Plan off_nominal_plan() {
  profile::Plan off = plan(2.0, "frequency = [[0.0, 49.8], [2.0, 49.7]]\n");
  off.stimulus.signal.initial_phase_deg = 75.0;
  return off;
}

TEST(PlayedSignal, PlaysThePlansSignalBetweenTheMarkers) {
  const profile::Plan p = plan(1.0);
  std::vector<float> expected(static_cast<std::size_t>(p.duration_ticks()));
  p.synthesizer().render(0, expected.size(), expected.data());
  const PlayedSignal unmarked(p, false);
  EXPECT_EQ(unmarked.lead_ticks(), 0);
  ASSERT_EQ(unmarked.total_ticks(), p.duration_ticks());
  EXPECT_EQ(rendered(unmarked, 0, p.duration_ticks()), expected);
  const PlayedSignal marked(p, true);
  EXPECT_EQ(rendered(marked, marked.lead_ticks(), p.duration_ticks()), expected);
}

TEST(PlayedSignal, KnowsTheFrequencyAndAmplitudeOfItsSamples) {
  const profile::Plan p = off_nominal_plan();
  const PlayedSignal signal(p, true);
  EXPECT_EQ(signal.nominal_hz(), 50);
  EXPECT_EQ(signal.sample_rate_hz(), 8000);
  EXPECT_EQ(signal.noise().seed, p.seed);
  EXPECT_EQ(signal.noise().rms_pu, p.stimulus.noise_rms_pu());
  EXPECT_EQ(signal.frequency_hz(0), 49.8);
  EXPECT_NEAR(signal.frequency_hz(signal.lead_ticks() + 8000), 49.75, 1e-9);
  EXPECT_EQ(signal.frequency_hz(signal.total_ticks() - 1), 50.0);
  const std::int64_t dip = signal.lead_ticks() + signal.markers().before.dips[0].from_tick;
  EXPECT_EQ(signal.amplitude_pu(dip - 1), 1.0);
  EXPECT_NEAR(signal.amplitude_pu(dip), signal.markers().level, 1e-12);
}

TEST(PlayedSignal, DoesNotDependOnTheBlockSize) {
  const PlayedSignal signal(off_nominal_plan(), true);
  const std::vector<float> whole = rendered(signal, 0, signal.total_ticks());
  std::vector<float> pieces;
  for (std::int64_t tick = 0, size = 1; tick < signal.total_ticks(); tick += size, size += 97) {
    const std::vector<float> piece =
        rendered(signal, tick, std::min(size, signal.total_ticks() - tick));
    pieces.insert(pieces.end(), piece.begin(), piece.end());
  }
  EXPECT_EQ(pieces, whole);
}

TEST(PlayedSignal, HasItsDipsAtTheMarkers) {
  const PlayedSignal signal(off_nominal_plan(), true);
  const std::vector<float> whole = rendered(signal, 0, signal.total_ticks());
  const capture::Markers& markers = signal.markers();
  // RMS in p.u. of nominal over about two periods.
  const auto rms = [&](std::int64_t tick) {
    const auto first = static_cast<std::size_t>(tick + signal.lead_ticks());
    double sum = 0.0;
    for (std::size_t i = first; i < first + 321; ++i) {
      sum += static_cast<double>(whole[i]) * static_cast<double>(whole[i]);
    }
    return std::sqrt(2.0 * sum / 321.0);
  };
  for (const capture::MarkedStretch* stretch : {&markers.before, &markers.after}) {
    ASSERT_EQ(stretch->dips.size(), 3U);
    for (const capture::Dip& dip : stretch->dips) {
      EXPECT_NEAR(rms(dip.from_tick), markers.level, 0.01);
      EXPECT_NEAR(rms(dip.to_tick - 321), markers.level, 0.01);
      EXPECT_NEAR(rms(dip.from_tick - 321), 1.0, 0.01);
      EXPECT_NEAR(rms(dip.to_tick), 1.0, 0.01);
      // Within one tick of a zero crossing: |v| < sin(2π · 50/8000).
      EXPECT_LT(std::fabs(whole[static_cast<std::size_t>(dip.from_tick + signal.lead_ticks())]),
                0.04F);
    }
    // The cumulative square sum is that of the rendered samples.
    double sum = 0.0;
    for (std::size_t i = 0; i < stretch->square_sum.size(); ++i) {
      ASSERT_DOUBLE_EQ(stretch->square_sum[i], sum);
      const auto at = static_cast<std::size_t>(stretch->first_tick + signal.lead_ticks()) + i;
      sum += at < whole.size() ? std::pow(static_cast<double>(whole[at]), 2) : 0.0;
    }
  }
  EXPECT_EQ(markers.before.first_tick, -signal.lead_ticks());
  EXPECT_EQ(markers.after.first_tick, off_nominal_plan().duration_ticks());
}

struct Reading {
  std::int64_t tick;
  gs::wire::MeasurementMessage measured;
};

class Listener final : public gs::app::Outbox {
 public:
  void put(const gs::wire::Uplink& message) override {
    if (message.kind == gs::wire::UplinkKind::kMeasurement) {
      readings.push_back({static_cast<std::int64_t>(message.sample), message.measurement});
    }
  }
  std::vector<Reading> readings;
};

TEST(PlayedSignal, HasNoTransientAtTheStartOfTheRun) {
  const PlayedSignal signal(off_nominal_plan(), true);
  Listener listener;
  gs::app::Application node;
  node.start({8000, 50, 20000.0F}, {}, nullptr, listener);
  std::vector<std::int16_t> counts;
  for (const float volts : rendered(signal, 0, signal.lead_ticks() + 8000)) {
    counts.push_back(static_cast<std::int16_t>(std::lround(20000.0F * volts)));
  }
  node.feed(counts.data(), counts.size(), listener);
  int in_first_second = 0;
  for (const Reading& reading : listener.readings) {
    const std::int64_t tick = reading.tick - signal.lead_ticks();
    if (tick < -4000) {
      continue;
    }
    ASSERT_EQ(reading.measured.validity, gs::outlet::Validity::kValid) << "at tick " << tick;
    // 49.8 Hz, falling by 0.05 Hz/s from tick 0. A phase step of one degree would show as 50 mHz.
    EXPECT_NEAR(reading.measured.frequency_hz,
                49.8 - 0.05 / 8000.0 * static_cast<double>(std::max<std::int64_t>(tick, 0)), 0.006)
        << "at tick " << tick;
    EXPECT_NEAR(reading.measured.voltage_pu, 1.0F, 0.01F);
    in_first_second += tick >= 0 ? 1 : 0;
  }
  EXPECT_GE(in_first_second, 62);
}

// A source would play a step of the voltage with an error of its instant, which would count as a
// deviation of the phase.
TEST(PlayedSignal, HasNoStepOfTheVoltageAtTheEndOfTheRun) {
  profile::Plan off = plan(2.0,
                           "frequency = [[0.0, 49.8], [2.0, 49.7]]\n"
                           "[[signal.phase_jump]]\nat_s = 1.0\ndegrees = 40.0\n");
  off.stimulus.signal.initial_phase_deg = 75.0;
  const PlayedSignal signal(off, true);
  const std::int64_t end = signal.lead_ticks() + 16000;
  const std::vector<float> around = rendered(signal, end - 400, 800);
  for (std::size_t i = 1; i + 1 < around.size(); ++i) {
    // The second difference of a sine of 50 Hz is at most 0.00154; a corner from 49.7 to 50 Hz adds
    // 0.00024.
    EXPECT_LE(std::fabs(around[i + 1] - 2.0F * around[i] + around[i - 1]), 0.0018F) << i;
  }
}

}  // namespace
}  // namespace gsbench::station
