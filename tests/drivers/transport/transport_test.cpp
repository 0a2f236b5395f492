// Tests for every transport, then tests for one of them.
#include "pty.hpp"
#include <poll.h>
#include <sys/socket.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <memory>
#include <numeric>
#include <optional>

#include <gmock/gmock.h>

#include <emulation/listening.hpp>
#include <transport/transport.hpp>

namespace gsbench::transport {
namespace {

using namespace std::chrono_literals;
using drivers::Descriptor;
using emulation::LoopbackPort;
using test::Pty;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using Bytes = std::vector<std::uint8_t>;

// Not reached in a passing test.
constexpr auto kPatience = 10s;

// The far end of a transport.
class FarEnd {
 public:
  virtual ~FarEnd() = default;
  virtual std::string port() const = 0;
  virtual int descriptor() = 0;  // valid while the transport is open
  virtual void hang_up() = 0;
};

class TcpFarEnd final : public FarEnd {
 public:
  TcpFarEnd() : port_(LoopbackPort::reserve().take()) { EXPECT_TRUE(port_.listen().ok()); }
  std::string port() const override { return "tcp://127.0.0.1:" + std::to_string(port_.number()); }
  int descriptor() override {
    if (!connection_.is_open()) {
      pollfd waited{port_.descriptor(), POLLIN, 0};
      ::poll(&waited, 1, 10000);
      connection_ = port_.accept();
    }
    return connection_.get();
  }
  void hang_up() override {
    descriptor();
    connection_.close();
  }

 private:
  LoopbackPort port_;
  Descriptor connection_;
};

class SerialFarEnd final : public FarEnd {
 public:
  std::string port() const override { return folder_.file("port"); }
  int descriptor() override { return pty_->master(); }
  void hang_up() override { pty_.reset(); }

 private:
  TemporaryFolder folder_;
  std::optional<Pty> pty_{std::in_place, folder_.file("port")};
};

// True for a serial port.
class AnyTransport : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (GetParam()) {
      far_ = std::make_unique<SerialFarEnd>();
    } else {
      far_ = std::make_unique<TcpFarEnd>();
    }
    transport_ = make_transport(far_->port());
    const auto opened = transport_->open();
    ASSERT_TRUE(opened.ok()) << opened.error();
  }

  void far_end_sends(const Bytes& bytes) {
    ASSERT_EQ(::write(far_->descriptor(), bytes.data(), bytes.size()),
              static_cast<ssize_t>(bytes.size()));
  }

  Bytes received(std::size_t wanted) {
    Bytes bytes;
    const auto until = Clock::now() + kPatience;
    while (bytes.size() < wanted && Clock::now() < until) {
      const auto status = transport_->receive(bytes, until);
      EXPECT_TRUE(status.ok()) << status.error();
    }
    return bytes;
  }

  std::unique_ptr<FarEnd> far_;
  std::unique_ptr<Transport> transport_;
};

// The terminal must not interpret any byte value.
TEST_P(AnyTransport, PassesEveryByteBothWays) {
  Bytes all(256);
  std::iota(all.begin(), all.end(), std::uint8_t{0});
  far_end_sends(all);
  EXPECT_EQ(received(256), all);
  ASSERT_TRUE(transport_->send(all).ok());
  Bytes came(256);
  std::size_t count = 0;
  for (pollfd ready{far_->descriptor(), POLLIN, 0}; count < 256 && ::poll(&ready, 1, 10000) > 0;) {
    count += static_cast<std::size_t>(::read(ready.fd, came.data() + count, came.size() - count));
  }
  EXPECT_EQ(came, all);
}

TEST_P(AnyTransport, ReceivesNothingFromASilentFarEndUntilTheDeadline) {
  Bytes bytes;
  const auto until = Clock::now() + 50ms;
  EXPECT_TRUE(transport_->receive(bytes, until).ok());
  EXPECT_GE(Clock::now(), until);
  EXPECT_THAT(bytes, IsEmpty());
}

TEST_P(AnyTransport, ReturnsBeforeTheDeadlineWhenBytesArrive) {
  far_end_sends({1});
  Bytes bytes;
  const auto begin = Clock::now();
  EXPECT_TRUE(transport_->receive(bytes, begin + kPatience).ok());
  EXPECT_LT(Clock::now(), begin + kPatience / 2);
  EXPECT_EQ(bytes, Bytes{1});
}

TEST_P(AnyTransport, DistinguishesAFarEndThatHungUpFromASilentOne) {
  far_->hang_up();
  Bytes bytes;
  const auto status = transport_->receive(bytes, Clock::now() + kPatience);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error(), StartsWith(far_->port() + ": cannot be read: "));
  // A TCP connection accepts bytes until the far end's reset has arrived.
  const auto until = Clock::now() + kPatience;
  auto sent = transport_->send({1});
  while (sent.ok() && Clock::now() < until) {
    sent = transport_->send({1});
  }
  ASSERT_FALSE(sent.ok());
  EXPECT_THAT(sent.error(), StartsWith(far_->port() + ": cannot be sent to: "));
}

