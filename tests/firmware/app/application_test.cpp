#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>
#include <wire_test/downlinks.hpp>

#include <cmath>
#include <vector>

#include <gmock/gmock.h>

#include <app/application.hpp>

namespace gs::app {
namespace {

using outlet::Cause;
using outlet::SettingsError;
using outlet::Validity;
using wire::Uplink;
using wire::UplinkKind;
using wire::test::command;
using wire::test::settings_message;

constexpr std::size_t kSamplesPerReport = 128;  // 16 ms at 8 kHz

class RecordingOutbox : public Outbox {
 public:
  void put(const Uplink& message) override { all.push_back(message); }

  std::vector<Uplink> of(UplinkKind kind) const { return wire::test::of_kind(all, kind); }

  std::vector<Uplink> all;
};

Identity identity() {
  Identity identity;
  set_text(identity.id, "outlet-7");
  set_text(identity.board, "test");
  identity.instance = 77;
  identity.build = 0xABCD1234U;
  return identity;
}

class ApplicationTest : public testing::Test {
 protected:
  void start() { ASSERT_TRUE(app_.start(outlet::Hardware{}, identity(), nullptr, outbox_)); }

  void feed(const test::MainsSpec& mains, double duration_s) {
    const auto samples = test::Mains(mains).samples(0, static_cast<std::size_t>(8000 * duration_s));
    app_.feed(samples.data(), samples.size(), outbox_);
  }
  void feed_steady(double duration_s) { feed({test::steady(50.0, 50.0)}, duration_s); }
  // Starts, applies settings, and feeds a loss of 500 MW at 1 s.
  void feed_loss(const outlet::Settings& settings = test::ieee24_settings()) {
    start();
    app_.receive(settings_message(settings), outbox_);
    feed({test::loss_of(500.0, 1.0)}, 2.2);
  }

