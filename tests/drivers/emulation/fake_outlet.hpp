// Stands for an outlet's process: reads samples from its terminals on a thread of its own.
#pragma once

#include <fcntl.h>
#include <shared_memory_io/shared_port.hpp>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include <drivers/descriptor.hpp>
#include <emulation/mains.hpp>

namespace gsbench::test {

class FakeOutlet {
 public:
  using Use = std::function<void(const std::int16_t* samples, std::size_t count)>;

  // `use` is called on that thread.
  FakeOutlet(emulation::Mains& mains, std::size_t outlet, Use use = {})
      : FakeOutlet(mains.outlets(), outlet, std::move(use)) {}
  FakeOutlet(const emulation::Terminals& terminals, std::size_t outlet, Use use = {})
      : use_(std::move(use)),
        file_(::open(terminals.path(outlet).c_str(), O_RDWR | O_CLOEXEC)),
        mapped_(mmap(nullptr, sizeof(gs::shared_memory_io::SharedMemory), PROT_READ | PROT_WRITE,
                     MAP_SHARED, file_.get(), 0)),
        port_(*static_cast<gs::shared_memory_io::SharedMemory*>(mapped_)),
        bell_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, terminals.doorbell(outlet).c_str(), sizeof address.sun_path - 1);
    EXPECT_EQ(connect(bell_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    port_.start();
    taking_ = std::thread([this] { take(); });
  }
  ~FakeOutlet() {
    end();
    munmap(mapped_, sizeof(gs::shared_memory_io::SharedMemory));
  }
  FakeOutlet(const FakeOutlet&) = delete;
  FakeOutlet& operator=(const FakeOutlet&) = delete;

  void end() {
    ::shutdown(bell_.get(), SHUT_RDWR);
    if (taking_.joinable()) {
      taking_.join();
    }
  }
  void drive_relay(bool closed) { port_.drive_relay(closed); }
  std::size_t taken() const { return taken_; }
  std::uint32_t lost() const { return lost_; }

 private:
  void take() {
    char rings[64];
    while (::recv(bell_.get(), rings, sizeof rings, 0) > 0) {
      std::int16_t samples[64];
      while (port_.samples_wait()) {
        std::uint32_t lost = 0;
        const std::size_t count = port_.take_samples(samples, 64, lost);
        if (use_) {
          use_(samples, count);
        }
        taken_ += count;
        lost_ += lost;
      }
    }
  }

  Use use_;
  drivers::Descriptor file_;
  void* mapped_;
  gs::shared_memory_io::SharedPort port_;
  drivers::Descriptor bell_;
  std::atomic<std::size_t> taken_{0};
  std::atomic<std::uint32_t> lost_{0};
  std::thread taking_;
};

}  // namespace gsbench::test
