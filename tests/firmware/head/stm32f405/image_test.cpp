// What the head's image answers.
#include "head_image.hpp"

#include <algorithm>
#include <random>

namespace gs::head::test {
namespace {

TEST_F(HeadImage, StartsAndSaysHelloWithoutAClock) {
  const auto hello = wait_for<Hello>();
  EXPECT_STREQ(hello.board, "stm32f405");
  EXPECT_EQ(hello.flags, 0);
  EXPECT_TRUE(std::all_of(hello.unique_id, hello.unique_id + kUniqueIdBytes,
                          [](std::uint8_t byte) { return byte == 0; }));
  EXPECT_EQ(hello.build, GSBENCH_FIRMWARE_BUILD);
  EXPECT_EQ(hello.firmware_version, kFirmwareVersion);
  EXPECT_EQ(hello.full_scale, kFullScale);
  EXPECT_EQ(hello.counts_per_sample, 2000U);  // 16 MHz, the internal oscillator
}

TEST_F(HeadImage, RefusesEverythingBeforeAnIdentify) {
  wait_for<Hello>();
  send(Arm{1}, 0);
  EXPECT_EQ(wait_for<Refused>().reason, Refusal::kNotIdentified);
  EXPECT_EQ(status(0).state, State::kOff);
}

TEST_F(HeadImage, AnswersIdentifyAndRefusesAnotherVersion) {
  wait_for<Hello>();
  send(Identify{2}, 0);
  wait_for<Hello>();
  send(Arm{1}, 1);
  EXPECT_EQ(wait_for<Refused>().reason, Refusal::kVersion);
}

TEST_F(HeadImage, TakesAFullBufferOfSamplesAndNoMore) {
  wait_for<Hello>();
  send(Identify{}, 0);
  wait_for<Hello>();
  send(Arm{7}, 1);
  std::uint32_t number = 2;
  for (std::uint64_t first = 0; first < kBufferSamples; first += kLongestSamples) {
    send(stream(first, kLongestSamples), number++);
  }
  Status now = status(number);
  EXPECT_EQ(now.state, State::kArmed);
  EXPECT_EQ(now.run, 7U);
  EXPECT_EQ(now.expected, number);
  EXPECT_EQ(now.room, 0U);
  EXPECT_EQ(now.bad_frames, 0U);
  send(stream(kBufferSamples, 1), number);
  const auto refused = wait_for<Refused>();
  EXPECT_EQ(refused.reason, Refusal::kNoRoom);
  EXPECT_EQ(refused.expected, number);
  send(Play{kBufferSamples}, number++);
  send(Stop{}, number++);
  now = status(number);
  EXPECT_EQ(now.state, State::kOff);
  EXPECT_EQ(now.room, kBufferSamples);
}

TEST_F(HeadImage, RefusesGapsAndSamplesBeyondFullScale) {
  wait_for<Hello>();
  send(Identify{}, 0);
  send(Arm{1}, 1);
  send(stream(0, 10), 5);
  const auto gap = wait_for<Refused>();
  EXPECT_EQ(gap.reason, Refusal::kGap);
  EXPECT_EQ(gap.expected, 2U);
  send(samples_message(0, {0, kFullScale + 1}), 2);
  EXPECT_EQ(wait_for<Refused>().reason, Refusal::kRange);
  send(stream(0, 10), 2);
  EXPECT_EQ(status(3).room, kBufferSamples - 10);
}

TEST_F(HeadImage, CountsBadFramesAndGoesOn) {
  wait_for<Hello>();
  std::mt19937 random(1);
  Bytes noise(3000);
  std::generate(noise.begin(), noise.end(), [&] { return static_cast<std::uint8_t>(random()); });
  noise.push_back(0);
  send_bytes(noise);
  const Status now = status(0);
  EXPECT_GT(now.bad_frames, 0U);
  EXPECT_EQ(now.state, State::kOff);
}

}  // namespace
}  // namespace gs::head::test
