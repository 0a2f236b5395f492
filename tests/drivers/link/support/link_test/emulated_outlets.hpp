// Outlets' processes on mains without a voltage, as an emulated station has them.
#pragma once

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
    constexpr std::size_t kTicks = 128;
    const std::vector<float> block(kTicks);
    if (tick_ == 0) {
      source::SourceSettings settings;
      settings.sample_rate_hz = 8000;
      settings.nominal_hz = 50;
      demand(hardware_->source().start(settings));
    }
    for (int i = 0; i < reports; ++i, tick_ += kTicks) {
      demand(hardware_->source().play(tick_, block.data(), kTicks));
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
  static void demand(const drivers::Status& status) {
    if (!status.ok()) {
      throw std::runtime_error(status.error());
    }
  }

  std::unique_ptr<emulation::Hardware> hardware_;
  std::int64_t tick_ = 0;
};

}  // namespace gsbench::test
