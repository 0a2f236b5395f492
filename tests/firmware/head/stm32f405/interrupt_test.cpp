// The interrupts of the head's image, on an emulated Cortex-M4F.
#include "head_image.hpp"

#include <algorithm>

namespace gs::head::test {
namespace {

TEST_F(HeadImage, MakesTheCodesOfTheStreamInItsInterrupt) {
  std::uint32_t next = play(512);
  make_codes(20);
  const Status playing = status(next);
  EXPECT_EQ(playing.state, State::kPlaying);
  EXPECT_EQ(playing.position, 160U);
  EXPECT_EQ(playing.room, kBufferSamples - 512 + 161);
  // Sample 0 is the first code of block 2, the first block that is made, and at the output after
  // two more codes. In 30 s timer 2 moves by less than 500 000 counts.
  constexpr std::int64_t kCount = 20 * kBlock_counts + 50 - (2 * 64 + 2) * 2000 / 8;
  EXPECT_GE(playing.count, kCount);
  EXPECT_LT(playing.count, kCount + 500'000);
  // The DMA's buffer has the two newest milliseconds.
  const std::vector<std::uint16_t> all = codes_of_stream(20 * kBlockCodes);
  const std::uint32_t buffer = find_in_memory({all.end() - 2 * kBlockCodes, all.end()});
  ASSERT_NE(buffer, 0U);

  send(Stop{}, next++);
  ASSERT_EQ(status(next).state, State::kOff);
  make_codes(2);
  ASSERT_EQ(status(next).state, State::kOff);
  const std::vector<std::uint8_t> off = memory(buffer, 4 * kBlockCodes);
  for (std::size_t i = 0; i < off.size(); i += 2) {
    ASSERT_EQ(off[i] | off[i + 1] << 8U, kMidScale);
  }
}

// By up to 4 codes early: the DMA reads ahead. By up to 59 late: the block can still be written.
TEST_F(HeadImage, TakesEarlyAndLateInterruptsOfItsCodes) {
  constexpr std::uint32_t kCode_counts = 2000 / 8;
  const std::uint32_t next = play(512);
  make_codes(5, 0U - 4 * kCode_counts);
  make_codes(5, 59 * kCode_counts);
  make_codes(5, 0);
  const Status playing = status(next);
  EXPECT_EQ(playing.state, State::kPlaying);
  EXPECT_EQ(playing.position, 15U * 8U);
  make_codes(1, 0U - 5 * kCode_counts - 1);
  EXPECT_EQ(status(next).fault, Fault::kHardware);
}

// The main loop stands still while the codes are made.
TEST_F(HeadImage, SwitchesOffWhenTheBenchIsSilentAlsoIfTheMainLoopHangs) {
  const std::uint32_t next = play(4096);
  make_codes(205);
  const Status now = status(next);
  EXPECT_EQ(now.state, State::kFaulted);
  EXPECT_EQ(now.fault, Fault::kWatchdog);
  EXPECT_EQ(now.position, 8U * kWatchdog_ms);
}

TEST_F(HeadImage, LeavesAtLeastAnEighthOfTheStackUnused) {
  std::uint32_t next = play(4096);
  make_codes(20);
  send(stream(4096, kLongestSamples), next);  // no room
  EXPECT_EQ(wait_for<Refused>().reason, Refusal::kNoRoom);
  send(stream(4096, 100), next++);
  send(ResendEdges{0}, next++);
  send(Stop{}, next++);
  send(Identify{}, next++);
  wait_for<Hello>();
  make_codes(2);
  const std::uint32_t bottom = gs::test::address_of_symbol(GSBENCH_HEAD_IMAGE, "gs_stack_bottom");
  const std::uint32_t top = gs::test::address_of_symbol(GSBENCH_HEAD_IMAGE, "gs_stack_top");
  const std::vector<std::uint8_t> stack = memory(bottom, top - bottom);
  const auto used =
      std::find_if(stack.begin(), stack.end(), [](std::uint8_t byte) { return byte != 0xA5; });
  const auto unused = static_cast<std::size_t>(used - stack.begin());
  RecordProperty("stack_bytes_used", static_cast<int>(stack.size() - unused));
  EXPECT_GE(unused, stack.size() / 8);
  EXPECT_LT(unused, stack.size() * 7 / 8) << "no fill pattern, or no code ran";
}

TEST_F(HeadImage, FailsIfAnInterruptOfItsCodesWasLost) {
  const std::uint32_t next = play(512);
  make_codes(3);
  ASSERT_EQ(status(next).state, State::kPlaying);
  interrupt(kDma1Stream5, 5 * kBlock_counts + 50);
  const Status now = status(next);
  EXPECT_EQ(now.state, State::kFaulted);
  EXPECT_EQ(now.fault, Fault::kHardware);
  EXPECT_EQ(now.position, 24U);
}

TEST_F(HeadImage, FailsIfTheDacGetsNoCodes) {
  const std::uint32_t next = play(512);
  make_codes(3);
  ASSERT_EQ(status(next).state, State::kPlaying);
  interrupt(kTim6Dac, 3 * kBlock_counts + 100);
  EXPECT_EQ(status(next).fault, Fault::kHardware);
}

}  // namespace
}  // namespace gs::head::test
