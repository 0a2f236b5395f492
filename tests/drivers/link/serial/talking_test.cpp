// Messages over serial lines: each once, in order, stamped when they come.
#include "outlets_on_cables.hpp"

#include <wire/frame.hpp>

namespace {

using gs::outlet::SettingsError;
using gs::wire::Downlink;
using gs::wire::DownlinkKind;
using gs::wire::UplinkKind;
using gsbench::test::OutletsOnCables;
using testing::IsEmpty;
using testing::SizeIs;

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

using TalkingToOutlets = OutletsOnCables;

TEST_F(TalkingToOutlets, EveryMeasurementComesOnceAndInOrder) {
  add("a");
  add("b");
  open();
  play(0, 400);
  play(1, 300);
  ASSERT_TRUE(until([&] {
    return messages(0, UplinkKind::kMeasurement).size() >= 400 &&
           messages(1, UplinkKind::kMeasurement).size() >= 300;
  }));
  for (const std::size_t outlet : {0U, 1U}) {
    const auto measurements = messages(outlet, UplinkKind::kMeasurement);
    for (std::size_t i = 1; i < measurements.size(); ++i) {
      ASSERT_EQ(measurements[i].message.sample, measurements[i - 1].message.sample + 128);
    }
  }
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_F(TalkingToOutlets, MessagesAreStampedWhenTheyComeAndNotWhenTheyAreFetched) {
  add("a");
  open();
  const std::int64_t before = now_ns();
  send(0, ping(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const std::int64_t fetched = now_ns();
  ASSERT_TRUE(until([&] { return !messages(0, UplinkKind::kEcho).empty(); }));
  const std::int64_t arrival = messages(0, UplinkKind::kEcho).front().arrival_ns;
  EXPECT_GE(arrival, before);
  // An echo takes a millisecond; a machine that is busy for a quarter of a second would have to be
  // at fault.
  EXPECT_LT(arrival, fetched - 50'000'000);
}

TEST_F(TalkingToOutlets, ACommandIsObeyedAndAnswered) {
  add("a");
  add("b");
  open();
  Downlink command;
  command.kind = DownlinkKind::kCommand;
  command.close_relay = false;
  command.request = 42;
  send(1, command);
  ASSERT_TRUE(until([&] { return !messages(1, UplinkKind::kCommandAnswer).empty(); }));
  const auto answer = messages(1, UplinkKind::kCommandAnswer).front().message.command_answer;
  EXPECT_EQ(answer.request, 42U);
  EXPECT_FALSE(answer.closed);
  EXPECT_TRUE(until([&] { return !messages(1, UplinkKind::kRelay).empty(); }));
  EXPECT_THAT(messages(0, UplinkKind::kCommandAnswer), IsEmpty());
}

TEST_F(TalkingToOutlets, SettingsThatMakeNoSenseAreRefusedWithTheReason) {
  add("a");
  open();
  Downlink message;
  message.kind = DownlinkKind::kSettings;
  message.settings = gs::outlet::Settings{};
  send(0, message);
  ASSERT_TRUE(until([&] { return !messages(0, UplinkKind::kSettingsAnswer).empty(); }));
  EXPECT_NE(messages(0, UplinkKind::kSettingsAnswer).front().message.settings_answer.error,
            SettingsError::kNone);
}

TEST_F(TalkingToOutlets, SettingsThatAreCutOffAreToldByTheOutletAndChangeNothing) {
  add("a");
  open();
  // Without its last half: the next frame's zero ends it.
  Downlink settings;
  settings.kind = DownlinkKind::kSettings;
  std::uint8_t message[gs::wire::kLongestMessage];
  const std::size_t size = gs::wire::encode(settings, 1, message, sizeof message);
  std::uint8_t frame[gs::wire::kLongestFrame];
  const std::size_t framed = gs::wire::frame(message, size, frame, sizeof frame);
  std::FILE* const port = std::fopen(outlets_[0].bench_port().c_str(), "w");
  ASSERT_NE(port, nullptr);
  ASSERT_EQ(std::fwrite(frame, 1, framed / 2, port), framed / 2);
  std::fclose(port);
  Downlink status;
  status.kind = DownlinkKind::kAskStatus;
  send(0, status);
  ASSERT_TRUE(until([&] { return !messages(0, UplinkKind::kStatus).empty(); }));
  EXPECT_EQ(messages(0, UplinkKind::kStatus).front().message.status.messages_bad, 1U);
  ASSERT_THAT(messages(0, UplinkKind::kError), SizeIs(1));
  EXPECT_EQ(messages(0, UplinkKind::kError).front().message.error.code,
            gs::wire::ErrorCode::kBadFrame);
  EXPECT_THAT(messages(0, UplinkKind::kSettingsAnswer), IsEmpty());
}

TEST_F(TalkingToOutlets, AnOutletThatIsNotThereIsRefused) {
  add("a");
  open();
  EXPECT_FALSE(link_->send(1, ping(1)).ok());
}

TEST_F(TalkingToOutlets, AnOutletThatBeganAnewIsTold) {
  add("a");
  open();
  play(0, 10);
  ASSERT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() >= 10; }));
  outlets_[0].process->kill();
  start(0);
  EXPECT_TRUE(until([&] { return told(0, "began anew after its sample "); }));
  EXPECT_TRUE(answers(0, 3));
}

}  // namespace
