// Serial cables without hardware, with raw bytes at both ends.
#include "descriptor.hpp"
#include "waiting.hpp"
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <cstring>
#include <memory>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <emulation/null_modem.hpp>

namespace {

using gsbench::emulation::Descriptor;
using gsbench::emulation::NullModem;
using gsbench::test::TemporaryFolder;
using gsbench::test::until;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

Descriptor terminal(const std::string& path) {
  return Descriptor(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
}

Descriptor connected(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  Descriptor end(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  EXPECT_EQ(connect(end.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0)
      << std::strerror(errno);
  return end;
}

void write_all(const Descriptor& end, const Bytes& bytes) {
  ASSERT_EQ(::write(end.get(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
}

// As many bytes as are wanted, or what has come in ten seconds.
Bytes read_some(const Descriptor& end, std::size_t wanted) {
  Bytes bytes;
  until([&] {
    std::uint8_t more[512];
    const ssize_t got = ::recv(end.get(), more, sizeof more, MSG_DONTWAIT);
    const ssize_t read = got < 0 && errno == ENOTSOCK ? ::read(end.get(), more, sizeof more) : got;
    if (read > 0) {
      bytes.insert(bytes.end(), more, more + read);
    }
    return bytes.size() >= wanted;
  });
  return bytes;
}

// What a reader of the end is told when the cable goes.
bool hung_up(const Descriptor& end) {
  pollfd waited{end.get(), POLLIN, 0};
  ::poll(&waited, 1, 0);
  return (waited.revents & POLLHUP) != 0;
}

// Every value a byte can have: none may mean anything to a terminal.
Bytes all_bytes() {
  Bytes bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

class Cable : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    auto made =
        GetParam() ? NullModem::to_socket(folder_.file("line")) : NullModem::between_terminals();
    ASSERT_TRUE(made.ok()) << made.error();
    cable_ = std::make_unique<NullModem>(made.take());
    bench_ = terminal(cable_->bench_end());
    outlet_ = plug_in_outlet();
    ASSERT_TRUE(bench_.is_open());
    ASSERT_TRUE(outlet_.is_open());
  }

  Descriptor plug_in_outlet() const {
    return GetParam() ? connected(cable_->outlet_end()) : terminal(cable_->outlet_end());
  }

  TemporaryFolder folder_;
  std::unique_ptr<NullModem> cable_;
  Descriptor bench_;
  Descriptor outlet_;
};

TEST_P(Cable, PassesEveryByteFromTheOutletToTheBench) {
  write_all(outlet_, all_bytes());
  EXPECT_EQ(read_some(bench_, 256), all_bytes());
}

TEST_P(Cable, PassesEveryByteFromTheBenchToTheOutlet) {
  write_all(bench_, all_bytes());
  EXPECT_EQ(read_some(outlet_, 256), all_bytes());
}

TEST_P(Cable, SpoilsWhatTheOutletSaysAndNothingElse) {
  cable_->spoil([](Bytes& bytes) { bytes.push_back(0x55); });
  write_all(outlet_, {1, 2});
  EXPECT_EQ(read_some(bench_, 3), (Bytes{1, 2, 0x55}));
  write_all(bench_, {3, 4});
  EXPECT_EQ(read_some(outlet_, 2), (Bytes{3, 4}));
  cable_->spoil({});
  write_all(outlet_, {5, 6});
  EXPECT_EQ(read_some(bench_, 2), (Bytes{5, 6}));
}

TEST_P(Cable, ThatIsPulledHangsUpAtBothEnds) {
  EXPECT_FALSE(hung_up(bench_));
  EXPECT_FALSE(hung_up(outlet_));
  cable_.reset();
  EXPECT_TRUE(until([&] { return hung_up(bench_) && hung_up(outlet_); }));
}

TEST_P(Cable, KeepsTheBenchsEndWhenTheOutletGoesAndComesBack) {
  outlet_.close();
  write_all(bench_, {9});
  EXPECT_FALSE(hung_up(bench_));
  outlet_ = plug_in_outlet();
  write_all(outlet_, {7});
  EXPECT_EQ(read_some(bench_, 1), (Bytes{7}));
}

INSTANTIATE_TEST_SUITE_P(Kinds, Cable, testing::Bool(), [](const auto& kind) {
  return kind.param ? "ToASocket" : "BetweenTerminals";
});

TEST(NullModem, TellsWhereItCannotListen) {
  const auto cable = NullModem::to_socket("/nowhere/line");
  ASSERT_FALSE(cable.ok());
  EXPECT_THAT(cable.error(), HasSubstr("/nowhere/line"));
  const auto too_long = NullModem::to_socket("/" + std::string(200, 'x'));
  ASSERT_FALSE(too_long.ok());
  EXPECT_THAT(too_long.error(), HasSubstr("too long for a socket"));
}

}  // namespace
