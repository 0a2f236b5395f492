#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>
#include <firmware_test/simulated_flash.hpp>
#include <wire_test/downlinks.hpp>
#include <wire_test/messages.hpp>

#include <deque>
#include <vector>

#include <gmock/gmock.h>

#include <superloop/loop.hpp>

namespace gs::superloop {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using wire::Uplink;
using wire::UplinkKind;
using wire::test::Bytes;

class FakeBoard final : public Board {
 public:
  struct Edge {
    std::size_t sample;
    bool closed;
  };

  bool send(const std::uint8_t* bytes, std::size_t count) override {
    if (line_full) {
      return false;
    }
    for (const Bytes& frame : wire::test::frames_in(reader_, Bytes(bytes, bytes + count))) {
      Uplink message;
      std::uint32_t sequence = 0;
      EXPECT_EQ(wire::decode(frame.data(), frame.size(), message, sequence), wire::Decoded::kOk);
      sent.push_back(message);
    }
    return true;
  }
  std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) override {
    lost = lost_next;
    lost_next = 0;
    std::size_t count = 0;
    for (; count < most && !samples.empty(); ++count) {
      out[count] = samples.front();
      samples.pop_front();
    }
    taken += count;
    return count;
  }
  bool take_byte(std::uint8_t& byte) override {
    if (incoming.empty()) {
      return false;
    }
    byte = incoming.front();
    incoming.pop_front();
    return true;
  }
  void drive_relay(bool closed) override {
    if (edges.empty() || edges.back().closed != closed) {
      edges.push_back({taken, closed});
    }
  }
  void feed_watchdog() override { ++watchdog_fed; }
  bool adc_idle() const override { return rests; }

  std::vector<Uplink> of(UplinkKind kind) const { return wire::test::of_kind(sent, kind); }
  std::vector<wire::ErrorCode> errors() const {
    std::vector<wire::ErrorCode> codes;
    for (const Uplink& message : of(UplinkKind::kError)) {
      codes.push_back(message.error.code);
    }
    return codes;
  }

  std::deque<std::int16_t> samples;
  std::deque<std::uint8_t> incoming;
  std::vector<Uplink> sent;
  std::vector<Edge> edges;
  std::size_t taken = 0;
  std::uint32_t lost_next = 0;
  int watchdog_fed = 0;
  bool rests = false;
  bool line_full = false;

 private:
  wire::FrameReader reader_;
};

class LoopTest : public testing::Test {
 protected:
  bool start(bool clock_failed = false, bool reset_by_watchdog = false) {
    StartUp start_up;
    app::set_text(start_up.identity.id, "outlet-7");
    start_up.identity.capabilities = keeps_settings_ ? wire::kKeepsSettings : 0U;
    start_up.hardware.has_crystal = !clock_failed;
    start_up.reset_by_watchdog = reset_by_watchdog;
    return loop_.start(start_up);
  }

  // The first message begins the session.
  void send(const wire::Downlink& message) {
    if (sequence_ == 0 && message.kind != wire::DownlinkKind::kIdentify) {
      send(wire::test::downlink(wire::DownlinkKind::kIdentify));
    }
    const Bytes frame = wire::test::framed(wire::test::encoded(message, sequence_++));
    board_.incoming.insert(board_.incoming.end(), frame.begin(), frame.end());
  }

  void play(double loss_mw, double duration_s) {
    const auto samples = test::Mains({test::loss_of(loss_mw, 1.0)})
                             .samples(0, static_cast<std::size_t>(8000 * duration_s));
    board_.samples.insert(board_.samples.end(), samples.begin(), samples.end());
  }
  int turn_until_idle() {
    int turns = 0;
    while (loop_.turn()) {
      ++turns;
    }
    return turns;
  }

  FakeBoard board_;
  test::SimulatedFlash flash_;
  settings_storage::FlashSettingsStorage storage_{flash_};
  Loop loop_{board_, storage_};
  std::uint32_t sequence_ = 0;
  bool keeps_settings_ = true;
};

TEST_F(LoopTest, TakesOneMillisecondOfSamplesPerTurn) {
  ASSERT_TRUE(start());
  play(0.0, 0.1);
  EXPECT_EQ(turn_until_idle(), 100);
  EXPECT_EQ(board_.of(UplinkKind::kMeasurement).size(), 6U);
}

TEST_F(LoopTest, ChangesTheRelayAtTheSampleOfTheDecision) {
  ASSERT_TRUE(start());
  send(wire::test::settings_message(test::ieee24_settings()));
  // Shifts reports relative to the blocks of samples: the relay must change at the end of a report.
  board_.samples.assign(3, 0);
  loop_.turn();
  play(500.0, 4.0);
  turn_until_idle();
  const auto reported = board_.of(UplinkKind::kRelay);
  ASSERT_EQ(reported.size(), 1U);
  ASSERT_EQ(board_.edges.size(), 2U);
  EXPECT_FALSE(board_.edges[1].closed);
  EXPECT_EQ(board_.edges[1].sample, reported[0].sample);
}

