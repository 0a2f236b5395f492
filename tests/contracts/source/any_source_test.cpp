// The contract suite of sources. A new driver needs a rig and a line below.
#include "rigs.hpp"
#include <test_support/mains.hpp>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using ::testing::HasSubstr;

class AnySource : public testing::TestWithParam<std::unique_ptr<SourceRig> (*)()> {
 protected:
  AnySource() { mains_.duration_s = 2.0; }

  source::Source& source() { return rig_->source(); }

  // The calls in their order; each is refused unless it is the next one.
  std::vector<std::pair<std::string, std::function<bool()>>> calls() {
    return {{"prepare", [this] { return source().prepare(mains_).ok(); }},
            {"energise", [this] { return source().energise().ok(); }},
            {"start", [this] { return source().start().ok(); }},
            {"stop", [this] { return source().stop().ok(); }}};
  }

  // The error of prepare(); check() must agree.
  std::string refusal(const source::Stimulus& stimulus) {
    const auto checked = source().check(stimulus);
    const auto prepared = source().prepare(stimulus);
    EXPECT_EQ(checked.ok(), prepared.ok());
    return prepared.ok() ? "" : prepared.error();
  }

  Mains mains_;
  std::unique_ptr<SourceRig> rig_ = GetParam()();
};

INSTANTIATE_TEST_SUITE_P(Simulated, AnySource, testing::Values(&simulated_source));
INSTANTIATE_TEST_SUITE_P(Emulated, AnySource, testing::Values(&emulated_mains));
INSTANTIATE_TEST_SUITE_P(Head, AnySource, testing::Values(&head_source));
INSTANTIATE_TEST_SUITE_P(Scpi, AnySource, testing::Values(&scpi_source));
INSTANTIATE_TEST_SUITE_P(Loaded, AnySource, testing::Values(&loaded_source));
INSTANTIATE_TEST_SUITE_P(Stepped, AnySource, testing::Values(&stepped_source));

TEST_P(AnySource, StatesItsLimits) {
  const source::Limits limits = source().limits();
  EXPECT_NE(limits.name, "");
  EXPECT_GT(limits.full_scale_pu, 1.0);
  EXPECT_GT(limits.longest_s, 0.0);
  EXPECT_THAT(limits.sample_rates_hz, testing::Contains(8000));
  EXPECT_THAT(limits.nominal_hz, testing::Contains(50));
}

TEST_P(AnySource, PlaysTheStimulusWithinTheStatedDeviation) {
  mains_.level_pu = 0.9;
  mains_.falls_hz_s = 0.5;
  const auto promised = source().check(mains_);
  ASSERT_TRUE(promised.ok()) << promised.error();
  start(source(), mains_);
  for (std::int64_t tick = 0; tick < mains_.total_ticks();) {
    const std::int64_t until = std::min<std::int64_t>(tick + 777, mains_.total_ticks());
    const auto played = source().advance(until);
    ASSERT_TRUE(played.ok()) << played.error();
    EXPECT_GE(played.value(), until);
    EXPECT_LE(played.value(), mains_.total_ticks());
    tick = played.value();
  }
  EXPECT_TRUE(source().stop().ok());
  int read = 0;
  for (const Reading& reading : rig_->readings()) {
    // The tracker settles for 0.2 s after its start, and after the corner at 1 s. Its window
    // reaches into the nominal voltage that a streamed source plays after the stimulus.
    if (reading.tick % 8000 < 1600 || reading.tick > mains_.total_ticks() - 200) {
      continue;
    }
    ++read;
    EXPECT_NEAR(reading.frequency_hz, mains_.frequency_hz(reading.tick),
                promised.value().frequency_hz + 0.5 * promised.value().time_s + 0.003)
        << "at tick " << reading.tick;
    // The outlet's RMS is over whole nominal periods: 0.5 % off at 49.5 Hz.
    EXPECT_NEAR(reading.voltage_pu, 0.9,
                promised.value().voltage_pu + promised.value().amplitude_pu + 0.006)
        << "at tick " << reading.tick;
  }
  // 100 reports in these 1.6 s.
  EXPECT_GE(read, 90);
}

