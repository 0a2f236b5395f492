// The outlet's end of a link, over a carrier of whole messages and over one of bytes.
#include "endpoint_fixture.hpp"

#include <app/self_test.hpp>

namespace gs::app {
namespace {

// A carrier of bytes, which finds the frames in them.
class Line final : public Carrier {
 public:
  bool send(const std::uint8_t* bytes, std::size_t size) override {
    for (const Bytes& message : wire::test::frames_in(reader_, Bytes(bytes, bytes + size))) {
      EXPECT_FALSE(message.empty()) << "a bad frame";
      listener.send(message.data(), message.size());
    }
    return true;
  }

  Listener listener;

 private:
  wire::FrameReader reader_;
};

TEST_F(EndpointTest, NumbersItsMessagesFromZero) {
  feed(1280);
  send(ping(1), 0);
  ASSERT_EQ(listener_.received.size(), 12U);
  EXPECT_EQ(listener_.received.front().kind, UplinkKind::kHello);
  EXPECT_EQ(listener_.numbers[0], 0U);
  for (std::uint32_t i = 1; i < 12; ++i) {
    EXPECT_EQ(listener_.numbers[i], i - 1) << "hellos have numbers of their own";
  }
  send(downlink(DownlinkKind::kIdentify), 1);
  EXPECT_EQ(listener_.last().kind, UplinkKind::kHello);
  EXPECT_EQ(listener_.numbers.back(), 2U) << "the fixture's identify was answered by number 1";
  EXPECT_EQ(listener_.last().hello.next_number, 11U);
}

TEST_F(EndpointTest, EveryMessageHasTheStartNumber) {
  identity_.start_number = 0xC0FFEE07U;
  start(nullptr);
  feed(128);
  send(ping(1), 0);
  for (std::size_t i = 1; i < listener_.received.size(); ++i) {
    EXPECT_EQ(listener_.received[i].start_number, 0xC0FFEE07U) << i;
  }
}

TEST_F(EndpointTest, EchoesAPingAtOnceWithItsTokenAndTheSamplesTaken) {
  feed(100);
  send(ping(0xCAFEF00DU), 0);
  EXPECT_EQ(listener_.last().kind, UplinkKind::kEcho);
  EXPECT_EQ(listener_.last().echo.token, 0xCAFEF00DU);
  EXPECT_EQ(listener_.last().sample, 100U);
}

TEST_F(EndpointTest, DropsDuplicatesWithoutAnAnswer) {
  send(ping(1), 5);
  ASSERT_EQ(listener_.received.size(), 2U);
  send(ping(1), 5);
  send(ping(1), 4);
  EXPECT_EQ(listener_.received.size(), 2U);
  send(ping(2), 6);
  EXPECT_EQ(listener_.received.size(), 3U);
  send(ping(3), 100);
  EXPECT_EQ(listener_.last().echo.token, 3U) << "a message after a gap counts";
  const wire::Status reported = status(101);
  EXPECT_EQ(reported.messages_bad, 0U);
  EXPECT_EQ(reported.messages_dropped, 2U);
}

TEST_F(EndpointTest, ReportsMessagesThatItCannotDecode) {
  send(Bytes{0x82, 0x06});
  EXPECT_EQ(listener_.last().kind, UplinkKind::kError);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kMalformed);
  EXPECT_EQ(listener_.last().error.detail, 1U);
  send(Bytes{});
  EXPECT_EQ(listener_.last().error.detail, 2U);
  send(Bytes{0x83, 0x18, 0x63, 0x00, 0x18, wire::test::kSession});
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownKind);
  EXPECT_EQ(listener_.last().error.detail, 1U) << "each code has its own count";
  EXPECT_EQ(status(1).messages_bad, 3U);
}

TEST_F(EndpointTest, CountsUnsentMessagesAndLeavesAGapInTheNumbering) {
  listener_.refuses = true;
  send(ping(1), 0);
  feed(256);
  listener_.refuses = false;
  EXPECT_EQ(status(1).messages_unsent, 3U);
  EXPECT_EQ(listener_.numbers, (std::vector<std::uint32_t>{0, 3}));
}

