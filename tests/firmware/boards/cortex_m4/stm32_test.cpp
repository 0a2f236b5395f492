// The STM32F405's image in qemu's netduinoplus2. The emulated chip has memories and USARTs, but no
// clocks, no DMA and no unique id, and its flash cannot be programmed.
#include "emulated_outlet.hpp"
#include <firmware_test/settings.hpp>
#include <wire_test/downlinks.hpp>

#include <gtest/gtest.h>

namespace gs::test {
namespace {

using wire::UplinkKind;

class Stm32 : public testing::Test {
 protected:
  Machine machine_{{"qemu-system-arm", "-M", "netduinoplus2", "-kernel", GSBENCH_STM32_IMAGE}};
  Line line_{machine_.line()};
};

TEST_F(Stm32, StartsWithoutAClockAndReportsIt) {
  const auto hello = line_.wait_for(UplinkKind::kHello).uplink.hello;
  EXPECT_STREQ(hello.board, "stm32f405");
  EXPECT_STREQ(hello.id, "stm32-00000000");
  EXPECT_EQ(hello.sample_rate_hz, 8000);
  EXPECT_EQ(hello.build, GSBENCH_FIRMWARE_BUILD);
  line_.wait_for(UplinkKind::kError);
  EXPECT_TRUE(line_.has_error(wire::ErrorCode::kClock));
  EXPECT_FALSE(line_.has_error(wire::ErrorCode::kWatchdog));
}

TEST_F(Stm32, TheSelfTestReportsOnlyTheMissingClockAndAdc) {
  line_.wait_for(UplinkKind::kHello);
  line_.send(wire::test::downlink(wire::DownlinkKind::kAskSelfTest));
  EXPECT_EQ(line_.wait_for(UplinkKind::kSelfTest).uplink.self_test.failed,
            wire::kClock | wire::kAdc);
}

TEST_F(Stm32, AppliesSettingsThatItsFlashCannotStoreAndReportsAnError) {
  line_.wait_for(UplinkKind::kHello);
  line_.wait_for(UplinkKind::kError);
  const wire::Downlink message = wire::test::settings_message(ieee24_settings());
  const std::size_t before = line_.messages().size();
  line_.send(message);
  const auto answer = line_.wait_for(UplinkKind::kSettingsAnswer).uplink.settings_answer;
  EXPECT_EQ(answer.error, outlet::SettingsError::kNone);
  EXPECT_EQ(answer.digest, outlet::digest(message.settings));
  EXPECT_FALSE(answer.kept);
  EXPECT_EQ(line_.wait_for(UplinkKind::kError, before).uplink.error.code,
            wire::ErrorCode::kSettingsStorage);
}

TEST_F(Stm32, ObeysCommands) {
  line_.wait_for(UplinkKind::kHello);
  line_.send(wire::test::command(false, 4));
  const auto answer = line_.wait_for(UplinkKind::kCommandAnswer).uplink.command_answer;
  EXPECT_EQ(answer.request, 4U);
  EXPECT_FALSE(answer.closed);
}

}  // namespace
}  // namespace gs::test
