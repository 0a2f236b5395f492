// The outlet's end of a link, over a carrier of whole messages and over one of bytes.
#include <firmware_test/settings.hpp>
#include <wire_test/downlinks.hpp>
#include <wire_test/messages.hpp>

#include <vector>

#include <gtest/gtest.h>

#include <app/endpoint.hpp>
#include <app/self_test.hpp>

namespace gs::app {
namespace {

using wire::DownlinkKind;
using wire::ErrorCode;
using wire::Uplink;
using wire::UplinkKind;
using wire::test::Bytes;
using wire::test::downlink;
using wire::test::encoded;
using wire::test::framed;
using wire::test::ping;

// A carrier of whole messages, which decodes them like the other side.
class Listener final : public Carrier {
 public:
  bool send(const std::uint8_t* bytes, std::size_t size) override {
    if (refuses) {
      return false;
    }
    Uplink message;
    std::uint32_t sequence = 0;
    EXPECT_EQ(wire::decode(bytes, size, message, sequence), wire::Decoded::kOk);
    received.push_back(message);
    numbers.push_back(sequence);
    return true;
  }
  const Uplink& last() const { return received.back(); }

  bool refuses = false;
  std::vector<Uplink> received;
  std::vector<std::uint32_t> numbers;
};

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

class FakeStorage final : public SettingsStorage {
 public:
  bool keep(const outlet::Settings& settings) override {
    if (!keeps) {
      return false;
    }
    kept.push_back(settings);
    return true;
  }
  bool usable() const override { return works; }

  bool keeps = true;
  bool works = true;
  std::vector<outlet::Settings> kept;
};

wire::Downlink settings_message(std::uint32_t version) {
  outlet::Settings settings = test::ieee24_settings();
  settings.version = version;
  return wire::test::settings_message(settings);
}

class EndpointTest : public testing::Test {
 protected:
  // Begins the session, whose next number is 0. The hello that was sent unasked stays.
  void SetUp() override {
    start(&storage_);
    send(downlink(DownlinkKind::kIdentify), 0xFFFFFFFFU);
    ASSERT_EQ(listener_.received.size(), 2U);
    listener_.received.pop_back();
    listener_.numbers.pop_back();
  }
  void start(SettingsStorage* storage) {
    ASSERT_TRUE(app_.start(outlet::Hardware{}, identity_, storage, endpoint_));
  }
  void send(const wire::Downlink& downlink, std::uint32_t sequence) {
    send(encoded(downlink, sequence));
  }
  void send(const Bytes& bytes) { endpoint_.receive(bytes.data(), bytes.size()); }
  void feed(std::size_t samples) {
    const std::vector<std::int16_t> silence(samples);
    app_.feed(silence.data(), silence.size(), endpoint_);
  }
  wire::Status status(std::uint32_t sequence) {
    send(downlink(DownlinkKind::kAskStatus), sequence);
    EXPECT_EQ(listener_.last().kind, UplinkKind::kStatus);
    return listener_.last().status;
  }

  static Identity test_identity() {
    Identity identity;
    set_text(identity.id, "outlet-7");
    return identity;
  }