TEST_F(EndpointTest, StatusHasCountersAndState) {
  feed(3 * 128);
  wire::Status reported = status(0);
  EXPECT_EQ(reported.reports, 3U);
  EXPECT_TRUE(reported.relay_closed);
  EXPECT_EQ(reported.cause, outlet::Cause::kNone);
  EXPECT_EQ(reported.phase, outlet::Phase::kQuiet);
  EXPECT_EQ(reported.samples_lost, 0U);
  send(wire::test::command(false), 1);
  reported = status(2);
  EXPECT_FALSE(reported.relay_closed);
  EXPECT_EQ(reported.cause, outlet::Cause::kCommand);
}

TEST_F(EndpointTest, LostSamplesCountInTimeStamps) {
  feed(100);
  app_.note_samples_lost(28, endpoint_);
  EXPECT_EQ(listener_.last().kind, UplinkKind::kError);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kSamplesLost);
  EXPECT_EQ(listener_.last().sample, 128U);
  app_.note_samples_lost(2, endpoint_);
  EXPECT_EQ(listener_.last().error.detail, 2U);
  const wire::Status reported = status(0);
  EXPECT_EQ(reported.samples_lost, 30U);
  EXPECT_EQ(reported.messages_bad, 0U);
  EXPECT_EQ(app_.samples_taken(), 130U);
}

TEST_F(EndpointTest, StoresAcceptedSettings) {
  send(settings_message(3), 0);
  EXPECT_EQ(listener_.last().kind, UplinkKind::kSettingsAnswer);
  EXPECT_EQ(listener_.last().settings_answer.error, outlet::SettingsError::kNone);
  EXPECT_TRUE(listener_.last().settings_answer.kept);
  ASSERT_EQ(storage_.kept.size(), 1U);
  EXPECT_EQ(outlet::digest(storage_.kept[0]), listener_.last().settings_answer.digest);
}

TEST_F(EndpointTest, DoesNotStoreRefusedSettings) {
  wire::Downlink wrong = settings_message(3);
  wrong.settings.threshold_mw = -1.0F;
  send(wrong, 0);
  EXPECT_EQ(listener_.last().settings_answer.error, outlet::SettingsError::kThreshold);
  EXPECT_FALSE(listener_.last().settings_answer.kept) << "there are none";
  EXPECT_TRUE(storage_.kept.empty());
}

TEST_F(EndpointTest, ARefusalSaysWhetherTheSettingsInForceAreStored) {
  const auto refused = [this](std::uint32_t sequence) {
    send(settings_message(1), sequence);
    EXPECT_EQ(listener_.last().settings_answer.error, outlet::SettingsError::kStale);
    return listener_.last().settings_answer.kept;
  };
  send(settings_message(3), 0);
  EXPECT_TRUE(refused(1));
  storage_.keeps = false;
  EXPECT_TRUE(refused(2)) << "nothing had to be stored";
  send(settings_message(4), 3);
  EXPECT_FALSE(refused(4));
  storage_.keeps = true;
  EXPECT_FALSE(refused(5));
  send(settings_message(5), 6);
  EXPECT_TRUE(refused(7));
}

TEST_F(EndpointTest, AppliesSettingsThatCannotBeStoredAndReportsAnError) {
  storage_.keeps = false;
  send(settings_message(3), 0);
  ASSERT_EQ(listener_.received.size(), 3U);
  const wire::SettingsAnswer answer = listener_.received[1].settings_answer;
  EXPECT_EQ(answer.error, outlet::SettingsError::kNone);
  EXPECT_EQ(answer.version, 3U);
  EXPECT_FALSE(answer.kept);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kSettingsStorage);
  EXPECT_EQ(status(1).messages_bad, 0U);
}

TEST_F(EndpointTest, WithoutStorageAppliesSettingsWithoutAnError) {
  start(nullptr);
  send(settings_message(3), 0);
  EXPECT_EQ(listener_.last().kind, UplinkKind::kSettingsAnswer);
  EXPECT_FALSE(listener_.last().settings_answer.kept);
}

TEST_F(EndpointTest, ReportsRestoredSettingsInTheHello) {
  const outlet::Settings settings = settings_message(7).settings;
  ASSERT_TRUE(app_.restore(settings));
  EXPECT_TRUE(storage_.kept.empty()) << "they are stored already";
  send(downlink(DownlinkKind::kIdentify), 0);
  EXPECT_EQ(listener_.last().hello.settings_version, 7U);
  EXPECT_EQ(listener_.last().hello.settings_digest, outlet::digest(settings));
  send(settings_message(7), 1);
  EXPECT_EQ(listener_.last().settings_answer.error, outlet::SettingsError::kStale);
  EXPECT_TRUE(listener_.last().settings_answer.kept);
}

