// The complete emulated outlet: messages, stored settings, and behaviour on failures.
#include "debugger.hpp"
#include "emulated_outlet.hpp"
#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>
#include <wire_test/downlinks.hpp>

#include <iostream>
#include <map>
#include <random>
#include <thread>

#include <gmock/gmock.h>

#include <app/application.hpp>

namespace gs::test {
namespace {

using wire::UplinkKind;
using wire::test::command;
using wire::test::downlink;

std::vector<std::int16_t> quiet_mains(double duration_s) {
  return Mains({steady(50.0, 50.0)}).samples(0, static_cast<std::size_t>(8000 * duration_s));
}

wire::Downlink settings_of(std::uint32_t version) {
  outlet::Settings settings = ieee24_settings();
  settings.version = version;
  settings.accumulated_mw = static_cast<float>(version);
  return wire::test::settings_message(settings);
}

class Mps2 : public testing::Test {
 protected:
  void start() {
    outlet_.start(GSBENCH_M4_IMAGE);
    hello_ = outlet_.line().wait_for(UplinkKind::kHello).uplink.hello;
  }
  // The pin changes just after the relay message.
  void wait_for_edges(std::uint32_t count) {
    outlet_.line().read_until([&] { return outlet_.terminals().edges == count; },
                              "edge " + std::to_string(count) + " of the pin");
  }
  wire::Status status() {
    Line& line = outlet_.line();
    const std::size_t first = line.messages().size();
    line.send(downlink(wire::DownlinkKind::kAskStatus));
    return line.wait_for(UplinkKind::kStatus, first).uplink.status;
  }