TEST_P(AnySource, DoesNotPlayTheStimulusBeforeStart) {
  ASSERT_TRUE(source().prepare(mains_).ok());
  ASSERT_TRUE(source().energise().ok());
  for (const Reading& reading : rig_->readings()) {
    EXPECT_LT(reading.tick, 0);
  }
}

TEST_P(AnySource, RefusesCallsOutOfOrder) {
  for (std::size_t done = 0; done <= calls().size(); ++done) {
    for (std::size_t call = 0; call < calls().size(); ++call) {
      if (call != done) {
        EXPECT_FALSE(calls()[call].second()) << calls()[call].first << " as call " << done;
      }
    }
    const bool playing = done == 3;
    EXPECT_EQ(source().advance(100).ok(), playing) << "advance as call " << done;
    EXPECT_TRUE(done == calls().size() || calls()[done].second()) << calls()[done].first;
  }
}

TEST_P(AnySource, NamesTheRefusedCallAndItsState) {
  EXPECT_THAT(source().advance(1).error(), HasSubstr("cannot advance while off"));
  EXPECT_THAT(source().advance(1).error(), HasSubstr(source().limits().name));
}

TEST_P(AnySource, CanBeMadeSafeAtAnyTimeAndPreparedAgain) {
  for (std::size_t done = 0; done <= calls().size(); ++done) {
    for (std::size_t call = 0; call < done; ++call) {
      EXPECT_TRUE(calls()[call].second()) << calls()[call].first << " of " << done;
    }
    EXPECT_TRUE(source().make_safe().ok());
    EXPECT_TRUE(source().make_safe().ok());
    for (std::size_t call = 1; call < calls().size(); ++call) {
      EXPECT_FALSE(calls()[call].second()) << calls()[call].first << " after make_safe";
    }
    EXPECT_FALSE(source().advance(1).ok());
  }
}

TEST_P(AnySource, RefusesAllButStopAndMakeSafeOnceInterrupted) {
  std::atomic<bool> stop{false};
  source().end_calls_if(&stop);
  const auto expect_refused = [&](const auto& done) {
    ASSERT_FALSE(done.ok());
    EXPECT_THAT(done.error(), HasSubstr(source().limits().name + ": interrupted"));
    EXPECT_TRUE(source().was_interrupted());
  };
  stop = true;
  expect_refused(source().prepare(mains_));
  EXPECT_TRUE(source().make_safe().ok());
  EXPECT_FALSE(source().was_interrupted());
  stop = false;
  ASSERT_TRUE(source().prepare(mains_).ok());
  stop = true;
  expect_refused(source().energise());
  stop = false;
  ASSERT_TRUE(source().energise().ok());
  stop = true;
  expect_refused(source().hold());
  expect_refused(source().start());
  stop = false;
  ASSERT_TRUE(source().start().ok());
  advance(source(), 8000);
  stop = true;
  expect_refused(source().advance(mains_.total_ticks()));
  EXPECT_TRUE(source().make_safe().ok());
  source().end_calls_if(nullptr);
  EXPECT_TRUE(source().prepare(mains_).ok());
}

TEST_P(AnySource, PlaysAgainAfterMakeSafe) {
  start(source(), mains_);
  advance(source(), 8000);
  const std::size_t read = rig_->readings().size();
  ASSERT_TRUE(source().make_safe().ok());
  start(source(), mains_);
  advance(source(), 8000);
  EXPECT_GT(rig_->readings().size(), read + 40);
}