TEST_F(EndpointTest, SettingsOutOfRangeAreNotRestored) {
  outlet::Settings settings = settings_message(7).settings;
  settings.condition_rows = 0;
  EXPECT_FALSE(app_.restore(settings));
  send(downlink(DownlinkKind::kIdentify), 0);
  EXPECT_EQ(listener_.last().hello.settings_version, 0U);
}

TEST_F(EndpointTest, SelfTestReportsArithmeticStorageClockAndAdc) {
  const auto failed = [this](std::uint32_t sequence) {
    send(downlink(DownlinkKind::kAskSelfTest), sequence);
    EXPECT_EQ(listener_.last().kind, UplinkKind::kSelfTest);
    EXPECT_EQ(listener_.last().self_test.fingerprint, arithmetic_fingerprint());
    return listener_.last().self_test.failed;
  };
  const std::uint32_t arithmetic =
      arithmetic_fingerprint() == kFingerprint ? 0U : std::uint32_t{wire::kArithmetic};
  EXPECT_EQ(failed(0), arithmetic | wire::kAdc) << "no samples yet";
  feed(128);
  EXPECT_EQ(failed(1), arithmetic);
  storage_.works = false;
  EXPECT_EQ(failed(2), arithmetic | wire::kSettingsStorage);
  app_.note(ErrorCode::kClock, endpoint_);
  EXPECT_EQ(failed(3), arithmetic | wire::kSettingsStorage | wire::kClock);
}

// ---- over a serial line

class SerialEndpointTest : public testing::Test {
 protected:
  // Begins the session, whose next number is 0. The hello that was sent unasked stays.
  void SetUp() override {
    Identity identity;
    set_text(identity.id, "outlet-7");
    ASSERT_TRUE(app_.start(outlet::Hardware{}, identity, nullptr, endpoint_));
    send(framed(encoded(downlink(DownlinkKind::kIdentify), 0xFFFFFFFFU)));
    line_.listener.received.pop_back();
  }
  void send(const Bytes& bytes) { endpoint_.receive(bytes.data(), bytes.size()); }

  Application app_;
  Line line_;
  SerialEndpoint endpoint_{app_, line_};
};

TEST_F(SerialEndpointTest, AnswersFramesWithFrames) {
  send(framed(encoded(ping(7), 0)));
  ASSERT_EQ(line_.listener.received.size(), 2U);
  EXPECT_EQ(line_.listener.received[0].kind, UplinkKind::kHello);
  EXPECT_EQ(line_.listener.last().echo.token, 7U);
}

TEST_F(SerialEndpointTest, ReadsAFrameInPieces) {
  const Bytes frame = framed(encoded(settings_message(1), 0));
  for (const std::uint8_t byte : frame) {
    send(Bytes{byte});
  }
  EXPECT_EQ(line_.listener.last().kind, UplinkKind::kSettingsAnswer);
  EXPECT_EQ(line_.listener.last().settings_answer.digest,
            outlet::digest(settings_message(1).settings));
}

TEST_F(SerialEndpointTest, CountsAndReportsABadFrameAndReadsTheNext) {
  Bytes bytes = framed(encoded(ping(7), 0));
  bytes[3] ^= 0x10;
  const Bytes next = framed(encoded(ping(8), 1));
  bytes.insert(bytes.end(), next.begin(), next.end());
  send(bytes);
  ASSERT_EQ(line_.listener.received.size(), 3U);
  EXPECT_EQ(line_.listener.received[1].error.code, ErrorCode::kBadFrame);
  EXPECT_EQ(line_.listener.received[1].error.detail, 1U);
  EXPECT_EQ(line_.listener.last().echo.token, 8U);
  send(framed(encoded(downlink(DownlinkKind::kAskStatus), 2)));
  EXPECT_EQ(line_.listener.last().status.messages_bad, 1U);
}

TEST_F(SerialEndpointTest, AValidFrameWithoutAMessageIsMalformed) {
  send(framed({0xA0}));
  EXPECT_EQ(line_.listener.last().error.code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace gs::app
