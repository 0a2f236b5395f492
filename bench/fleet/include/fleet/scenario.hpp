// A loss of power and the control that follows: by a fleet's outlets, by a central controller, by
// under-frequency relays, or none.
//
// Outlets measure every 16 ms and are not synchronised. A measurement is the frequency 28 ms
// earlier (front-end delay) plus noise. Load shed by other outlets changes the frequency that an
// outlet measures. Outlets detect the loss at the sixth measurement of the time after it, 108 … 124
// ms after the loss. (The firmware needs 104 … 152 ms, because its tracker smooths the frequency.)
// 49 measurements later they estimate the loss and compare it with the threshold, by the firmware's
// code for method 0. This model leaves out the load-shedding conditions of the firmware and its
// check whether an estimate is plausible.
#pragma once

#include <optional>
#include <vector>

#include <campaign/estimates.hpp>
#include <fleet/fleet.hpp>

namespace gsbench::fleet {

enum class Control : std::uint8_t {
  kNone,
  kGridSense,  // each outlet by its own estimate (§5.5, criterion 1)
  kSwitchOff,  // each outlet by its switching-off frequency alone (criterion 2)
  kCentral,    // a controller that knows the loss sheds the required power after its delay
  kUfls,       // under-frequency load shedding by relays
};

// Parameters of outlets, controller and relays. Delays are 0 … 300 s.
struct Controls {
  double threshold_mw = 0.0;        // threshold loss of outlets and controller; 0: by the rules
  double central_decision_s = 0.9;  // from the loss until the controller knows it
  double central_delay_s = 1.0;     // communication of its commands
  double ufls_first_hz = 0.0;       // first stage; 0: 0.98 of the nominal frequency (49 Hz)
  double ufls_step_hz = 0.2;        // from one stage to the next lower one
  double ufls_part = 0.05;          // part of the grid's load that each stage sheds
  double ufls_delay_s = 0.15;       // from the frequency of a stage to its action
};

struct ScenarioOptions : Controls {
  Control control = Control::kGridSense;
  control_centre::Rules rules = control_centre::Rules::kGsbench;  // of the outlets' settings
  double loss_mw = 500.0;  // above 0, at most the grid's base power
  campaign::NoiseDistribution distribution = campaign::NoiseDistribution::kUniform;
  double noise_hz = 0.01;        // 0 … 1; half width if uniform, standard deviation if Gaussian
  double further_delay_s = 0.0;  // 0 … 300; of every outlet's action, added to its relay's
  double duration_s = 20.0;      // 1 … 300, from the loss
  std::uint64_t seed = 1;
};

// Times count from the loss.
struct ScenarioResult {
  Shed shed;                  // by outlets; for controller and relays the power alone
  double threshold_mw = 0.0;  // the one in use: of the options, or by their rules
  double required_mw = 0.0;   // max(loss − threshold loss, 0)
  double nadir_hz = 0.0;
  double nadir_s = 0.0;
  double end_hz = 0.0;
  double first_action_s = 0.0;  // NaN without an action
  double last_action_s = 0.0;
  std::vector<double> t_s;  // every 20 ms
  std::vector<double> frequency_hz;
};

constexpr std::size_t kUflsStages = 5;

// Deviation from nominal below which each stage of the relays acts, Hz, from the first stage down.
std::vector<double> ufls_stages_hz(const grid::Grid& grid, const Controls& controls);

// Throws std::invalid_argument for a delay out of range.
void check(const Controls& controls);

// Blocks until the end. Returns nothing if `execution` was stopped before. Throws
// std::invalid_argument for options out of range.
std::optional<ScenarioResult> simulate(const grid::Grid& grid, const Fleet& fleet,
                                       const ScenarioOptions& options,
                                       const campaign::Execution& execution);

}  // namespace gsbench::fleet
