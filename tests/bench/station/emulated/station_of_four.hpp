// A station of four emulated outlets (a Cortex-M4F and a process on serial lines, two processes
// behind a broker), runs with injected faults, and checks of every such run.
#pragma once

#include "emulated_station.hpp"
#include "plans.hpp"
#include "spoilers.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <station/run.hpp>

namespace gsbench::station::test {

// Index in the station and in the record.
enum Place : std::size_t { kM4 = 0, kHost = 1, kRadioA = 2, kRadioB = 3 };

using Outlets = std::vector<emulation::HardwareOutlet>;
Outlets station_of_four();

class FaultyStation : public testing::Test {
 protected:
  void SetUp() override { set_up(station_of_four()); }
  void set_up(const Outlets& outlets);

  emulation::Hardware& hardware() { return station_->hardware(); }

  // Injects a fault when this part of the run, 0 … 1, has been played.
  void at(double part, std::function<void()> fault);
  void play();
  void kill_and_restart(Place outlet) {
    hardware().outlet_process(outlet).kill();
    ASSERT_TRUE(hardware().restart_outlet(outlet).ok());
  }

  // The run is ERROR because of this outlet and reason; the records of the others are complete.
  void expect_fault(Place outlet, const std::string& what) { expect_faults({{outlet, what}}); }
  void expect_faults(const std::map<std::size_t, std::string>& faults);
  // All four passed without a fault.
  void expect_all_complete() { expect_faults({}); }
  void expect_complete(const record::OutletRecord& outlet) const;
  // Neither samples nor messages can be sent any more.
  void expect_safe_state();

  // Undisturbed mains between the marker dips.
  profile::Plan plan_ = plan(1.5, "noise_pct = 1.0\n", "[[outlet]]\ncount = 4\n");
  std::unique_ptr<EmulatedStation> station_;
  record::Writer* writer_ = nullptr;  // of play(); null: in memory
  record::RunRecord record_;
  double wall_s_ = 0.0;

 private:
  struct Fault {
    double part;
    std::function<void()> inject;
    bool injected = false;
  };
  std::vector<Fault> faults_;
};

}  // namespace gsbench::station::test
