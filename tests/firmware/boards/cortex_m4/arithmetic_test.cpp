// Bit identity of the firmware: the same samples in process, in gs-outlet on a serial line, and on
// the emulated Cortex-M4F at -O2 and -Os.
#include "emulated_outlet.hpp"
#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>
#include <wire_test/downlinks.hpp>

#include <chrono>
#include <iostream>
#include <set>

#include <gmock/gmock.h>

#include <app/endpoint.hpp>
#include <app/self_test.hpp>

namespace gs::test {
namespace {

using wire::UplinkKind;
using wire::test::downlink;
using wire::test::settings_message;

constexpr double kDuration_s = 14.0;

const std::vector<std::int16_t>& stream() {
  static const std::vector<std::int16_t> samples = [] {
    return Mains({loss_of(500.0, 3.0), {}, 1.0})
        .samples(0, static_cast<std::size_t>(8000 * kDuration_s));
  }();
  return samples;
}

struct Outcome {
  std::vector<Message> messages;
  std::set<UplinkKind> kinds;
  std::uint32_t failed_parts = 0;
};

void add(Outcome& outcome, const wire::Uplink& uplink, Message message) {
  outcome.kinds.insert(uplink.kind);
  if (uplink.kind == UplinkKind::kSelfTest) {
    outcome.failed_parts = uplink.self_test.failed;
  }
  outcome.messages.push_back(std::move(message));
}

Outcome in_process(const wire::Uplink& hello) {
  class Collector final : public app::Carrier {
   public:
    bool send(const std::uint8_t* bytes, std::size_t count) override {
      wire::Uplink uplink;
      std::uint32_t sequence = 0;
      EXPECT_EQ(wire::decode(bytes, count, uplink, sequence), wire::Decoded::kOk);
      add(outcome, uplink, Message(bytes, bytes + count));
      return true;
    }
    Outcome outcome;
  };
  class Keeps final : public app::SettingsStorage {
   public:
    bool keep(const outlet::Settings&) override { return true; }
    bool usable() const override { return true; }
  };
  Collector collector;
  Keeps storage;
  app::Application app;
  app::MessageEndpoint endpoint(app, collector);
  const wire::Hello& as = hello.hello;
  app::Identity identity;
  identity.start_number = hello.start_number;
  app::set_text(identity.id, as.id);
  app::set_text(identity.board, as.board);
  identity.instance = as.instance;
  identity.build = as.build;
  identity.capabilities = as.capabilities;
  EXPECT_TRUE(app.start(Mains({steady(50.0, 50.0)}).hardware(), identity, &storage, endpoint));
  app.receive(downlink(wire::DownlinkKind::kIdentify), endpoint);
  app.receive(settings_message(ieee24_settings()), endpoint);
  app.feed(stream().data(), stream().size(), endpoint);
  app.receive(downlink(wire::DownlinkKind::kAskStatus), endpoint);
  app.receive(downlink(wire::DownlinkKind::kAskSelfTest), endpoint);
  return collector.outcome;
}

class BitIdentity : public testing::Test {
 protected:
  Outcome emulated(const std::string& program) {
    outlet_.start(program);
    Line& line = outlet_.line();
    line.wait_for(UplinkKind::kHello);
    line.send(settings_message(ieee24_settings()));
    line.wait_for(UplinkKind::kSettingsAnswer);
    const auto begin = std::chrono::steady_clock::now();
    outlet_.play(stream());
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    std::cout << kDuration_s / wall.count() << " x real time\n";
    line.send(downlink(wire::DownlinkKind::kAskStatus));
    line.send(downlink(wire::DownlinkKind::kAskSelfTest));
    line.wait_for(UplinkKind::kSelfTest);
    Outcome outcome;
    for (const ReceivedMessage& message : line.messages()) {
      add(outcome, message.uplink, message.bytes);
    }
    return outcome;
  }
  Outcome in_process() {
    return test::in_process(outlet_.line().of(UplinkKind::kHello).at(0).uplink);
  }

  EmulatedOutlet outlet_;
};

TEST(Fingerprint, OfTheInProcessFirmwareEqualsTheConstant) {
  EXPECT_EQ(app::arithmetic_fingerprint(), app::kFingerprint);
}

class SameArithmetic : public BitIdentity, public testing::WithParamInterface<const char*> {};

TEST_P(SameArithmetic, SendsTheSameBytesAsInProcess) {
  const Outcome there = emulated(GetParam());
  const Outcome here = in_process();
  ASSERT_GE(stream().size(), 100'000U);
  // The samples must cause every kind of message.
  for (const UplinkKind kind :
       {UplinkKind::kHello, UplinkKind::kSettingsAnswer, UplinkKind::kMeasurement,
        UplinkKind::kEvent, UplinkKind::kLse, UplinkKind::kEstimate, UplinkKind::kDecision,
        UplinkKind::kRelay, UplinkKind::kStatus, UplinkKind::kSelfTest}) {
    EXPECT_EQ(here.kinds.count(kind), 1U) << wire::to_string(kind);
  }
  ASSERT_EQ(there.messages.size(), here.messages.size());
  for (std::size_t i = 0; i < here.messages.size(); ++i) {
    ASSERT_EQ(there.messages[i], here.messages[i]) << "message " << i;
  }
  EXPECT_EQ(there.failed_parts, 0U);
}

TEST_P(SameArithmetic, ThePinChangesAtTheSampleOfTheRelayMessage) {
  emulated(GetParam());
  const auto reported = outlet_.line().of(UplinkKind::kRelay);
  ASSERT_EQ(reported.size(), 1U);
  ASSERT_EQ(outlet_.terminals().edges, 1U);
  EXPECT_EQ(outlet_.terminals().edge[0].closed, 0U);
  EXPECT_EQ(outlet_.terminals().edge[0].sample, reported[0].uplink.sample);
}

INSTANTIATE_TEST_SUITE_P(Programs, SameArithmetic,
                         testing::Values(GS_OUTLET_PROGRAM, GSBENCH_M4_IMAGE, GSBENCH_M4_IMAGE_OS),
                         [](const auto& program) {
                           return std::string(program.index == 0   ? "Process"
                                              : program.index == 1 ? "M4AtO2"
                                                                   : "M4AtOs");
                         });

// Proves the check above: this image is compiled with contraction of multiplication and addition.
TEST_F(BitIdentity, ContractionChangesMessagesAndFailsTheSelfTest) {
  const Outcome there = emulated(GSBENCH_M4_IMAGE_CONTRACTED);
  const Outcome here = in_process();
  EXPECT_NE(there.messages, here.messages);
  EXPECT_EQ(there.failed_parts, std::uint32_t{wire::kArithmetic});
}

}  // namespace
}  // namespace gs::test
