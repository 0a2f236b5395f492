// Instructions that the Cortex-M4F image executes for each sample, counted by qemu: with -icount
// the emulated time advances by a constant for each instruction, so that the counts are the same on
// every machine.
#include "counting.hpp"
#include "played.hpp"
#include <cortex_m4/beside.hpp>
#include <cortex_m4/emulated_outlet.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <numeric>

#include <gtest/gtest.h>

namespace gs::test {
namespace {

constexpr std::uint32_t kSecond = 8000;  // samples
// An instruction takes 2^8 ns, and a tick of SysTick 40 ns, the 25 MHz of the board. Counts are
// thus exact: both readings of the counter are right within a tick.
constexpr const char* kShift = "shift=8";
constexpr double kTicksPerInstruction = 256.0 / 40.0;
constexpr double kClock_hz = 168e6;  // of an STM32F405: 21 000 cycles in a sample
constexpr double kMostInEvent = 5250.0;
constexpr std::uint32_t kMostInSample = 21'000;
constexpr std::uint32_t kFramesCapacity = 1U << 17U;

class InstructionCounts : public testing::Test {
 protected:
  InstructionCounts() {
    outlet_.start(GSBENCH_M4_IMAGE, {"-icount", kShift});
    outlet_.line().wait_for(wire::UplinkKind::kHello);
    program_ =
        std::make_unique<ProgramBeside>(outlet_.machine(), GSBENCH_COUNT_TICKS, "count_ticks");
    const std::uint32_t none = 0;
    one_tick_count_ = program_->put(bytes_of(&none));
    CountingArguments nothing;
    nothing.ticks = one_tick_count_;
    nothing_ = ticks_of(nothing).front();
  }

  // Returns the arguments as they are afterwards.
  CountingArguments call(const CountingArguments& arguments) {
    const std::uint32_t address = program_->put(bytes_of(&arguments));
    program_->call(address);
    std::vector<CountingArguments> after(1);
    program_->get(address, after);
    return after.front();
  }
  std::vector<std::uint32_t> ticks_of(CountingArguments arguments) {
    arguments.count = std::max(arguments.count, 1U);
    call(arguments);
    std::vector<std::uint32_t> ticks(arguments.count);
    program_->get(arguments.ticks, ticks);
    return ticks;
  }
  std::uint32_t instructions(std::uint32_t ticks) const {
    return static_cast<std::uint32_t>(
        std::lround((static_cast<double>(ticks) - nothing_) / kTicksPerInstruction));
  }

