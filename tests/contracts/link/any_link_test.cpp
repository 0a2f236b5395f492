// The contract suite of links, for all kinds of outlets.
#include "rigs.hpp"
#include <link_test/link_fixture.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using gs::outlet::SettingsError;
using gs::wire::DownlinkKind;
using gs::wire::UplinkKind;
using testing::IsEmpty;
using testing::SizeIs;

class AnyLink : public LinkFixture, public testing::WithParamInterface<LinkUnderTest> {
 protected:
  void SetUp() override { open(rig_->make_link()); }

  std::unique_ptr<LinkRig> rig_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(InProcess, AnyLink, testing::ValuesIn(kInProcess), name_of);
INSTANTIATE_TEST_SUITE_P(ToProcesses, AnyLink, testing::ValuesIn(kToProcesses), name_of);

TEST_P(AnyLink, FindsItsOutlets) {
  ASSERT_THAT(present_, SizeIs(2));
  EXPECT_EQ(present_[0].id, kA);
  EXPECT_EQ(present_[1].id, kB);
  for (const link::OutletPresence& outlet : present_) {
    EXPECT_EQ(outlet.fault, "");
    EXPECT_NE(outlet.where, "");
    EXPECT_EQ(outlet.hello.id, outlet.id);
    EXPECT_EQ(outlet.hello.protocol_version, gs::wire::kProtocolVersion);
    EXPECT_EQ(outlet.hello.sample_rate_hz, 8000);
  }
}

TEST_P(AnyLink, EveryMeasurementArrivesOnceAndInOrder) {
  constexpr int kReports = 400;
  rig_->play(kReports);
  for (const char* const outlet : {kA, kB}) {
    ASSERT_TRUE(arrives(outlet, UplinkKind::kMeasurement, kReports));
    const auto measurements = messages(outlet, UplinkKind::kMeasurement);
    for (std::size_t i = 1; i < measurements.size(); ++i) {
      ASSERT_EQ(measurements[i].message.sample, measurements[i - 1].message.sample + 128);
      ASSERT_GE(measurements[i].arrival_ns, measurements[i - 1].arrival_ns);
    }
  }
  EXPECT_THAT(faults_, IsEmpty());
}

// Statuses and measurements may have different delivery guarantees but must stay in order.
TEST_P(AnyLink, StatusesAndMeasurementsKeepTheirOrder) {
  constexpr std::size_t kRounds = 100;
  for (std::size_t i = 0; i < kRounds; ++i) {
    send(kA, downlink(DownlinkKind::kAskStatus));
    rig_->play(1);
  }
  ASSERT_TRUE(arrives(kA, UplinkKind::kStatus, kRounds));
  ASSERT_TRUE(arrives(kA, UplinkKind::kMeasurement, kRounds));
  messages_.erase(std::remove_if(messages_.begin(), messages_.end(),
                                 [](const link::Received& received) { return received.id != kA; }),
                  messages_.end());
  EXPECT_TRUE(std::is_sorted(messages_.begin(), messages_.end(), [](const auto& x, const auto& y) {
    return x.message.sample < y.message.sample;
  }));
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_P(AnyLink, ACommandIsObeyedAndAnsweredByItsOutletOnly) {
  send(kB, command(false, 4711));
  rig_->play(2);
  ASSERT_TRUE(arrives(kB, UplinkKind::kCommandAnswer));
  const auto answer = messages(kB, UplinkKind::kCommandAnswer).front().message.command_answer;
  EXPECT_EQ(answer.request, 4711U);
  EXPECT_FALSE(answer.closed);
  EXPECT_TRUE(arrives(kB, UplinkKind::kRelay));
  EXPECT_THAT(messages(kA, UplinkKind::kCommandAnswer), IsEmpty());
  EXPECT_THAT(messages(kA, UplinkKind::kRelay), IsEmpty());
}

TEST_P(AnyLink, CommandsAreObeyedInOrder) {
  for (const bool close : {false, true, false}) {
    send(kA, command(close));
  }
  rig_->play(2);
  ASSERT_TRUE(arrives(kA, UplinkKind::kRelay, 3));
  const auto relay = messages(kA, UplinkKind::kRelay);
  ASSERT_THAT(relay, SizeIs(3));
  EXPECT_FALSE(relay[0].message.relay.closed);
  EXPECT_TRUE(relay[1].message.relay.closed);
  EXPECT_FALSE(relay[2].message.relay.closed);
}

TEST_P(AnyLink, InvalidSettingsAreRefusedWithTheReason) {
  send(kA, downlink(DownlinkKind::kSettings));
  rig_->play(2);
  ASSERT_TRUE(arrives(kA, UplinkKind::kSettingsAnswer));
  EXPECT_NE(messages(kA, UplinkKind::kSettingsAnswer).front().message.settings_answer.error,
            SettingsError::kNone);
}

TEST_P(AnyLink, SendingToAnUnknownOutletIsAnError) {
  const auto sent = link_->send("c", ping(1));
  ASSERT_FALSE(sent.ok());
  EXPECT_THAT(sent.error(), testing::HasSubstr("no outlet c"));
}

}  // namespace
}  // namespace gsbench::test
