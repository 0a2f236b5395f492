#include "serial_adapter.hpp"

#include <poll.h>
#include <test_support/waiting.hpp>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <drivers/descriptor.hpp>

namespace gsbench::test {
namespace {

constexpr int kMostBehind_ms = 100;  // a bench that takes nothing for so long loses bytes

void write_all(int to, const std::vector<std::uint8_t>& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t put = ::write(to, bytes.data() + done, bytes.size() - done);
    if (put > 0) {
      done += static_cast<std::size_t>(put);
    } else if (!drivers::wait_for(to, POLLOUT, kMostBehind_ms)) {
      return;
    }
  }
}

}  // namespace

SerialAdapter::SerialAdapter(const std::string& instrument)
    : instrument_(transport::make_transport(instrument)), thread_([this] { run(); }) {
  wait_for_port(true);
}

SerialAdapter::~SerialAdapter() {
  ending_ = true;
  thread_.join();
}

void SerialAdapter::wait_for_port(bool there) const {
  if (!until([&] { return is_there_ == there; })) {
    throw std::runtime_error("the emulated serial adapter does not follow its instrument");
  }
}

void SerialAdapter::wait_for_more_plugs_than(int times) const {
  if (!until([&] { return plugs_ > times; })) {
    throw std::runtime_error("the emulated serial adapter is not plugged in again");
  }
}

// The new port is there before the old one hangs up.
void SerialAdapter::plug() {
  const std::string device = folder_.file("tty" + std::to_string(plugs_));
  auto next = std::make_unique<Pty>(device);
  const std::string link = device + "-link";
  std::filesystem::create_symlink(device, link);
  std::filesystem::rename(link, port());
  pty_ = std::move(next);
  ++plugs_;
}

void SerialAdapter::run() {
  while (!ending_) {
    if (instrument_->open().ok()) {
      plug();
      is_there_ = true;
      pass_bytes();
    } else if (pty_) {
      std::filesystem::remove(port());
      pty_.reset();
      is_there_ = false;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
}

// Until the instrument closes its connection.
void SerialAdapter::pass_bytes() {
  std::vector<std::uint8_t> bytes;
  while (!ending_) {
    pollfd waited[] = {{instrument_->descriptor(), POLLIN, 0}, {pty_->master(), POLLIN, 0}};
    constexpr int kAtMost_ms = 20;
    ::poll(waited, 2, kAtMost_ms);
    bytes.clear();
    if (!instrument_->receive(bytes, transport::Clock::now()).ok()) {
      return;
    }
    write_all(pty_->master(), bytes);
    bytes.resize(4096);
    const ssize_t got = ::read(pty_->master(), bytes.data(), bytes.size());
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    if (!bytes.empty() && !instrument_->send(bytes, std::chrono::seconds(2)).ok()) {
      return;
    }
  }
}

}  // namespace gsbench::test