TEST_P(AnySource, RefusesToAdvanceToAWrongTick) {
  start(source(), mains_);
  const auto played = source().advance(100);
  ASSERT_TRUE(played.ok()) << played.error();
  for (const std::int64_t tick :
       {std::int64_t{-1}, std::int64_t{0}, played.value(), mains_.total_ticks() + 1}) {
    const auto refused = source().advance(tick);
    ASSERT_FALSE(refused.ok()) << tick;
    EXPECT_THAT(refused.error(), HasSubstr("to tick " + std::to_string(tick) + ": it is at tick " +
                                           std::to_string(played.value()) + " of 16000"));
  }
  const auto rest = source().advance(mains_.total_ticks());
  ASSERT_TRUE(rest.ok()) << rest.error();
  EXPECT_EQ(rest.value(), mains_.total_ticks());
  EXPECT_FALSE(source().advance(mains_.total_ticks()).ok());
}

TEST_P(AnySource, RefusesUnsupportedSampleRatesAndNominalFrequencies) {
  mains_.rate = 8001;
  EXPECT_THAT(refusal(mains_), HasSubstr("a sample rate of 8001 Hz is not supported; supported: "));
  mains_.rate = 8000;
  mains_.nominal = 47;
  EXPECT_THAT(refusal(mains_),
              HasSubstr("a nominal frequency of 47 Hz is not supported; supported: "));
  mains_.nominal = 50;
  EXPECT_EQ(refusal(mains_), "");
}

TEST_P(AnySource, RefusesAStimulusThatIsTooShortOrTooLong) {
  mains_.duration_s = 1.0 / 8000.0;
  EXPECT_THAT(refusal(mains_), HasSubstr("a stimulus of 1 ticks"));
  const double longest_s = source().limits().longest_s;
  if (std::isfinite(longest_s)) {
    mains_.duration_s = longest_s + 1.0 / 8000.0;
    EXPECT_THAT(refusal(mains_),
                HasSubstr("ticks (" + std::to_string(mains_.total_ticks() / 8000)));
    mains_.duration_s = longest_s;
  } else {
    mains_.duration_s = 2.0;
  }
  EXPECT_EQ(refusal(mains_), "");
}

// A nominal voltage except for one sample.
struct Spike final : Mains {
  Spike(const Mains& around, float voltage_pu) : Mains(around), spike_pu(voltage_pu) {}
  void render(std::int64_t first_tick, std::size_t count, float* out) const override {
    Mains::render(first_tick, count, out);
    if (first_tick <= 5000 && 5000 < first_tick + static_cast<std::int64_t>(count)) {
      out[5000 - first_tick] = spike_pu;
    }
  }
  float spike_pu;
};

// The error of prepare() or, for a streamed source, of advance().
std::string refusal_to_play(source::Source& source, const source::Stimulus& stimulus) {
  const auto prepared = source.prepare(stimulus);
  if (!prepared.ok()) {
    return prepared.error();
  }
  EXPECT_EQ(source.limits().kind, source::Kind::kStreamed);
  EXPECT_TRUE(source.energise().ok());
  EXPECT_TRUE(source.start().ok());
  const auto played = source.advance(stimulus.total_ticks());
  return played.ok() ? "" : played.error();
}

TEST_P(AnySource, RefusesSamplesBeyondFullScale) {
  const auto full_scale = static_cast<float>(source().limits().full_scale_pu);
  for (const float beyond :
       {1.0001F * full_scale, -1.0001F * full_scale, std::numeric_limits<float>::infinity(),
        std::numeric_limits<float>::quiet_NaN()}) {
    const Spike spike(mains_, beyond);
    const auto refused =
        testing::AllOf(HasSubstr(" at 0.6250 s"), HasSubstr("is beyond its full scale of "));
    const auto checked = source().check(spike);
    EXPECT_THAT(checked.ok() ? "" : checked.error(), refused) << beyond;
    EXPECT_THAT(refusal_to_play(source(), spike), refused) << beyond;
    EXPECT_FALSE(source().stop().ok()) << "nothing is played";
    EXPECT_TRUE(source().make_safe().ok());
  }
  EXPECT_EQ(refusal(Spike(mains_, full_scale)), "");
}

}  // namespace
}  // namespace gsbench::test