  EmulatedOutlet outlet_;
  std::unique_ptr<ProgramBeside> program_;
  std::uint32_t one_tick_count_ = 0;
  std::uint32_t nothing_ = 0;  // ticks between two readings of the counter
};

TEST_F(InstructionCounts, OfAKnownLoopAreExact) {
  CountingArguments loop;
  loop.counted = Counted::kLoop;
  loop.ticks = one_tick_count_;
  std::vector<std::uint32_t> counts;
  for (const std::uint32_t rounds : {1U, 2U, 3U, 1000U, 1001U, 100'000U}) {
    loop.rounds = rounds;
    counts.push_back(instructions(ticks_of(loop).front()) - 2 * rounds);
  }
  std::cout << "nothing: " << nothing_ << " ticks; loop: " << counts[0] << " more\n";
  EXPECT_LE(counts[0], 1U);  // the number of rounds is loaded
  EXPECT_EQ(counts, std::vector<std::uint32_t>(counts.size(), counts[0]));
}

double mean(const std::vector<std::uint32_t>& counts, std::size_t from, std::size_t end) {
  const auto begin = counts.begin();
  return std::accumulate(begin + static_cast<std::ptrdiff_t>(from),
                         begin + static_cast<std::ptrdiff_t>(end), 0.0) /
         static_cast<double>(end - from);
}

// The greatest mean of a second.
double busiest_second(const std::vector<std::uint32_t>& counts) {
  double most = 0.0;
  for (std::size_t from = 0; from + kSecond <= counts.size(); from += kSecond / 50) {
    most = std::max(most, mean(counts, from, from + kSecond));
  }
  return most;
}

// The share of a sample's time at one instruction in each cycle.
double share_pct(double count) {
  return 100.0 * count * kSampleRate_hz / kClock_hz;
}

// The sample whose report sent the first message of the kind, not before `from`; or SIZE_MAX.
std::size_t sample_of(const std::vector<wire::Uplink>& messages, wire::UplinkKind kind,
                      std::size_t from) {
  for (const wire::Uplink& message : messages) {
    if (message.kind == kind && message.sample > from) {
      return static_cast<std::size_t>(message.sample) - 1;
    }
  }
  return SIZE_MAX;
}

class InstructionsPerSample : public InstructionCounts,
                              public testing::WithParamInterface<const char*> {
 protected:
  struct Result {
    std::vector<std::uint32_t> counts;
    Bytes frames;
  };

  // Of the image. In pieces of a second, so that each call is over soon.
  Result there(const Played& played) {
    CountingArguments arguments;
    arguments.counted = Counted::kStart;
    arguments.hardware = played.hardware;
    arguments.settings = played.settings;
    arguments.outlet = program_->put(Bytes(kOutletBytes, 0xA5));
    arguments.frames = program_->put(Bytes(kFramesCapacity));
    arguments.frames_capacity = kFramesCapacity;
    std::uint32_t length = call(arguments).frames_length;
    arguments.counted = Counted::kFeed;
    Result result;
    for (std::size_t first = 0; first < played.samples.size(); first += arguments.count) {
      arguments.count =
          std::min(kSecond, static_cast<std::uint32_t>(played.samples.size() - first));
      arguments.samples = program_->put(bytes_of(&played.samples[first], arguments.count));
      arguments.ticks = program_->put(Bytes(4 * std::size_t{arguments.count}));
      length = call(arguments).frames_length;
      std::vector<std::uint32_t> ticks(arguments.count);
      program_->get(arguments.ticks, ticks);
      for (const std::uint32_t of_sample : ticks) {
        result.counts.push_back(instructions(of_sample));
      }
    }
    result.frames.resize(length);
    program_->get(arguments.frames, result.frames);
    return result;
  }
};

TEST_P(InstructionsPerSample, AreWithinTheirBudgetsAndTheFramesAreThoseOfThisMachine) {
  const Played profile = played(GetParam());
  const Result result = there(profile);
  ASSERT_EQ(result.counts.size(), profile.samples.size());
  const Bytes here = frames_here(profile);
  EXPECT_LT(here.size(), kFramesCapacity);
  EXPECT_TRUE(result.frames == here);

  // The event and the decision are among what was counted.
  const std::vector<wire::Uplink> messages = messages_in(here);
  const std::size_t event = sample_of(messages, wire::UplinkKind::kEvent, profile.loss);
  ASSERT_LT(event, profile.samples.size() - kSecond);
  EXPECT_LT(sample_of(messages, wire::UplinkKind::kDecision, event), profile.samples.size());

  const double quiet = mean(result.counts, kSecond, profile.loss);
  const double in_event = mean(result.counts, event, event + kSecond);
  const double busiest = busiest_second(result.counts);
  const auto worst = std::max_element(result.counts.begin(), result.counts.end());
  std::printf(
      "%s: mean before the loss %.0f, in the event %.0f, in the busiest second %.0f (%.1f %% of "
      "the "
      "processor's time); worst sample %u at %.4f s (%.0f %% of its time)\n",
      GetParam(), quiet, in_event, busiest, share_pct(busiest), *worst,
      static_cast<double>(worst - result.counts.begin()) / kSampleRate_hz, share_pct(*worst));
  // The front end and the tracker alone need more than the lower bounds.
  EXPECT_GE(quiet, 200.0);
  EXPECT_GE(in_event, 200.0);
  EXPECT_LE(in_event, kMostInEvent);
  EXPECT_LE(busiest, kMostInEvent);
  EXPECT_GE(*worst, 2000U);
  EXPECT_LE(*worst, kMostInSample);
}

INSTANTIATE_TEST_SUITE_P(Profiles, InstructionsPerSample,
                         testing::Values("paper/loss-500mw",
                                         "cascades/two-losses-half-a-second-apart",
                                         "cascades/slow-oscillation-then-loss",
                                         "cascades/ramp-of-five-seconds",
                                         "cascades/deep-dip-at-the-loss"),
                         [](const auto& profile) {
                           std::string name = profile.param;
                           name = name.substr(name.find('/') + 1);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace gs::test