  Identity identity_ = test_identity();
  Application app_;
  FakeStorage storage_;
  Listener listener_;
  MessageEndpoint endpoint_{app_, listener_};
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

// ---- sessions

TEST_F(EndpointTest, ARepeatedIdentifyIsADuplicateAndWhatFollowsItIsNotObeyedAgain) {
  send(wire::test::command(false, 1), 0);
  send(wire::test::command(true, 2), 1);
  ASSERT_TRUE(app_.relay_closed());
  const std::size_t before = listener_.received.size();
  send(downlink(DownlinkKind::kIdentify), 0xFFFFFFFFU);
  send(wire::test::command(false, 1), 0);
  send(wire::test::command(true, 2), 1);
  EXPECT_EQ(listener_.received.size(), before);
  EXPECT_EQ(status(2).messages_dropped, 3U);
}

TEST_F(EndpointTest, AMessageOfAnUnknownSessionIsRefusedUntilIdentifyBeginsIt) {
  wire::Downlink other = ping(5);
  other.session = 1234;
  send(other, 7);
  ASSERT_EQ(listener_.last().kind, UplinkKind::kError);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownSession);
  EXPECT_EQ(listener_.last().error.detail, 1234U);
  wire::Downlink identify = wire::identify();
  identify.session = 1234;
  send(identify, 7);
  EXPECT_EQ(listener_.last().hello.session, 1234U);
  send(other, 7);
  EXPECT_EQ(listener_.last().kind, UplinkKind::kHello) << "a duplicate";
  send(other, 8);
  EXPECT_EQ(listener_.last().echo.token, 5U);
  const wire::Status reported = status(0);
  EXPECT_EQ(reported.messages_dropped, 2U);
  EXPECT_EQ(reported.messages_bad, 0U);
}

TEST_F(EndpointTest, SessionsHaveNumbersAndRequestsOfTheirOwn) {
  send(wire::test::command(false, 5), 0);
  wire::Downlink other = wire::identify();
  other.session = 1234;
  send(other, 0);
  other = wire::test::command(true, 1);
  other.session = 1234;
  send(other, 1);
  EXPECT_EQ(listener_.received[listener_.received.size() - 2].command_answer.session, 1234U);
  EXPECT_TRUE(app_.relay_closed());
  send(wire::test::command(false, 6), 1);
  EXPECT_FALSE(app_.relay_closed());
}

TEST_F(EndpointTest, AFifthSessionReplacesTheOneUsedLongestAgo) {
  const auto identify = [this](std::uint32_t session) {
    wire::Downlink message = wire::identify();
    message.session = session;
    send(message, 0);
  };
  for (const std::uint32_t session : {101U, 102U, 103U}) {
    identify(session);
  }
  send(ping(1), 0);  // the fixture's session is now used last
  identify(104);
  send(ping(2), 1);
  EXPECT_EQ(listener_.last().echo.token, 2U);
  wire::Downlink late = ping(3);
  late.session = 101;
  send(late, 1);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownSession);
  late.session = 102;
  send(late, 1);
  EXPECT_EQ(listener_.last().echo.token, 3U);
}

TEST_F(EndpointTest, AMessageOfAnUnknownKindUsesUpItsNumber) {
  const Bytes unknown = {0x83, 0x18, 0x63, 0x00, 0x18, wire::test::kSession};
  send(unknown);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownKind);
  const std::size_t before = listener_.received.size();
  send(unknown);
  send(ping(1), 0);
  EXPECT_EQ(listener_.received.size(), before) << "duplicates";
  Bytes of_another = unknown;
  of_another.back() = wire::test::kSession + 1;
  send(of_another);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownSession);
}

// ---- commands

TEST_F(EndpointTest, ARepeatedRequestIsAnsweredButNotObeyedAgain) {
  send(wire::test::command(false, 3), 0);
  send(wire::test::command(true, 4), 1);
  std::uint32_t sequence = 2;
  for (const std::uint32_t request : {3U, 4U, 1U}) {
    const std::size_t before = listener_.received.size();
    send(wire::test::command(false, request), sequence++);
    ASSERT_EQ(listener_.received.size(), before + 1) << "an answer, and no relay message";
    EXPECT_EQ(listener_.last().command_answer.request, request);
    EXPECT_TRUE(listener_.last().command_answer.closed);
  }
  EXPECT_EQ(status(100).messages_dropped, 0U);
}

TEST_F(EndpointTest, ACommandForAnotherStartIsRefused) {
  wire::Downlink command = wire::test::command(false, 8);
  command.start_number = app_.start_number() + 1;
  send(command, 0);
  EXPECT_TRUE(app_.relay_closed());
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kOtherStart);
  EXPECT_EQ(listener_.last().error.detail, 8U);
  command.start_number = app_.start_number();
  send(command, 1);
  EXPECT_FALSE(app_.relay_closed()) << "the refused request was not used up";
  EXPECT_EQ(status(2).messages_dropped, 1U);
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
