// Outlets' processes on mains, as an emulated station has them.
#pragma once

#include <test_support/mains.hpp>

#include <csignal>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <emulation/hardware.hpp>

namespace gsbench::test {

class EmulatedOutlets {
 public:
  // Throws std::runtime_error.
  EmulatedOutlets(const std::vector<std::string>& ids, emulation::Connection connection) {
    emulation::HardwareOptions options;
    options.host_program = GS_OUTLET_PROGRAM;
    options.real_time = false;
    for (const std::string& id : ids) {
      options.outlets.push_back({id, "host", connection, 0.0});
    }
    auto made = emulation::Hardware::set_up(options);
    if (!made.ok()) {
      throw std::runtime_error(made.error());
    }
    hardware_ = made.take();
  }
  // Stopped, it would not be ended either.
  ~EmulatedOutlets() {
    for (std::size_t i = 0; i < hardware_->outlets(); ++i) {
      signal(i, SIGCONT);
    }
  }
  EmulatedOutlets(const EmulatedOutlets&) = delete;
  EmulatedOutlets& operator=(const EmulatedOutlets&) = delete;

  emulation::Hardware& hardware() const { return *hardware_; }

  // So many measurements of each outlet, of 16 ms; before the first some more, of the time before
  // the source began.
  void play(int reports) {
    source::Source& source = hardware_->source();
    if (tick_ == 0) {
      demand(source.prepare(mains_));
      demand(source.energise());
      demand(source.start());
    }
    for (int i = 0; i < reports; ++i) {
      tick_ += 128;
      demand(source.advance(tick_));
    }
  }

  void signal(std::size_t outlet, int number) {
    if (const pid_t pid = hardware_->outlet_process(outlet).pid(); pid > 0) {
      ::kill(pid, number);
    }
  }
  void kill(std::size_t outlet) { hardware_->outlet_process(outlet).kill(); }
  void start(std::size_t outlet) { demand(hardware_->restart_outlet(outlet)); }

 private:
  template <class T>
  static void demand(const drivers::Result<T>& result) {
    if (!result.ok()) {
      throw std::runtime_error(result.error());
    }
  }

  Mains mains_;
  std::unique_ptr<emulation::Hardware> hardware_;
  std::int64_t tick_ = 0;
};

}  // namespace gsbench::test
