// The head's image in qemu's netduinoplus2. The emulated chip has memories and USARTs. It has no
// clocks, so that the firmware finds no crystal, no unique id, and no DAC, DMA or captures: armed
// is as far as a run goes there, and a prefill waits in the buffer.
#include <cortex_m4/machine.hpp>
#include <head_test/rig.hpp>

#include <algorithm>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <wire/frame.hpp>

namespace gs::head::test {
namespace {

using gsbench::test::demand;
using gsbench::transport::Clock;

class HeadImage : public testing::Test {
 protected:
  void send_bytes(const Bytes& bytes) { demand(machine_.line().send(bytes)); }

  template <class Message>
  void send(const Message& message, std::uint32_t number) {
    const Bytes bytes = encoded(message, number);
    Bytes frame(wire::kLongestFrame);
    frame.resize(wire::frame(bytes.data(), bytes.size(), frame.data(), frame.size()));
    send_bytes(frame);
  }

  // The next message of this kind; those before it are dropped.
  template <class Message>
  Message wait_for() {
    const auto end = Clock::now() + gs::test::kPatience;
    for (;;) {
      while (!messages_.empty()) {
        const Bytes bytes = messages_.front();
        messages_.erase(messages_.begin());
        Message message;
        if (decode(bytes.data(), bytes.size(), message)) {
          return message;
        }
      }
      if (Clock::now() > end) {
        throw std::runtime_error("timeout while waiting for a message of the head");
      }
      read();
    }
  }

  // A status after all that was sent before.
  Status status(std::uint32_t next_number) {
    send(Ping{++token_}, next_number);
    Status status;
    while (status.echo != token_) {
      status = wait_for<Status>();
    }
    return status;
  }

 private:
  void read() {
    Bytes received;
    demand(machine_.line().receive(received, Clock::now() + std::chrono::milliseconds(100)));
    for (const std::uint8_t byte : received) {
      const auto taken = reader_.take(byte);
      ASSERT_NE(taken, wire::FrameReader::Taken::kBadFrame);
      if (taken == wire::FrameReader::Taken::kMessage) {
        messages_.emplace_back(reader_.message(), reader_.message() + reader_.size());
      }
    }
  }

  gs::test::Machine machine_{
      {"qemu-system-arm", "-M", "netduinoplus2", "-kernel", GSBENCH_HEAD_IMAGE}};
  wire::FrameReader reader_;
  std::vector<Bytes> messages_;
  std::uint32_t token_ = 0;
};

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