TEST_P(AnyTransport, FailsToSendIfTheFarEndAcceptsNoData) {
  far_->descriptor();
  const auto status = transport_->send(Bytes(std::size_t{32} << 20));
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error(), far_->port() + ": cannot be sent to: accepts no data");
}

TEST_P(AnyTransport, IsOpenOnlyBetweenOpenAndClose) {
  EXPECT_TRUE(check_port(far_->port()).ok());
  EXPECT_TRUE(transport_->is_open());
  transport_->close();
  EXPECT_FALSE(transport_->is_open());
  Bytes bytes;
  EXPECT_THAT(transport_->send({1}).error(), HasSubstr("not open"));
  EXPECT_THAT(transport_->receive(bytes, Clock::now()).error(), HasSubstr("not open"));
  EXPECT_TRUE(transport_->open().ok());
  EXPECT_TRUE(transport_->is_open());
}

INSTANTIATE_TEST_SUITE_P(Kinds, AnyTransport, testing::Bool(),
                         [](const auto& kind) { return kind.param ? "Serial" : "Tcp"; });

std::string refusal(const std::string& port) {
  const auto opened = make_transport(port)->open();
  return opened.ok() ? "it opened" : opened.error();
}

TEST(Serial, DiscardsBytesReceivedBeforeItWasOpened) {
  const TemporaryFolder folder;
  const Pty pty(folder.file("port"));
  ASSERT_EQ(::write(pty.master(), "old", 3), 3);
  const auto port = make_transport(folder.file("port"));
  ASSERT_TRUE(port->open().ok());
  ASSERT_EQ(::write(pty.master(), "new", 3), 3);
  Bytes bytes;
  ASSERT_TRUE(port->receive(bytes, Clock::now() + kPatience).ok());
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "new");
}

TEST(Serial, IsLockedAgainstOtherPrograms) {
  const TemporaryFolder folder;
  const Pty pty(folder.file("port"));
  const auto first = make_transport(folder.file("port"));
  ASSERT_TRUE(first->open().ok());
  const std::string in_use =
      folder.file("port") + ": cannot be opened: another program has it open: process ";
  EXPECT_THAT(refusal(folder.file("port")), StartsWith(in_use + std::to_string(getpid()) + " ("));
  first->close();
  EXPECT_EQ(refusal(folder.file("port")), "it opened");
}

TEST(Serial, ReportsAMissingPortAndAFileThatIsNotAPort) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal("/dev/no-such-port"), StartsWith("/dev/no-such-port: cannot be found"));
  EXPECT_EQ(check_port("/dev/no-such-port").error(),
            "/dev/no-such-port: No such file or directory");
  const std::string file = folder.write("file", "text");
  EXPECT_THAT(refusal(file), StartsWith(file + ": cannot be opened: is not a serial port"));
}

TEST(Tcp, ReportsAPortWithoutAListener) {
  const LoopbackPort reserved = LoopbackPort::reserve().take();
  const std::string port = "tcp://127.0.0.1:" + std::to_string(reserved.number());
  EXPECT_EQ(refusal(port), port + ": cannot be connected to: Connection refused");
}

TEST(Tcp, AcceptsAnIpv6AddressInBrackets) {
  EXPECT_TRUE(check_port("tcp://[::1]:5000").ok());
  // Port 1 is closed: the address was understood.
  EXPECT_EQ(refusal("tcp://[::1]:1"), "tcp://[::1]:1: cannot be connected to: Connection refused");
}

TEST(Tcp, SchemeMayBeInUpperCaseAndASlashMayFollow) {
  LoopbackPort listening = LoopbackPort::reserve().take();
  ASSERT_TRUE(listening.listen().ok());
  const std::string end = "://127.0.0.1:" + std::to_string(listening.number());
  for (const std::string& port : {"tcp" + end, "TCP" + end, "Tcp" + end + '/'}) {
    EXPECT_TRUE(check_form(port).ok()) << port;
    EXPECT_EQ(refusal(port), "it opened") << port;
    EXPECT_EQ(in_one_form(port), "tcp" + end) << port;
  }
  EXPECT_EQ(in_one_form("tcp://[::1]:05000/"), "tcp://[::1]:5000");
  EXPECT_EQ(in_one_form("/dev/ttyUSB0"), "/dev/ttyUSB0");
}

TEST(Transport, ATextThatIsNoPortIsRefusedByItsForm) {
  const std::string is_none = " is neither of the form tcp://host:port nor the path of a device";
  EXPECT_EQ(check_form("").error(), "an empty text" + is_none);
  EXPECT_EQ(check_form("COM7").error(), "COM7:" + is_none);
}

TEST(Tcp, RefusesInvalidAddresses) {
  for (const std::string wrong :
       {"tcp://", "tcp://host", "tcp://host:", "tcp://:5000", "tcp://host:65536", "tcp://[::1:5000",
        "tcp://host:http", "tcp://host:123456", "tcp://::1:5000", "TCP://host:5000//"}) {
    EXPECT_EQ(check_port(wrong).error(),
              wrong + ": is not of the form tcp://host:port, with a port from 1 to 65535");
    EXPECT_EQ(refusal(wrong),
              wrong + ": is not of the form tcp://host:port, with a port from 1 to 65535");
  }
}

}  // namespace
}  // namespace gsbench::transport