TEST_F(LoopTest, StartsWithTheStoredSettings) {
  outlet::Settings kept = test::ieee24_settings();
  kept.version = 41;
  ASSERT_TRUE(storage_.keep(kept));
  ASSERT_TRUE(start());
  ASSERT_EQ(board_.sent.size(), 1U);
  EXPECT_EQ(board_.sent[0].hello.settings_version, 41U);
  EXPECT_EQ(board_.sent[0].hello.settings_digest, outlet::digest(kept));
}

TEST_F(LoopTest, WithoutTheCapabilityNeitherLoadsNorStoresSettings) {
  outlet::Settings kept = test::ieee24_settings();
  kept.version = 41;
  ASSERT_TRUE(storage_.keep(kept));
  keeps_settings_ = false;
  ASSERT_TRUE(start());
  EXPECT_EQ(board_.sent[0].hello.settings_version, 0U);
  kept.version = 42;
  send(wire::test::settings_message(kept));
  turn_until_idle();
  ASSERT_EQ(board_.of(UplinkKind::kSettingsAnswer).size(), 1U);
  EXPECT_FALSE(board_.of(UplinkKind::kSettingsAnswer)[0].settings_answer.kept);
  EXPECT_THAT(board_.errors(), IsEmpty());
  ASSERT_TRUE(storage_.load(kept));
  EXPECT_EQ(kept.version, 41U);
}

TEST_F(LoopTest, ReportsStoredSettingsThatAreRefused) {
  outlet::Settings kept = test::ieee24_settings();
  kept.switch_off_hz = 10.0F;
  ASSERT_TRUE(storage_.keep(kept));
  ASSERT_TRUE(start());
  EXPECT_EQ(board_.sent[0].hello.settings_version, 0U);
  EXPECT_THAT(board_.errors(), ElementsAre(wire::ErrorCode::kSettingsStorage));
}

TEST_F(LoopTest, ReportsStartUpErrorsAfterItsHello) {
  ASSERT_TRUE(start(true, true));
  EXPECT_EQ(board_.sent[0].kind, UplinkKind::kHello);
  EXPECT_THAT(board_.errors(), ElementsAre(wire::ErrorCode::kClock, wire::ErrorCode::kWatchdog));
}

TEST_F(LoopTest, ReportsNoErrorAfterANormalStart) {
  ASSERT_TRUE(start());
  EXPECT_THAT(board_.errors(), IsEmpty());
}

TEST_F(LoopTest, FeedsTheWatchdogOnlyWhileSamplesArrive) {
  ASSERT_TRUE(start());
  play(0.0, 0.01);
  turn_until_idle();
  EXPECT_EQ(board_.watchdog_fed, 10);
  // Messages do not replace samples.
  for (int i = 0; i < 5; ++i) {
    send(wire::test::ping(1));
    loop_.turn();
  }
  EXPECT_EQ(board_.of(UplinkKind::kEcho).size(), 5U);
  EXPECT_EQ(board_.watchdog_fed, 10);
  board_.rests = true;
  loop_.turn();
  EXPECT_EQ(board_.watchdog_fed, 11);
}

TEST_F(LoopTest, TakesSamplesDuringAFloodOfBytes) {
  ASSERT_TRUE(start());
  board_.incoming.assign(100'000, 0);  // empty frames
  play(0.0, 0.01);
  for (int turn = 0; turn < 10; ++turn) {
    loop_.turn();
  }
  EXPECT_EQ(board_.taken, 80U);
  EXPECT_FALSE(board_.incoming.empty());
}

TEST_F(LoopTest, LostSamplesCountInTimeStamps) {
  ASSERT_TRUE(start());
  play(0.0, 0.016);
  turn_until_idle();
  board_.lost_next = 1000;
  play(0.0, 0.016);
  turn_until_idle();
  EXPECT_THAT(board_.errors(), ElementsAre(wire::ErrorCode::kSamplesLost));
  const auto measured = board_.of(UplinkKind::kMeasurement);
  ASSERT_EQ(measured.size(), 2U);
  EXPECT_EQ(measured[0].sample, 128U);
  EXPECT_EQ(measured[1].sample, 1256U);
}

TEST_F(LoopTest, DropsAndCountsMessagesWhileTheLineIsFull) {
  ASSERT_TRUE(start());
  board_.line_full = true;
  play(0.0, 0.16);
  turn_until_idle();
  board_.line_full = false;
  send(wire::test::downlink(wire::DownlinkKind::kAskStatus));
  turn_until_idle();
  const auto status = board_.of(UplinkKind::kStatus);
  ASSERT_EQ(status.size(), 1U);
  EXPECT_EQ(status[0].status.messages_unsent, 10U);
  EXPECT_EQ(status[0].status.reports, 10U);
}

TEST_F(LoopTest, DoesNothingOnUnsupportedHardware) {
  StartUp start_up;
  start_up.hardware.sample_rate_hz = 44100;
  EXPECT_FALSE(loop_.start(start_up));
  play(0.0, 0.1);
  turn_until_idle();
  EXPECT_THAT(board_.sent, IsEmpty());
  EXPECT_THAT(board_.edges, testing::SizeIs(1));
}

}  // namespace
}  // namespace gs::superloop
