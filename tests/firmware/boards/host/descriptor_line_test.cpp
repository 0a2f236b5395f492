// How many bytes a line over a descriptor reads ahead of the outlet.
#include <descriptor_line.hpp>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <wire/frame.hpp>

namespace gs::host {
namespace {

using Bytes = std::vector<std::uint8_t>;

// One end of a pair of connected sockets; the test has the other.
class LineOfAPair : public DescriptorLine {
 public:
  explicit LineOfAPair(int end) : end_(end) {}

 protected:
  int connect(std::string& far_end, std::string& /*why*/) override {
    far_end = "a pair";
    return end_;
  }

 private:
  int end_;
};

class FloodedLine : public testing::Test {
 protected:
  FloodedLine() {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends_), 0);
    line_ = std::make_unique<LineOfAPair>(ends_[0]);
    std::string why;
    EXPECT_TRUE(line_->open(why)) << why;
  }
  ~FloodedLine() override { ::close(ends_[1]); }

  // Sends frames until the socket takes no more.
  void flood() {
    Bytes frames;
    for (std::uint8_t i = 0; i < 100; ++i) {
      frames.insert(frames.end(), {1, 2, 3, 4, static_cast<std::uint8_t>(i + 1), 0});
    }
    while (::send(ends_[1], frames.data(), frames.size(), 0) ==
           static_cast<ssize_t>(frames.size())) {
      sent_.insert(sent_.end(), frames.begin(), frames.end());
    }
  }

  Bytes take() {
    Bytes taken;
    for (std::uint8_t byte = 0; line_->take_byte(byte);) {
      taken.push_back(byte);
    }
    return taken;
  }

  int ends_[2] = {-1, -1};
  std::unique_ptr<DescriptorLine> line_;
  Bytes sent_;
};

constexpr std::size_t kFew = DescriptorLine::kMostReceivedBytes;
constexpr std::size_t kMost = kFew + 1024 + wire::kLongestFrame;

TEST_F(FloodedLine, ReadsNoFurtherWhileBytesWait) {
  flood();
  ASSERT_GT(sent_.size(), 2 * kMost);
  for (int i = 0; i < 10; ++i) {
    line_->serve();
  }
  const std::size_t waiting = take().size();
  EXPECT_GE(waiting, kFew);
  EXPECT_LE(waiting, kMost);
}

TEST_F(FloodedLine, LosesNothing) {
  flood();
  Bytes received;
  Bytes more;
  do {
    line_->serve();
    more = take();
    received.insert(received.end(), more.begin(), more.end());
  } while (!more.empty());
  EXPECT_EQ(received, sent_);
}

}  // namespace
}  // namespace gs::host