  EmulatedOutlet outlet_;
  wire::Hello hello_;
};

TEST_F(Mps2, HelloHasTheIdentityInTheTerminals) {
  start();
  EXPECT_STREQ(hello_.id, "outlet-7");
  EXPECT_STREQ(hello_.board, "mps2-an386");
  EXPECT_EQ(hello_.instance, 77U);
  EXPECT_EQ(hello_.firmware_version, app::kFirmwareVersion);
  EXPECT_EQ(hello_.build, GSBENCH_FIRMWARE_BUILD);
  EXPECT_EQ(hello_.capabilities, wire::kKeepsSettings | wire::kHasWatchdog);
  EXPECT_EQ(hello_.settings_version, 0U);
  EXPECT_EQ(outlet_.terminals().starts, 1U);
}

TEST_F(Mps2, ThePinFollowsCommandsAndIsClosedAgainAfterALossOfPower) {
  start();
  Line& line = outlet_.line();
  outlet_.play(quiet_mains(0.5));
  line.send(command(false));
  line.wait_for(UplinkKind::kRelay);
  wait_for_edges(1);
  EXPECT_EQ(outlet_.terminals().edge[0].closed, 0U);
  EXPECT_EQ(outlet_.terminals().edge[0].sample, 4000U);
  outlet_.kill();
  start();
  wait_for_edges(2);
  EXPECT_EQ(outlet_.terminals().edge[1].closed, 1U);
  EXPECT_EQ(outlet_.terminals().starts, 2U);
}

TEST_F(Mps2, ACrystalThatDoesNotStartIsReportedAlsoByTheSelfTest) {
  outlet_.terminals().crystal_fails = 1;
  start();
  Line& line = outlet_.line();
  outlet_.play(quiet_mains(0.1));
  line.send(downlink(wire::DownlinkKind::kAskSelfTest));
  EXPECT_EQ(line.wait_for(UplinkKind::kSelfTest).uplink.self_test.failed,
            std::uint32_t{wire::kClock});
  EXPECT_TRUE(line.has_error(wire::ErrorCode::kClock));
  for (const ReceivedMessage& message : line.of(UplinkKind::kMeasurement)) {
    EXPECT_EQ(message.uplink.measurement.validity, outlet::Validity::kInvalid);
  }
  EXPECT_EQ(outlet_.terminals().edges, 0U);
}

TEST_F(Mps2, TheSelfTestDetectsAnAdcWithoutSamples) {
  start();
  outlet_.line().send(downlink(wire::DownlinkKind::kAskSelfTest));
  EXPECT_EQ(outlet_.line().wait_for(UplinkKind::kSelfTest).uplink.self_test.failed,
            std::uint32_t{wire::kAdc});
}

TEST_F(Mps2, CountsSamplesThatTheBenchOverwrote) {
  start();
  constexpr std::uint32_t kAhead = shared_memory_io::kRingSamples + 1000;
  outlet_.terminals().written = outlet_.terminals().written + kAhead;
  outlet_.ring_doorbell();
  outlet_.line().wait_for(UplinkKind::kError);
  EXPECT_TRUE(outlet_.line().has_error(wire::ErrorCode::kSamplesLost));
  EXPECT_EQ(status().samples_lost, kAhead - shared_memory_io::kRingSamples / 2);
  outlet_.line().read_until(
      [&] { return outlet_.terminals().taken == outlet_.terminals().written; },
      "the outlet to take the remaining samples");
}

TEST_F(Mps2, SettingsSurviveALossOfPower) {
  start();
  outlet_.line().send(settings_of(5));
  const auto answer = outlet_.line().wait_for(UplinkKind::kSettingsAnswer).uplink.settings_answer;
  EXPECT_TRUE(answer.kept);
  outlet_.kill();
  start();
  EXPECT_EQ(hello_.settings_version, 5U);
  EXPECT_EQ(hello_.settings_digest, outlet::digest(settings_of(5).settings));
}

// Power is lost at random while settings arrive. At the next start the settings last acknowledged,
// or newer ones that were sent, must be in force.
TEST_F(Mps2, ALossOfPowerAtAnyMomentLeavesValidSettings) {
  constexpr int kCuts = 30;
  std::mt19937 random(1);
  std::map<std::uint32_t, std::uint32_t> digests = {{0, 0}};  // by version
  std::uint32_t acknowledged = 0;
  std::uint32_t sent = 0;
  int cut_short = 0;
  for (int cut = 0; cut < kCuts; ++cut) {
    start();
    ASSERT_EQ(digests.count(hello_.settings_version), 1U);
    ASSERT_EQ(hello_.settings_digest, digests[hello_.settings_version]);
    ASSERT_GE(hello_.settings_version, acknowledged);
    Line& line = outlet_.line();
    for (int i = 0; i < 20; ++i) {
      const wire::Downlink message = settings_of(++sent);
      digests[sent] = outlet::digest(message.settings);
      line.send(message);
    }
    if (cut % 3 == 0) {  // a busy machine may answer nothing within 0.1 s
      (void)line.wait_for(UplinkKind::kSettingsAnswer);
    } else {
      line.read_for(std::chrono::milliseconds(100));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 20'000));
    outlet_.kill();
    // Reads what it sent before power was lost.
    for (std::size_t had = line.messages().size() + 1; line.messages().size() != had;) {
      had = line.messages().size();
      line.read_for(std::chrono::milliseconds(20));
    }
    for (const ReceivedMessage& message : line.of(UplinkKind::kSettingsAnswer)) {
      ASSERT_TRUE(message.uplink.settings_answer.kept);
      acknowledged = std::max(acknowledged, message.uplink.settings_answer.version);
    }
    if (acknowledged < sent) {
      ++cut_short;
    }
  }
  EXPECT_GT(acknowledged, 0U);
  EXPECT_GT(cut_short, 0) << "each outlet had stored all settings before power was lost";
}

TEST_F(Mps2, TheWatchdogRestartsHangingFirmwareWhichReportsIt) {
  start();
  Line& line = outlet_.line();
  line.send(settings_of(3));
  line.wait_for(UplinkKind::kSettingsAnswer);
  const std::size_t before = line.messages().size();
  Debugger(outlet_.machine()).go_to(address_of_symbol(GSBENCH_M4_IMAGE, "gs_hang"));
  const auto hello = line.wait_for(UplinkKind::kHello, before).uplink.hello;
  EXPECT_EQ(hello.settings_version, 3U);
  line.wait_for(UplinkKind::kError, before);
  EXPECT_TRUE(line.has_error(wire::ErrorCode::kWatchdog));
  EXPECT_EQ(outlet_.terminals().starts, 2U);
}

// 1.5 times the watchdog's reset time.
TEST_F(Mps2, TheWatchdogDoesNotResetAnIdleOutlet) {
  start();
  outlet_.line().read_for(std::chrono::milliseconds(15'000));
  EXPECT_EQ(status().reports, 0U);
  EXPECT_EQ(outlet_.terminals().starts, 1U);
  EXPECT_FALSE(outlet_.line().has_error(wire::ErrorCode::kWatchdog));
}

// Exercises the deepest calls: settings, stored settings at start-up, self test, a decision, every
// downlink message.
TEST_F(Mps2, AtLeastAnEighthOfTheStackIsNeverUsed) {
  start();
  outlet_.line().send(settings_of(1));
  outlet_.line().wait_for(UplinkKind::kSettingsAnswer);
  outlet_.kill();
  start();
  Line& line = outlet_.line();
  line.send(settings_of(2));
  line.wait_for(UplinkKind::kSettingsAnswer);
  outlet_.play(Mains({loss_of(500.0, 1.0)}).samples(0, 8000 * 4));
  line.send(command(true));
  line.send(downlink(wire::DownlinkKind::kIdentify));
  line.send(downlink(wire::DownlinkKind::kAskSelfTest));
  line.wait_for(UplinkKind::kSelfTest);
  status();

  const std::uint32_t bottom = address_of_symbol(GSBENCH_M4_IMAGE, "gs_stack_bottom");
  const std::uint32_t top = address_of_symbol(GSBENCH_M4_IMAGE, "gs_stack_top");
  const auto stack = Debugger(outlet_.machine()).memory(bottom, top - bottom);
  std::size_t free = 0;
  while (free < stack.size() && stack[free] == 0xA5) {
    ++free;
  }
  std::cout << "stack: " << stack.size() - free << " of " << stack.size() << " bytes used\n";
  RecordProperty("stack_bytes_used", static_cast<int>(stack.size() - free));
  EXPECT_GE(free, stack.size() / 8);
  EXPECT_LT(free, stack.size() / 2) << "no fill pattern, or no code ran";
}

}  // namespace
}  // namespace gs::test
