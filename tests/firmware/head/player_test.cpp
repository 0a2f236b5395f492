// What is at the output, and when it is off.
#include <head_test/rig.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace gs::head::test {
namespace {

std::vector<std::uint16_t> part(const std::vector<std::uint16_t>& codes, std::size_t first,
                                std::size_t count) {
  const auto begin = codes.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

TEST(Output, IsMidScaleUntilPlayed) {
  Rig rig;
  rig.run_ms(2);
  rig.send(Identify{});
  rig.run_ms(2);
  rig.send(Arm{1});
  rig.send(stream(0, 200));
  rig.run_ms(20);
  EXPECT_TRUE(rig.off_since(0));
  EXPECT_EQ(rig.status().state, State::kArmed);
  EXPECT_EQ(rig.status().position, 0U);
}

TEST(Output, IsTheStreamFromTheFirstCodeOfTheNextMillisecond) {
  Rig rig;
  rig.run_ms(3);
  rig.play(256);
  const std::size_t begin = rig.codes().size();
  rig.run_ms(30);
  EXPECT_EQ(part(rig.codes(), begin, 30 * kBlockCodes), codes_of_stream(30 * kBlockCodes));
  EXPECT_EQ(rig.head().state(), State::kPlaying);
}

TEST(Output, BeginsWhenThePrefillIsThere) {
  Rig rig;
  rig.arm();
  rig.send(Play{300});
  rig.send(stream(0, 256));
  rig.run_ms(5);
  EXPECT_TRUE(rig.off_since(0));
  rig.send(stream(256, 43));
  rig.run_ms(5);
  EXPECT_TRUE(rig.off_since(0));
  rig.send(stream(299, 1));
  const std::size_t begin = rig.codes().size();
  rig.run_ms(5);
  EXPECT_EQ(part(rig.codes(), begin, 5 * kBlockCodes), codes_of_stream(5 * kBlockCodes));
}

TEST(Output, GoesOnAcrossManyBuffers) {
  Rig rig;
  rig.play(4096);
  std::uint64_t sent = 4096;
  constexpr std::size_t kMs = 3000;
  for (std::size_t ms = 0; ms < kMs; ++ms) {
    rig.run_ms(1);
    rig.send(stream(sent, 8));
    sent += 8;
  }
  EXPECT_EQ(rig.codes(), codes_of_stream(kMs * kBlockCodes));
  EXPECT_EQ(rig.status().position, kMs * 8);
  EXPECT_TRUE(rig.received<Refused>().empty());
}

TEST(Output, IsOffFromTheNextMillisecondAfterStop) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(100);
  rig.send(Stop{});
  const std::size_t stopped = rig.codes().size();
  rig.run_ms(500);
  EXPECT_TRUE(rig.off_since(stopped));
  EXPECT_FALSE(rig.off_since(stopped - 8));
  const Status status = rig.status();
  EXPECT_EQ(status.state, State::kOff);
  EXPECT_EQ(status.fault, Fault::kNone);
  EXPECT_EQ(status.position, 800U);
  EXPECT_EQ(status.room, kBufferSamples);
}

TEST(Output, IsOffAfterStopWithAnyNumber) {
  for (const std::uint32_t distance : {1U, 1000U, 0x80000000U, 0xFFFFFFFFU}) {
    Rig rig;
    rig.play(4096);
    rig.run_ms(10);
    rig.send(Stop{}, rig.number() + distance);
    const std::size_t stopped = rig.codes().size();
    rig.run_ms(10);
    EXPECT_TRUE(rig.off_since(stopped));
    EXPECT_EQ(rig.received<Status>().back().expected, rig.number() + distance + 1);
  }
}

TEST(Output, IsOffAfterIdentify) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(10);
  rig.send(Identify{});
  const std::size_t identified = rig.codes().size();
  rig.run_ms(10);
  EXPECT_TRUE(rig.off_since(identified));
  const Status status = rig.status();
  EXPECT_EQ(status.state, State::kOff);
  EXPECT_EQ(status.position, 0U);
  EXPECT_EQ(status.count, 0);
  EXPECT_EQ(status.run, 0U);
}

TEST(Output, IsOffInsteadOfTheFirstCodeThatNeedsAMissingSample) {
  Rig rig;
  rig.play(100);
  rig.run_ms(20);
  // Sample 99 itself is played; the codes after it need sample 100.
  constexpr std::size_t kPlayed = 99 * 8 + 1;
  EXPECT_EQ(part(rig.codes(), 0, kPlayed), codes_of_stream(kPlayed));
  EXPECT_TRUE(rig.off_since(kPlayed));
  const Status status = rig.status();
  EXPECT_EQ(status.state, State::kFaulted);
  EXPECT_EQ(status.fault, Fault::kUnderrun);
  EXPECT_EQ(status.underruns, 1U);
  EXPECT_EQ(status.position, 100U);
}

