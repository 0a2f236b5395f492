// Outlet processes of an emulated station, on mains of zero voltage.
#pragma once

#include <test_support/demand.hpp>
#include <test_support/mains.hpp>

#include <algorithm>
#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include <emulation/hardware.hpp>

namespace gsbench::test {

class EmulatedOutlets {
 public:
  // Throws std::runtime_error.
  EmulatedOutlets(std::vector<std::string> ids, emulation::Connection connection)
      : ids_(std::move(ids)) {
    emulation::HardwareOptions options;
    options.host_program = GS_OUTLET_PROGRAM;
    options.real_time = false;
    for (const std::string& id : ids_) {
      options.outlets.push_back({id, "host", connection});
    }
    hardware_ = demand(emulation::Hardware::set_up(options));
    mains_.level_pu = 0.0;
  }
  // A stopped process would not end on SIGTERM.
  ~EmulatedOutlets() {
    for (const std::string& id : ids_) {
      signal(id, SIGCONT);
    }
  }
  EmulatedOutlets(const EmulatedOutlets&) = delete;
  EmulatedOutlets& operator=(const EmulatedOutlets&) = delete;

  emulation::Hardware& hardware() const { return *hardware_; }

  // Plays for `reports` measurements of each outlet, 16 ms each. The first call also starts the
  // source, which gives some measurements more.
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

  void signal(const std::string& id, int number) {
    if (const pid_t pid = hardware_->outlet_process(place(id)).pid(); pid > 0) {
      ::kill(pid, number);
    }
  }
  void kill(const std::string& id) { hardware_->outlet_process(place(id)).kill(); }
  void start(const std::string& id) { demand(hardware_->restart_outlet(place(id))); }
  // The outlet's index in the hardware.
  std::size_t place(const std::string& id) const {
    return static_cast<std::size_t>(std::find(ids_.begin(), ids_.end(), id) - ids_.begin());
  }

 private:
  std::vector<std::string> ids_;
  Mains mains_;
  std::unique_ptr<emulation::Hardware> hardware_;
  std::int64_t tick_ = 0;
};

}  // namespace gsbench::test
