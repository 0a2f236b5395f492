// Framed links over TCP, as in an emulated station, and over serial ports: pseudo-terminals, each
// connected to a cable of an emulated station.
#include "pty.hpp"
#include "rigs.hpp"
#include <link_framed/framed_link.hpp>
#include <poll.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <array>
#include <atomic>
#include <optional>
#include <thread>

namespace gsbench::test {
namespace {

class FramedRig : public ProcessRig {
 public:
  FramedRig() : ProcessRig(emulation::Connection::kSerial) {}

  std::shared_ptr<link::Link> make_link() override {
    link::FramedOptions options;
    options.ports = ports();
    return std::make_shared<link::FramedLink>(options);
  }
  void unplug() override { outlets.hardware().cable(0).unplug(); }
  void plug_in() override { EXPECT_TRUE(outlets.hardware().cable(0).plug_in().ok()); }
  FaultTexts fault_texts() const override {
    const std::string port = ports().front();
    return {"does not answer", "was unplugged from " + port, "does not accept messages on " + port};
  }

 protected:
  virtual std::vector<std::string> ports() const { return outlets.hardware().serial_ports(); }
};

class SerialPort {
 public:
  SerialPort(const std::string& path, const std::string& cable_port)
      : pty_(path), cable_(transport::make_transport(cable_port)) {
    EXPECT_TRUE(cable_->open().ok());
    pump_ = std::thread([this] {
      while (!ending_) {
        pass_some();
      }
    });
  }
  ~SerialPort() {
    ending_ = true;
    pump_.join();
  }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

 private:
  void pass_some() {
    std::array<pollfd, 2> waited = {pollfd{pty_.master(), POLLIN, 0},
                                    pollfd{cable_->descriptor(), POLLIN, 0}};
    ::poll(waited.data(), waited.size(), 50);
    if (waited[0].revents != 0) {
      std::vector<std::uint8_t> bytes(4096);
      const ssize_t got = ::read(pty_.master(), bytes.data(), bytes.size());
      bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
      EXPECT_TRUE(cable_->send(bytes).ok());
    }
    std::vector<std::uint8_t> bytes;
    if (waited[1].revents == 0 || !cable_->receive(bytes, transport::Clock::now()).ok()) {
      return;
    }
    for (std::size_t done = 0; done < bytes.size() && !ending_;) {
      const ssize_t put = ::write(pty_.master(), bytes.data() + done, bytes.size() - done);
      done += put > 0 ? static_cast<std::size_t>(put) : 0;
    }
  }

  Pty pty_;
  std::unique_ptr<transport::Transport> cable_;
  std::atomic<bool> ending_{false};
  std::thread pump_;
};

class SerialRig final : public FramedRig {
 public:
  SerialRig() {
    plug_in(0);
    plug_in(1);
  }
  void unplug() override { serial_ports_[0].reset(); }
  void plug_in() override { plug_in(0); }

 protected:
  std::vector<std::string> ports() const override { return {folder_.file("a"), folder_.file("b")}; }

 private:
  void plug_in(std::size_t outlet) {
    serial_ports_.at(outlet).emplace(ports()[outlet], outlets.hardware().serial_ports()[outlet]);
  }

  TemporaryFolder folder_;
  std::array<std::optional<SerialPort>, 2> serial_ports_;
};

}  // namespace

std::unique_ptr<LinkRig> tcp_rig() {
  return std::make_unique<FramedRig>();
}

std::unique_ptr<LinkRig> serial_rig() {
  return std::make_unique<SerialRig>();
}

}  // namespace gsbench::test
