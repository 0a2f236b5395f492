// Emulated serial cables, with raw bytes at both ends.
#include <test_support/waiting.hpp>

#include <memory>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>

#include <emulation/null_modem.hpp>
#include <transport/transport.hpp>

namespace gsbench::test {
namespace {

using namespace std::chrono_literals;
using emulation::NullModem;
using emulation::Way;
using transport::Clock;
using transport::make_transport;
using transport::Transport;
using Bytes = std::vector<std::uint8_t>;

class Cable : public testing::Test {
 protected:
  Cable() { connect(); }

  void connect() {
    EXPECT_TRUE(bench_->open().ok());
    EXPECT_TRUE(outlet_->open().ok());
  }

  static Bytes received(Transport& end, std::size_t wanted) {
    Bytes bytes;
    const auto end_of_patience = Clock::now() + 10s;
    while (bytes.size() < wanted && end.receive(bytes, end_of_patience).ok() &&
           Clock::now() < end_of_patience) {
    }
    return bytes;
  }

  static bool hung_up(Transport& end) {
    Bytes bytes;
    return !end.receive(bytes, Clock::now() + 1ms).ok();
  }

  std::unique_ptr<NullModem> cable_ = NullModem::create().take();
  std::unique_ptr<Transport> bench_ = make_transport(cable_->bench_end());
  std::unique_ptr<Transport> outlet_ =
      make_transport("tcp://127.0.0.1:" + std::to_string(cable_->outlet_end()));
};

TEST_F(Cable, PassesEveryByteBothWays) {
  Bytes all(256);
  std::iota(all.begin(), all.end(), std::uint8_t{0});
  ASSERT_TRUE(outlet_->send(all).ok());
  EXPECT_EQ(received(*bench_, 256), all);
  ASSERT_TRUE(bench_->send(all).ok());
  EXPECT_EQ(received(*outlet_, 256), all);
}

TEST_F(Cable, SpoilsOnlyTheChosenDirection) {
  cable_->spoil([](Bytes& bytes) { bytes.push_back(0x55); });
  ASSERT_TRUE(outlet_->send({1, 2}).ok());
  EXPECT_EQ(received(*bench_, 3), (Bytes{1, 2, 0x55}));
  ASSERT_TRUE(bench_->send({3, 4}).ok());
  EXPECT_EQ(received(*outlet_, 2), (Bytes{3, 4}));
  cable_->spoil({});
  cable_->spoil([](Bytes& bytes) { bytes.push_back(0x66); }, Way::kToOutlet);
  ASSERT_TRUE(outlet_->send({5, 6}).ok());
  EXPECT_EQ(received(*bench_, 2), (Bytes{5, 6}));
  ASSERT_TRUE(bench_->send({7}).ok());
  EXPECT_EQ(received(*outlet_, 2), (Bytes{7, 0x66}));
}

TEST_F(Cable, ClosesBothEndsWhenUnpluggedAndAcceptsAgainWhenPluggedIn) {
  EXPECT_FALSE(hung_up(*bench_));
  EXPECT_FALSE(hung_up(*outlet_));
  cable_->unplug();
  EXPECT_TRUE(until([&] { return hung_up(*bench_) && hung_up(*outlet_); }));
  EXPECT_FALSE(bench_->open().ok());
  EXPECT_FALSE(outlet_->open().ok());
  ASSERT_TRUE(cable_->plug_in().ok());
  connect();
  ASSERT_TRUE(bench_->send({8}).ok());
  EXPECT_EQ(received(*outlet_, 1), (Bytes{8}));
}

TEST_F(Cable, KeepsTheBenchConnectedWhenTheOutletReconnects) {
  outlet_->close();
  ASSERT_TRUE(bench_->send({9}).ok());
  EXPECT_FALSE(hung_up(*bench_));
  ASSERT_TRUE(outlet_->open().ok());
  ASSERT_TRUE(outlet_->send({7}).ok());
  EXPECT_EQ(received(*bench_, 1), (Bytes{7}));
}

// A cable's ports are reserved from its creation on: no other cable gets them.
TEST(NullModem, KeepsItsPortsWhileItIsUnplugged) {
  std::vector<std::unique_ptr<NullModem>> cables;
  std::vector<std::string> ends;
  for (int i = 0; i < 50; ++i) {
    cables.push_back(NullModem::create().take());
    cables.back()->unplug();
    ends.push_back(cables.back()->bench_end());
    ends.push_back("tcp://127.0.0.1:" + std::to_string(cables.back()->outlet_end()));
  }
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(std::adjacent_find(ends.begin(), ends.end()), ends.end());
  for (const auto& cable : cables) {
    EXPECT_TRUE(cable->plug_in().ok());
  }
}

}  // namespace
}  // namespace gsbench::test
