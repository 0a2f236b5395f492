// Cases are played alike by any number of threads, and a loss among them is found.
#include <test_support/ieee24.hpp>

#include <stdexcept>

#include <gmock/gmock.h>

#include <immunity/study.hpp>

namespace gsbench::immunity {
namespace {

using test::ieee24;

constexpr std::uint32_t kFew = 130;  // ten of each kind

campaign::Execution on_threads(std::size_t threads) {
  campaign::Execution execution;
  execution.threads = threads;
  return execution;
}

const SettledOutlets& outlets() {
  static const SettledOutlets settled = [] {
    Options options;
    options.cases = kFew;
    return SettledOutlets(ieee24(), options, on_threads(2));
  }();
  return settled;
}

Disturbance drawn(std::uint32_t number) {
  return draw(ieee24().nominal_hz, 1, number);
}

TEST(Immunity, NoOutletTripsInAFewCasesOfEachKind) {
  const Result result = play_all(outlets(), drawn, on_threads(2));
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    EXPECT_EQ(result.kinds[i].cases, 10U) << kKinds[i].name;
    EXPECT_EQ(result.kinds[i].trips, 0U) << kKinds[i].name;
  }
  EXPECT_EQ(result.all().cases, kFew);
  EXPECT_EQ(result.dips().cases, 50U);
}

TEST(Immunity, DoesNotDependOnTheNumberOfThreads) {
  const Result one = play_all(outlets(), drawn, on_threads(1));
  const Result three = play_all(outlets(), drawn, on_threads(3));
  EXPECT_GT(one.all().events, 0U) << "oscillations look like a change of the frequency";
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    EXPECT_EQ(one.kinds[i].events, three.kinds[i].events) << kKinds[i].name;
    EXPECT_EQ(one.kinds[i].first_failing, three.kinds[i].first_failing) << kKinds[i].name;
  }
  const SettledOutlets others(ieee24(), outlets().options(), on_threads(1));
  for (const std::uint32_t number : {11U, 12U}) {
    EXPECT_EQ(others.play(drawn(number), number).event_s,
              outlets().play(drawn(number), number).event_s);
  }
}

// The check itself can fail: with a real loss, the same case has an event and a trip.
TEST(Immunity, FindsALossAmongTheCases) {
  for (std::uint32_t lossy = 40; lossy < 40 + kKinds.size(); ++lossy) {
    const auto with_loss = [&](std::uint32_t number) {
      Disturbance d = drawn(number);
      if (number == lossy) {
        d.losses = {{d.end_s + 0.2, 600.0}};
        d.end_s += 0.2;
      }
      return d;
    };
    const Outcome outcome = outlets().play(with_loss(lossy), lossy);
    const double loss_s = with_loss(lossy).end_s;
    EXPECT_TRUE(outcome.event_s.has_value());
    ASSERT_TRUE(outcome.trip_s.has_value()) << kKinds[lossy % kKinds.size()].name;
    // Sooner than 0.7 s after the loss if the disturbance was still being decided.
    EXPECT_GT(*outcome.trip_s, loss_s + 0.2);
    EXPECT_LT(*outcome.trip_s, loss_s + 2.0);
    EXPECT_FALSE(outlets().play(drawn(lossy), lossy).trip_s.has_value());
  }
  const auto with_loss = [](std::uint32_t number) {
    Disturbance d = drawn(number);
    if (number == 42) {
      d.losses = {{d.end_s, 600.0}};
    }
    return d;
  };
  const Result result = play_all(outlets(), with_loss, on_threads(2));
  EXPECT_EQ(result.all().trips, 1U);
  EXPECT_EQ(result.kinds[42 % kKinds.size()].first_failing, 42U);
  EXPECT_FALSE(result.passes());
}

// So that a pass says something about outlets that measure.
TEST(Immunity, OutletsShedAfterALossAtTheLargestNoise) {
  Options options;
  options.noise_pct = kMostNoise_pct;
  const SettledOutlets noisy(ieee24(), options, on_threads(2));
  Disturbance loss;
  loss.losses = {{10.3, 600.0}};
  loss.begin_s = 10.3;
  loss.end_s = 10.3;
  for (std::uint32_t number = 0; number < 128; ++number) {
    const Outcome outcome = noisy.play(loss, number);
    ASSERT_TRUE(outcome.trip_s.has_value()) << number;
    EXPECT_LT(*outcome.trip_s, 10.3 + 2.0) << number;
  }
}

TEST(Immunity, PassesWithoutTripsAndWithOneEventInThousandDips) {
  Result result;
  result.kinds[0].cases = 1999;
  result.kinds[4].cases = 1;
  result.kinds[11].cases = 1000;
  result.kinds[11].events = 900;
  EXPECT_TRUE(result.passes()) << "events of oscillations have no limit";
  result.kinds[0].events = 1;
  result.kinds[4].events = 1;
  EXPECT_TRUE(result.passes()) << "two in 2000";
  result.kinds[0].events = 2;
  EXPECT_FALSE(result.passes());
  result.kinds[0].events = 0;
  result.kinds[11].trips = 1;
  EXPECT_FALSE(result.passes());
}

TEST(Immunity, NamesTheFirstTripAndForDipsElseTheFirstEvent) {
  // The first dip is a loss that is an event but needs no shedding, the others need it.
  const auto few = [](std::uint32_t number) {
    Disturbance d = drawn(number);
    if (number % kKinds.size() == 0) {
      d.signal = {};
      d.losses = {{d.begin_s, number == 0 ? 100.0 : 600.0}};
      d.end_s = d.begin_s;
    }
    return d;
  };
  const Result result = play_all(outlets(), few, on_threads(2));
  EXPECT_EQ(result.kinds[0].events, 10U);
  EXPECT_EQ(result.kinds[0].trips, 9U);
  EXPECT_EQ(result.kinds[0].first_failing, kKinds.size()) << "not case 0, which has only an event";
}

TEST(Immunity, CountsOnlyPlayedCasesAfterAStop) {
  const std::atomic<bool> stop{true};
  campaign::Execution stopped;
  stopped.stop = &stop;
  EXPECT_EQ(play_all(outlets(), drawn, stopped).all().cases, 0U);
}

TEST(Immunity, RefusesImpossibleOptions) {
  const auto settle = [](std::uint32_t cases, double noise_pct, double accumulated_mw) {
    Options options;
    options.cases = cases;
    options.noise_pct = noise_pct;
    options.accumulated_mw = accumulated_mw;
    SettledOutlets(ieee24(), options, on_threads(1));
  };
  EXPECT_THROW(settle(0, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(settle(kMostCases + 1, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(settle(1, -0.1, 0.0), std::invalid_argument);
  EXPECT_THROW(settle(1, kMostNoise_pct + 0.1, 0.0), std::invalid_argument);
  EXPECT_THROW(settle(1, 1.0, -0.1), std::invalid_argument);
  EXPECT_THROW(settle(1, 1.0, 1053.64), std::invalid_argument);
  EXPECT_NO_THROW(settle(1, kMostNoise_pct, 1053.63));
}

}  // namespace
}  // namespace gsbench::immunity
