// What gs-outlet reports of its connections, and how they begin and end.
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>
#include <wire_test/messages.hpp>

#include <chrono>

#include <gtest/gtest.h>

#include <emulation/child.hpp>
#include <emulation/listening.hpp>
#include <emulation/null_modem.hpp>
#include <transport/transport.hpp>
#include <wire/codec.hpp>

namespace gsbench::test {
namespace {

using emulation::Child;

class GsOutletOnALine : public testing::Test {
 protected:
  bool says(const std::string& text) const {
    return until(
        [&] { return folder_.read("log").find("gs-outlet: " + text) != std::string::npos; });
  }

  const TemporaryFolder folder_;
  std::unique_ptr<emulation::NullModem> cable_ = demand(emulation::NullModem::create());
  const std::string address_ = "127.0.0.1:" + std::to_string(cable_->outlet_end());
};

TEST_F(GsOutletOnALine, ReportsWhenACentreConnectsAndLeavesAtEachAddressOfItsName) {
  const auto port = demand(emulation::LoopbackPort::reserve());
  const std::string number = std::to_string(port.number());
  const Child outlet = demand(
      Child::start({{GS_OUTLET_PROGRAM, "--listen", "LOCALHOST:" + number + "/", "--id", "a"},
                    folder_.file("log")}));
  EXPECT_TRUE(says("listens at 127.0.0.1:" + number + "\n"));
  for (int i = 0; i < 2; ++i) {
    auto centre = transport::make_transport("tcp://127.0.0.1:" + number);
    ASSERT_TRUE(centre->open().ok());
    EXPECT_TRUE(says("connected to the centre at 127.0.0.1:"));
    centre->close();
    EXPECT_TRUE(says("no longer connected to the centre at 127.0.0.1:"));
  }
}

TEST_F(GsOutletOnALine, ReportsWhenItsLineIsLostAndBack) {
  const Child outlet = demand(
      Child::start({{GS_OUTLET_PROGRAM, "--tcp", address_, "--id", "a"}, folder_.file("log")}));
  EXPECT_TRUE(says("connected to " + address_ + "\n"));
  cable_->unplug();
  EXPECT_TRUE(says("no longer connected to " + address_ + "\n"));
  ASSERT_TRUE(cable_->plug_in().ok());
  EXPECT_TRUE(says("connected again to " + address_ + "\n"));
}

TEST_F(GsOutletOnALine, HalfAFrameOfABrokenConnectionIsNotReportedToTheNextCentre) {
  const auto port = demand(emulation::LoopbackPort::reserve());
  const std::string address = "127.0.0.1:" + std::to_string(port.number());
  const Child outlet =
      demand(Child::start({{GS_OUTLET_PROGRAM, "--listen", address, "--id", "a"}, ""}));
  auto centre = transport::make_transport("tcp://" + address);
  ASSERT_TRUE(until([&] { return centre->open().ok(); }));
  ASSERT_TRUE(centre->send({0x00, 0x07, 0x83, 0x03}).ok());
  centre->close();
  ASSERT_TRUE(until([&] { return centre->open().ok(); }));
  gs::wire::FrameReader reader;
  std::vector<std::uint8_t> bytes;
  std::size_t measurements = 0;
  ASSERT_TRUE(centre->send({0x00}).ok());
  while (measurements < 20) {
    bytes.clear();
    ASSERT_TRUE(
        centre->receive(bytes, std::chrono::steady_clock::now() + std::chrono::seconds(60)).ok());
    for (const gs::wire::test::Bytes& message : gs::wire::test::frames_in(reader, bytes)) {
      gs::wire::Uplink uplink;
      std::uint32_t sequence = 0;
      ASSERT_EQ(gs::wire::decode(message.data(), message.size(), uplink, sequence),
                gs::wire::Decoded::kOk);
      EXPECT_NE(uplink.kind, gs::wire::UplinkKind::kError);
      measurements += uplink.kind == gs::wire::UplinkKind::kMeasurement ? 1 : 0;
    }
  }
}

}  // namespace
}  // namespace gsbench::test