TEST(Output, IsNotPlayedOnAfterAnUnderrun) {
  Rig rig;
  rig.play(100);
  rig.run_ms(20);
  rig.forget();
  rig.send(stream(100, 200));
  rig.send(Play{1});
  rig.run_ms(20);
  EXPECT_TRUE(rig.off_since(99 * 8 + 1));
  ASSERT_EQ(rig.received<Refused>().size(), 2U);
  EXPECT_EQ(rig.received<Refused>()[0].reason, Refusal::kState);
  EXPECT_EQ(rig.received<Refused>()[1].reason, Refusal::kGap);
}

TEST(Output, IsOffIfTheBoardCannotPlay) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(10);
  rig.head().fail(Fault::kHardware);
  const std::size_t failed = rig.codes().size();
  rig.run_ms(10);
  EXPECT_TRUE(rig.off_since(failed));
  EXPECT_EQ(rig.status().fault, Fault::kHardware);
}

TEST(Output, DoesNotFailWhileOff) {
  Rig rig;
  rig.send(Identify{});
  rig.head().fail(Fault::kHardware);
  EXPECT_EQ(rig.status().state, State::kOff);
}

TEST(Watchdog, SwitchesOffAfterItsTimeToTheCode) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(50);
  rig.send(stream(4096, 8));
  const std::size_t last_message = rig.codes().size();
  rig.run_ms(300);
  const std::size_t off = last_message + kWatchdogCodes;
  EXPECT_EQ(kWatchdogCodes, 12800U);
  EXPECT_EQ(part(rig.codes(), 0, off), codes_of_stream(off));
  EXPECT_TRUE(rig.off_since(off));
  const Status status = rig.received<Status>().back();
  EXPECT_EQ(status.state, State::kFaulted);
  EXPECT_EQ(status.fault, Fault::kWatchdog);
  EXPECT_EQ(status.watchdog_trips, 1U);
  EXPECT_EQ(status.position, off / 8);
}

TEST(Watchdog, IsKeptQuietByPings) {
  Rig rig;
  rig.play(4096);
  for (int i = 0; i < 4; ++i) {
    rig.run_ms(100);
    rig.ping();
  }
  EXPECT_EQ(rig.head().state(), State::kPlaying);
  EXPECT_EQ(rig.codes(), codes_of_stream(400 * kBlockCodes));
}

TEST(Watchdog, WatchesWhileArmed) {
  Rig rig;
  rig.arm();
  rig.run_ms(200);
  EXPECT_EQ(rig.head().state(), State::kArmed);
  rig.run_ms(1);
  EXPECT_EQ(rig.head().state(), State::kFaulted);
}

TEST(Watchdog, DoesNotWatchWhileOff) {
  Rig rig;
  rig.send(Identify{});
  rig.run_ms(1000);
  EXPECT_EQ(rig.status().state, State::kOff);
  EXPECT_EQ(rig.status().watchdog_trips, 0U);
}

// A bench whose messages are all refused is not in control of the output.
TEST(Watchdog, IsNotKeptQuietByWhatIsNotAccepted) {
  const Samples beyond = samples_message(0, {kFullScale + 1});
  const std::vector<std::pair<const char*, Bytes>> messages = {
      {"gap", encoded(stream(4096, 1), 100)},
      {"repeated", encoded(Arm{7}, 1)},
      {"malformed", Bytes(5, 0x03)},
      {"unknown kind", Bytes(9, 0x77)},
      {"too short", Bytes(2, 0x06)},
      {"state", encoded(Arm{7}, 19)},
      {"position", encoded(stream(4097, 1), 19)},
      {"beyond full scale", encoded(beyond, 19)}};
  for (const auto& [name, message] : messages) {
    Rig rig;
    rig.play(4096);
    ASSERT_EQ(rig.number(), 19U);
    const std::size_t last_message = rig.codes().size();
    for (int ms = 0; ms < 250; ++ms) {
      rig.send(message);
      rig.head().bad_frame();
      rig.run_ms(1);
    }
    EXPECT_TRUE(rig.off_since(last_message + kWatchdogCodes)) << name;
    EXPECT_FALSE(rig.off_since(last_message + kWatchdogCodes - 8)) << name;
  }
}

TEST(Watchdog, TrippedNeedsAStopBeforeTheNextRun) {
  Rig rig;
  rig.play(4096);
  rig.run_ms(201);
  rig.forget();
  rig.send(Arm{8}, rig.number());
  rig.run_ms(1);
  ASSERT_EQ(rig.received<Refused>().size(), 1U);
  EXPECT_EQ(rig.received<Refused>()[0].reason, Refusal::kState);
  rig.send(Stop{});
  rig.send(Arm{8});
  rig.send(stream(0, 256));
  rig.send(Play{256});
  const std::size_t begin = rig.codes().size();
  rig.run_ms(10);
  EXPECT_EQ(part(rig.codes(), begin, 10 * kBlockCodes), codes_of_stream(10 * kBlockCodes));
  EXPECT_EQ(rig.status().watchdog_trips, 1U);
  EXPECT_EQ(rig.status().run, 8U);
}

}  // namespace
}  // namespace gs::head::test