  Application app_;
  RecordingOutbox outbox_;
};

TEST_F(ApplicationTest, SendsItsHelloFirst) {
  start();
  ASSERT_EQ(outbox_.all.size(), 1U);
  const Uplink& hello = outbox_.all[0];
  EXPECT_EQ(hello.kind, UplinkKind::kHello);
  EXPECT_EQ(hello.sample, 0U);
  EXPECT_EQ(hello.hello.protocol_version, wire::kProtocolVersion);
  EXPECT_EQ(hello.hello.firmware_version, kFirmwareVersion);
  EXPECT_EQ(hello.hello.sample_rate_hz, 8000);
  EXPECT_EQ(hello.hello.nominal_hz, 50);
  EXPECT_EQ(hello.hello.tracker_delay_s, outlet::kFrontEndDelay_s);
  EXPECT_EQ(hello.hello.voltage_delay_s, outlet::kVoltageDelay_s);
  EXPECT_STREQ(hello.hello.id, "outlet-7");
  EXPECT_STREQ(hello.hello.board, "test");
  EXPECT_EQ(hello.hello.instance, 77U);
  EXPECT_EQ(hello.hello.build, 0xABCD1234U);
  EXPECT_EQ(hello.hello.settings_version, 0U);
}

TEST_F(ApplicationTest, DoesNothingOnUnsupportedHardware) {
  outlet::Hardware hardware;
  hardware.sample_rate_hz = 44100;
  EXPECT_FALSE(app_.start(hardware, identity(), nullptr, outbox_));
  const std::vector<std::int16_t> samples(1000);
  app_.feed(samples.data(), samples.size(), outbox_);
  app_.receive(command(false, 9), outbox_);
  app_.receive(settings_message(test::ieee24_settings()), outbox_);
  EXPECT_TRUE(outbox_.all.empty());
  EXPECT_EQ(app_.samples_taken(), 0U);
  EXPECT_TRUE(app_.relay_closed());
}

TEST_F(ApplicationTest, DoesNothingBeforeStart) {
  const std::vector<std::int16_t> samples(1000);
  app_.feed(samples.data(), samples.size(), outbox_);
  EXPECT_TRUE(outbox_.all.empty());
}

TEST_F(ApplicationTest, ASecondStartResetsItsState) {
  start();
  feed_steady(1.0);
  app_.receive(settings_message(test::ieee24_settings()), outbox_);
  app_.receive(command(false, 9), outbox_);
  ASSERT_FALSE(app_.relay_closed());
  outbox_.all.clear();
  start();
  EXPECT_TRUE(app_.relay_closed());
  EXPECT_EQ(app_.samples_taken(), 0U);
  // It has no settings any more: the same version is accepted again.
  app_.receive(settings_message(test::ieee24_settings()), outbox_);
  EXPECT_EQ(outbox_.all.back().settings_answer.error, SettingsError::kNone);
}

TEST_F(ApplicationTest, ReportsEverySixteenMillisecondsStampedWithTheSamplesTaken) {
  start();
  feed_steady(1.0);
  const std::vector<Uplink> measurements = outbox_.of(UplinkKind::kMeasurement);
  ASSERT_EQ(measurements.size(), 62U);
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    EXPECT_EQ(measurements[i].sample, (i + 1) * kSamplesPerReport);
  }
  EXPECT_EQ(measurements.front().measurement.validity, Validity::kInvalid);
  EXPECT_TRUE(std::isnan(measurements.front().measurement.frequency_hz));
  EXPECT_EQ(measurements.back().measurement.validity, Validity::kValid);
  EXPECT_NEAR(measurements.back().measurement.frequency_hz, 50.0F, 1e-3F);
  EXPECT_NEAR(measurements.back().measurement.voltage_pu, 1.0F, 1e-3F);
  EXPECT_EQ(app_.samples_taken(), 8000U);
}

TEST_F(ApplicationTest, AnswersSettingsWithVersionAndDigestInForce) {
  start();
  outlet::Settings settings = test::ieee24_settings();
  settings.version = 3;
  app_.receive(settings_message(settings), outbox_);
  ASSERT_EQ(outbox_.all.size(), 2U);
  const wire::SettingsAnswer& accepted = outbox_.all[1].settings_answer;
  EXPECT_EQ(outbox_.all[1].kind, UplinkKind::kSettingsAnswer);
  EXPECT_EQ(accepted.error, SettingsError::kNone);
  EXPECT_EQ(accepted.version, 3U);
  EXPECT_EQ(accepted.digest, outlet::digest(settings));

  outlet::Settings wrong = settings;
  wrong.version = 4;
  wrong.threshold_mw = -1.0F;
  app_.receive(settings_message(wrong), outbox_);
  outlet::Settings stale = settings;
  stale.accumulated_mw = 1.0F;
  app_.receive(settings_message(stale), outbox_);
  wire::Downlink later = settings_message(wrong);
  later.settings.threshold_mw = settings.threshold_mw;
  later.settings_error = SettingsError::kUnknownField;
  app_.receive(later, outbox_);
  ASSERT_EQ(outbox_.all.size(), 5U);
  EXPECT_EQ(outbox_.all[2].settings_answer.error, SettingsError::kThreshold);
  EXPECT_EQ(outbox_.all[3].settings_answer.error, SettingsError::kStale);
  EXPECT_EQ(outbox_.all[4].settings_answer.error, SettingsError::kUnknownField);
  for (const std::size_t i : {2U, 3U, 4U}) {
    EXPECT_EQ(outbox_.all[i].settings_answer.version, 3U);
    EXPECT_EQ(outbox_.all[i].settings_answer.digest, outlet::digest(settings));
  }
}

TEST_F(ApplicationTest, AnswersRefusedSettingsWithVersionAndDigestZeroIfNoneAreInForce) {
  start();
  outlet::Settings wrong = test::ieee24_settings();
  wrong.threshold_mw = -1.0F;
  app_.receive(settings_message(wrong), outbox_);
  ASSERT_EQ(outbox_.all.size(), 2U);
  EXPECT_EQ(outbox_.all[1].settings_answer.error, SettingsError::kThreshold);
  EXPECT_EQ(outbox_.all[1].settings_answer.version, outlet::kNoSettings);
  EXPECT_EQ(outbox_.all[1].settings_answer.digest, outbox_.all[0].hello.settings_digest);
}

TEST_F(ApplicationTest, AnswersEveryCommandAndReportsRelayChanges) {
  start();
  feed_steady(0.1);
  outbox_.all.clear();
  app_.receive(command(true, 9), outbox_);
  ASSERT_EQ(outbox_.all.size(), 1U);
  EXPECT_EQ(outbox_.all[0].kind, UplinkKind::kCommandAnswer);
  EXPECT_EQ(outbox_.all[0].command_answer.request, 9U);
  EXPECT_TRUE(outbox_.all[0].command_answer.closed);
  app_.receive(command(false, 9), outbox_);
  ASSERT_EQ(outbox_.all.size(), 3U);
  EXPECT_FALSE(outbox_.all[1].command_answer.closed);
  EXPECT_EQ(outbox_.all[2].kind, UplinkKind::kRelay);
  EXPECT_EQ(outbox_.all[2].sample, 800U);
  EXPECT_FALSE(outbox_.all[2].relay.closed);
  EXPECT_EQ(outbox_.all[2].relay.cause, Cause::kCommand);
  EXPECT_FALSE(app_.relay_closed());
  app_.receive(command(true, 9), outbox_);
  ASSERT_EQ(outbox_.all.size(), 5U);
  EXPECT_TRUE(outbox_.all[4].relay.closed);
  EXPECT_EQ(outbox_.all[4].relay.cause, Cause::kNone);
}

TEST_F(ApplicationTest, ReportsAnEventFromDetectionToTheRelay) {
  feed_loss();
  std::vector<UplinkKind> kinds;
  for (const Uplink& message : outbox_.all) {
    if (message.kind != UplinkKind::kMeasurement && message.kind != UplinkKind::kEstimate) {
      kinds.push_back(message.kind);
    }
  }
  EXPECT_THAT(kinds, testing::ElementsAre(UplinkKind::kHello, UplinkKind::kSettingsAnswer,
                                          UplinkKind::kEvent, UplinkKind::kLse,
                                          UplinkKind::kDecision, UplinkKind::kRelay));
  // One with each report from the event to the decision.
  const auto estimates = outbox_.of(UplinkKind::kEstimate);
  EXPECT_EQ((estimates.back().sample - estimates.front().sample) / kSamplesPerReport + 1,
            estimates.size());

  const Uplink event = outbox_.of(UplinkKind::kEvent)[0];
  EXPECT_NEAR(event.event.baseline_hz, 50.0F, 1e-3F);
  EXPECT_NEAR(event.event.baseline_rocof_hz_s, 0.0F, 1e-2F);
  const Uplink lse = outbox_.of(UplinkKind::kLse)[0];
  EXPECT_EQ(lse.sample, event.sample + 9 * kSamplesPerReport) << "the event's report is the first";
  EXPECT_GT(lse.lse.loss_mw, 400.0F);
  const Uplink decision = outbox_.of(UplinkKind::kDecision)[0];
  EXPECT_EQ(estimates.front().sample, event.sample);
  // 40 reports after the onset, which is found with the event or shortly before or after it.
  EXPECT_NEAR(static_cast<double>(decision.sample - event.sample), 40.0 * kSamplesPerReport,
              3.0 * kSamplesPerReport);
  EXPECT_TRUE(decision.decision.shed);
  EXPECT_EQ(decision.decision.trust, outlet::Trust::kTrusted);
  EXPECT_NEAR(decision.decision.loss_mw, 500.0F, 10.0F);
  EXPECT_GT(decision.decision.loss_sigma_mw, 0.5F);
  EXPECT_LT(decision.decision.loss_sigma_mw, 12.0F);
  // Without shedding, the nadir after 500 MW is 49.290 Hz. 148 MW would have to be shed at once,
  // 158 MW must be now.
  EXPECT_NEAR(decision.decision.nadir_hz, 49.290F, 0.02F);
  EXPECT_NEAR(decision.decision.required_mw, 157.0F, 8.0F);
  EXPECT_EQ(decision.decision.shed_before_mw, 0.0F);
  const Uplink estimate = outbox_.of(UplinkKind::kEstimate).back();
  EXPECT_EQ(estimate.sample, decision.sample);
  EXPECT_EQ(estimate.estimate.loss_mw, decision.decision.loss_mw);
  // The loss was at 1 s.
  const double event_s = static_cast<double>(event.sample) / 8000.0;
  EXPECT_NEAR(event_s + static_cast<double>(estimate.estimate.loss_instant_s), 1.0, 0.016);
  const Uplink relay = outbox_.of(UplinkKind::kRelay)[0];
  EXPECT_EQ(relay.sample, decision.sample);
  EXPECT_FALSE(relay.relay.closed);
  EXPECT_EQ(relay.relay.cause, Cause::kLoss);
}

TEST_F(ApplicationTest, SendsTheMeasurementBeforeOtherMessagesOfItsReport) {
  feed_loss();
  std::uint64_t stamp = 0;
  for (const Uplink& message : outbox_.all) {
    EXPECT_GE(message.sample, stamp);
    if (message.sample > stamp) {
      EXPECT_EQ(message.kind, UplinkKind::kMeasurement) << message.sample;
    }
    stamp = message.sample;
  }
}

// Criterion (2) opens the relay in the same report in which criterion (1) is decided. `shed` must
// be true only if the relay opened because of the loss.
TEST_F(ApplicationTest, ATripByTheSwitchOffFrequencyIsNotReportedAsShed) {
  outlet::Settings settings = test::ieee24_settings();
  settings.threshold_mw = 2000.0F;
  settings.switch_off_hz = 49.9F;
  feed_loss(settings);
  ASSERT_EQ(outbox_.of(UplinkKind::kRelay).size(), 1U);
  EXPECT_EQ(outbox_.of(UplinkKind::kRelay)[0].relay.cause, Cause::kFrequency);
  ASSERT_EQ(outbox_.of(UplinkKind::kDecision).size(), 1U);
  EXPECT_FALSE(outbox_.of(UplinkKind::kDecision)[0].decision.shed);
}

TEST_F(ApplicationTest, ReportsAnAbortedEvent) {
  start();
  app_.receive(settings_message(test::ieee24_settings()), outbox_);
  test::MainsSpec spec;
  spec.reference = test::loss_of(500.0, 1.0);
  spec.signal.amplitude_steps = {{1.25, 100.0, 0.0}};
  feed(spec, 2.5);
  EXPECT_EQ(outbox_.of(UplinkKind::kEvent).size(), 1U);
  EXPECT_EQ(outbox_.of(UplinkKind::kAborted).size(), 1U);
  EXPECT_TRUE(outbox_.of(UplinkKind::kDecision).empty());
}

}  // namespace
}  // namespace gs::app
