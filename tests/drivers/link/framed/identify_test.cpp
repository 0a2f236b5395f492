// When a framed link sends `identify`.
#include <link_framed/framed_link.hpp>
#include <test_support/demand.hpp>
#include <test_support/waiting.hpp>
#include <wire_test/messages.hpp>

#include <chrono>
#include <string>

#include <gtest/gtest.h>

#include <emulation/null_modem.hpp>
#include <transport/transport.hpp>

namespace gsbench::test {
namespace {

using gs::wire::UplinkKind;
using IdentifyClock = std::chrono::steady_clock;

// An outlet on a cable that sends what the test makes it send, and counts `identify`.
class AskedOutlet : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(port_->open().ok()); }

  void send(UplinkKind kind, std::uint32_t session = 0) {
    gs::wire::Uplink message;
    message.kind = kind;
    message.start_number = 7;
    if (kind == UplinkKind::kHello) {
      message.hello.id[0] = 'a';
      message.hello.sample_rate_hz = 8000;
      message.hello.nominal_hz = 50;
      message.hello.session = session;
      message.hello.next_number = measurements_;
    } else {
      message.measurement = {};
    }
    const bool is_hello = kind == UplinkKind::kHello;
    ASSERT_TRUE(port_
                    ->send(gs::wire::test::framed(
                        gs::wire::test::encoded(message, is_hello ? 0 : measurements_++)))
                    .ok());
  }

  // Takes what arrives within some milliseconds.
  void receive() {
    gs::wire::test::Bytes bytes;
    ASSERT_TRUE(port_->receive(bytes, IdentifyClock::now() + std::chrono::milliseconds(5)).ok());
    for (const auto& message : gs::wire::test::frames_in(reader_, bytes)) {
      gs::wire::Downlink downlink;
      std::uint32_t sequence = 0;
      ASSERT_EQ(gs::wire::decode(message.data(), message.size(), downlink, sequence),
                gs::wire::Decoded::kOk);
      EXPECT_EQ(downlink.kind, gs::wire::DownlinkKind::kIdentify);
      ++identifies_;
      session_ = downlink.session;
    }
  }

  bool has_joined() {
    link::Happenings happenings;
    EXPECT_TRUE(link_.poll(happenings).ok());
    return !happenings.changes.empty();
  }

  static link::FramedOptions on(const emulation::NullModem& cable) {
    link::FramedOptions options;
    options.ports = {cable.bench_end()};
    return options;
  }

  std::unique_ptr<emulation::NullModem> cable_ = demand(emulation::NullModem::create());
  std::unique_ptr<transport::Transport> port_ =
      transport::make_transport("tcp://127.0.0.1:" + std::to_string(cable_->outlet_end()));
  link::FramedLink link_{on(*cable_)};
  gs::wire::FrameReader reader_;
  std::uint32_t measurements_ = 0;
  std::uint32_t identifies_ = 0;
  std::uint32_t session_ = 0;
};

// wire/README.md: at once with the first message of a start, then every 0.5 s until the hello with
// the centre's session arrives.
TEST_F(AskedOutlet, IsAskedEveryHalfSecondUntilItsHelloArrives) {
  const auto began = IdentifyClock::now();
  ASSERT_TRUE(link_.open().ok());
  while (identifies_ < 6) {
    send(UplinkKind::kMeasurement);
    receive();
  }
  // One when the port is opened, one for the first measurement, and four every 0.5 s.
  EXPECT_GE(IdentifyClock::now() - began, std::chrono::milliseconds(4 * 500));
  EXPECT_GT(measurements_, 4 * identifies_);
  EXPECT_FALSE(has_joined());

  send(UplinkKind::kHello, session_);
  ASSERT_TRUE(until([&] { return has_joined(); }));
  receive();
  const std::uint32_t until_hello = identifies_;
  const auto joined = IdentifyClock::now();
  while (IdentifyClock::now() - joined < std::chrono::milliseconds(3 * 500)) {
    send(UplinkKind::kMeasurement);
    receive();
  }
  EXPECT_LE(identifies_, until_hello + 1) << "one may have been on its way";
}

// Such as the answer to another centre: it describes the outlet, but shows no `identify` of this
// one.
TEST_F(AskedOutlet, IsAskedFurtherAfterAHelloWithoutTheSession) {
  ASSERT_TRUE(link_.open().ok());
  send(UplinkKind::kHello);
  ASSERT_TRUE(until([&] { return has_joined(); }));
  while (identifies_ < 4) {
    send(UplinkKind::kMeasurement);
    receive();
  }
}

}  // namespace
}  // namespace gsbench::test
