// A loss of power and what is done about it: by a fleet's outlets, each at the instant of its own
// decision and by the frequency that it measures, which what others have shed already changes; by a
// central controller; by under-frequency relays; by nobody.
//
// Outlets measure every 16 ms, each at an instant of its own, the frequency of 28 ms before (the
// front end's delay) with noise. They detect the loss once its drops are in, the sixth measurement
// after it, which is what the firmware's detector does behind its tracker (104 … 152 ms); estimate
// and decide by the firmware's own code 49 measurements later. The firmware's load-shedding
// conditions and its own flag on an estimate are not in here.
#pragma once

#include <optional>
#include <vector>

#include <campaign/estimates.hpp>
#include <fleet/fleet.hpp>

namespace gsbench::fleet {

enum class Control : std::uint8_t {
  kNone,
  kGridSense,  // each outlet by its own estimate (§5.5, criterion 1)
  kSwitchOff,  // each outlet below its switching-off frequency alone (criterion 2)
  kCentral,    // a controller that knows the loss sheds what is wanted, after its delay
  kUfls,       // under-frequency load shedding by relays
};

struct ScenarioOptions {
  Control control = Control::kGridSense;
  double loss_mw = 500.0;
  campaign::NoiseDistribution distribution = campaign::NoiseDistribution::kUniform;
  double noise_hz = 0.01;
  double threshold_mw = 0.0;        // that outlets and controller are told; 0: the grid's
  double further_delay_s = 0.0;     // of every outlet's action, beyond its relay's
  double central_decision_s = 0.9;  // until the controller knows the loss
  double central_delay_s = 1.0;     // of its commands
  double ufls_first_hz = 0.0;       // of relays: 0: a fiftieth below nominal (49 Hz)
  double ufls_step_hz = 0.2;
  double ufls_part = 0.05;  // of the load, at each of five stages
  double ufls_delay_s = 0.15;
  double duration_s = 20.0;
  std::uint64_t seed = 1;
};

struct ScenarioResult {
  Shed shed;               // by outlets; for controller and relays the power alone
  double wanted_mw = 0.0;  // loss above the grid's threshold
  double nadir_hz = 0.0;
  double nadir_s = 0.0;
  double end_hz = 0.0;
  double first_action_s = 0.0;  // NaN where there was none
  double last_action_s = 0.0;
  std::vector<double> t_s;  // the course, every 20 ms
  std::vector<double> frequency_hz;
};

// Throws std::invalid_argument for what makes no sense. Nothing where it was stopped before its
// end.
std::optional<ScenarioResult> play(const grid::Grid& grid, const Fleet& fleet,
                                   const ScenarioOptions& options,
                                   const campaign::Execution& execution);

}  // namespace gsbench::fleet
