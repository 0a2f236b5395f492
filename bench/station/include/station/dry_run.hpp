// What a run would do. Nothing is energised and no port is opened.
#pragma once

#include <string>
#include <vector>

#include <profile/plan.hpp>
#include <source/source.hpp>
#include <station/station.hpp>

namespace gsbench::station {

struct DryRun {
  std::string source;  // maker and model
  source::Played played;
  std::string accuracy;  // as Station::source_accuracy()
  double boot_s = 0.0;   // longest wait before the signal
  double markers_before_s = 0.0;
  double run_s = 0.0;
  double markers_after_s = 0.0;
  std::vector<Slot> slots;  // slot i is for outlet i of the plan
  // How each clock would be aligned, and its uncertainty as far as it is known before the run.
  struct Clock {
    std::string what;
    std::string aligned_by;
    double uncertainty_ms = 0.0;     // NaN: measured in the run
    std::string not_known_yet = {};  // what adds to it in the run; empty: nothing
  };
  std::vector<Clock> clocks;
};

// Throws profile::ConfigurationError for all that run() refuses before it energises anything.
DryRun dry_run(const profile::Plan& plan, Station& station);

}  // namespace gsbench::station
