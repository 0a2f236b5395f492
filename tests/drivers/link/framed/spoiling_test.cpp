// Lines that flip, drop, double and reorder bytes: the damage is reported, and no damaged message
// is accepted.
#include "outlets_on_cables.hpp"
#include "spoilers.hpp"

#include <utility>

namespace gsbench::test {
namespace {

using emulation::Way;
using gs::wire::DownlinkKind;
using gs::wire::UplinkKind;
using testing::IsEmpty;
using testing::SizeIs;

class SpoiledLine : public OutletsOnCables, public testing::WithParamInterface<Spoiling> {
 protected:
  // At zero voltage an outlet sends an invalid measurement every 128 samples from its start.
  // Anything else is a product of the line's damage.
  void expect_only_true_measurements(const std::string& outlet) const {
    std::uint64_t last = 0;
    for (const auto& received : messages(outlet, UplinkKind::kMeasurement)) {
      EXPECT_GT(received.message.sample, last);
      EXPECT_EQ(received.message.sample % 128, 0U);
      EXPECT_EQ(received.message.measurement.voltage_pu, 0.0F);
      EXPECT_EQ(received.message.measurement.validity, gs::outlet::Validity::kInvalid);
      last = received.message.sample;
    }
    for (const auto& received : messages_) {
      // There may be a second hello if the first took long.
      EXPECT_TRUE(received.message.kind == UplinkKind::kMeasurement ||
                  received.message.kind == UplinkKind::kEcho ||
                  received.message.kind == UplinkKind::kHello)
          << to_string(received.message.kind);
    }
  }
};

TEST_P(SpoiledLine, IsReportedAndNoDamagedMessageIsAccepted) {
  constexpr std::size_t kReports = 300;
  open();
  // Until the voltage at power-up no longer affects measurements.
  outlets_.play(100);
  for (const char* const outlet : {kA, kB}) {
    ASSERT_TRUE(until([&] {
      const auto all = messages(outlet, UplinkKind::kMeasurement);
      return all.size() >= 100 && all.back().message.measurement.voltage_pu == 0.0F;
    }));
  }
  messages_.clear();
  // Damages about one message in three, at varying places.
  cable(kA).spoil(every_nth_byte(97, GetParam().spoil));
  for (std::size_t i = 0; i < kReports / 10; ++i) {
    outlets_.play(10);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_TRUE(arrives(kB, UplinkKind::kMeasurement, kReports));
  EXPECT_TRUE(is_reported(kA, "sent a damaged frame"));
  cable(kA).spoil({});
  // The first message after a damaged one may be lost with it.
  send(kA, ping(1));
  EXPECT_TRUE(answers(kA, 2));
  EXPECT_TRUE(reported(kA, " of its messages were lost before its sample "));
  const std::size_t came = messages(kA, UplinkKind::kMeasurement).size();
  EXPECT_LT(came, kReports);
  EXPECT_GT(came, kReports / 4) << "most messages are not damaged";
  expect_only_true_measurements(kA);
  expect_only_true_measurements(kB);
  EXPECT_THAT(faults(kB), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpoiledLine, testing::ValuesIn(kSpoilings),
                         [](const auto& kind) { return kind.param.name; });

using RepeatingLine = OutletsOnCables;

TEST_F(RepeatingLine, DoubledMessagesArriveOnce) {
  open();
  cable(kA).spoil(each_message([](const Bytes& message) {
    return std::vector<Bytes>{message, message};
  }));
  outlets_.play(50);
  ASSERT_TRUE(arrives(kA, UplinkKind::kMeasurement, 50));
  ASSERT_TRUE(answers(kA, 1));
  EXPECT_THAT(messages(kA, UplinkKind::kEcho), SizeIs(1));
  const auto measurements = messages(kA, UplinkKind::kMeasurement);
  for (std::size_t i = 1; i < measurements.size(); ++i) {
    EXPECT_EQ(measurements[i].message.sample, measurements[i - 1].message.sample + 128);
  }
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_F(RepeatingLine, ALateMessageIsReportedAsLostAndDropped) {
  open();
  auto held = std::make_shared<Bytes>();
  cable(kA).spoil(each_message([held](const Bytes& message) {
    if (held->empty()) {
      *held = message;
      return std::vector<Bytes>{};
    }
    const Bytes late = std::exchange(*held, {});
    return std::vector<Bytes>{message, late};
  }));
  outlets_.play(50);
  EXPECT_TRUE(arrives(kA, UplinkKind::kMeasurement, 25));
  EXPECT_TRUE(reported(kA, "1 of its messages were lost before its sample "));
  std::uint64_t last = 0;
  for (const auto& received : messages(kA, UplinkKind::kMeasurement)) {
    EXPECT_GT(received.message.sample, last);
    last = received.message.sample;
  }
}

// The first message of the new start shows it; its hello is asked for.
TEST_F(OutletsOnCables, ARestartIsReportedAlthoughItsHelloIsLost) {
  open();
  outlets_.play(5);
  ASSERT_TRUE(arrives(kA, UplinkKind::kMeasurement, 5));
  cable(kA).spoil(each_message([](const Bytes& message) -> std::vector<Bytes> {
    gs::wire::Uplink uplink;
    std::uint32_t sequence = 0;
    gs::wire::decode(message.data(), message.size(), uplink, sequence);
    const bool is_unasked =
        uplink.kind == UplinkKind::kHello && uplink.hello.session == gs::wire::kNoSession;
    return is_unasked ? std::vector<Bytes>{} : std::vector<Bytes>{message};
  }));
  outlets_.kill(kA);
  outlets_.start(kA);
  EXPECT_TRUE(until([&] {
    outlets_.play(1);  // it skips what was played before it had started
    return reported(kA, "restarted after its sample ");
  }));
  EXPECT_TRUE(answers(kA, 2));
  EXPECT_EQ(faults(kA).size(), 1U);
}

TEST_F(OutletsOnCables, TruncatedSettingsAreReportedAndNotApplied) {
  open();
  // Drops the second half; the next frame's zero ends the truncated frame.
  cable(kA).spoil([](Bytes& bytes) { bytes.resize(bytes.size() / 2); }, Way::kToOutlet);
  send(kA, downlink(DownlinkKind::kSettings));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  cable(kA).spoil({}, Way::kToOutlet);
  send(kA, downlink(DownlinkKind::kAskStatus));
  ASSERT_TRUE(arrives(kA, UplinkKind::kStatus));
  // The truncated frame counts as one bad message.
  EXPECT_EQ(messages(kA, UplinkKind::kStatus).front().message.status.messages_bad, 1U);
  const auto errors = messages(kA, UplinkKind::kError);
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(errors.front().message.error.code, gs::wire::ErrorCode::kBadFrame);
  EXPECT_THAT(messages(kA, UplinkKind::kSettingsAnswer), IsEmpty());
}

}  // namespace
}  // namespace gsbench::test
