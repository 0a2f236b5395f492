// The outlet's algorithm: samples in, one report every 16 ms out (Fig. 10). Plain structs and pure
// functions without clock, heap or hidden state, so that any state can be logged, compared and
// replayed. No function blocks.
#pragma once

#include <cstddef>
#include <cstdint>

#include <outlet/estimator.hpp>
#include <outlet/grid_follower.hpp>
#include <outlet/relay_control.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {

enum class Phase : std::uint8_t {
  kQuiet = 0,  // watching for an event
  kEstimating = 1,
  kCooling = 2,  // decided; waiting for a steady frequency
};

struct Config {
  Hardware hardware;
  FrontEndConfig front_end;
  Settings settings;
  bool has_settings = false;  // false: measures and obeys commands, but decides nothing
  Settings next;              // accepted during an event; put into force by renew() afterwards
  bool has_next = false;
  // Derived from the settings.
  FollowerSettings follower;
  GridStep look_ahead;  // over kLookAhead_s
  GridStep lead;        // from a report's phasor to the open relay, with delay_s
};

constexpr float kNoLoss_mw = kLargestSetting;  // State::least_loss_mw before any decision

// What was shed after earlier decisions by the grid's state. Cleared by restoration, by a command
// to switch on, by new settings while the phase is quiet, and by a restart.
struct ShedAccount {
  float shed_mw = 0.0f;          // sum of required_mw of earlier decisions that were followed
  float required_mw = 0.0f;      // by the newest decision; not in shed_mw yet
  float decided_loss_mw = 0.0f;  // lost power at the newest decision
};

struct State {
  FrontEndState front_end;
  TrackerState tracker;
  History history;
  Baseline before_gap;  // of the history that an interruption of the voltage ended; or 0 Hz
  EstimatorState estimator;
  GridFollower follower;
  ShedAccount account;
  // Lost power at the latest decision that more was lost; lowered by later changes that begin or
  // end below it.
  float least_loss_mw = kNoLoss_mw;
  std::uint8_t undisturbed = 0;  // reports since the voltage was disturbed, up to 255
  Phase phase = Phase::kQuiet;
  std::uint16_t steady_reports = 0;   // while cooling
  std::uint8_t below_switch_off = 0;  // successive measurements below f^B
  RelayState relay;
  std::uint32_t reports = 0;  // since start-up
};

// What happened in a report, as bits of Report::happened.
enum Happened : std::uint8_t {
  kEvent = 1,     // an event was detected; baseline is set
  kLse = 2,       // the LSE is done; lse_loss_mw is set
  kEstimate = 4,  // loss_mw and loss_sigma_mw are a new estimate of the current event
  kDecision = 8,  // criterion (1) was decided, for or against
  kRelay = 16,    // the relay was commanded to change
  kAborted = 32,  // an event was abandoned: voltage or samples were lost
};

struct Report {
  std::uint32_t number = 0;  // the report ends with sample (number + 1) · 16 ms
  Measurement measurement;
  Line line;              // least squares over rocof_samples, for the conditions; NaN after a gap
  unsigned happened = 0;  // bits of Happened
  Phase phase = Phase::kQuiet;
  Baseline baseline;
  std::uint16_t hits = 0;    // of the load-shedding conditions in the newest event
  float lse_loss_mw = 0.0f;  // of the newest event
  // Lost power and its standard deviation. Method 0: of the EKF, for the newest event. Method 1: of
  // the follower, in every report; net of all losses, returns and shed load at the time of the
  // phasor.
  float loss_mw = 0.0f;
  float loss_sigma_mw = 0.0f;
  float loss_instant_s = 0.0f;  // relative to the event's report
  // Method 0: see Trust. Method 1: kNotYet without a confirmed change that waits for its decision;
  // otherwise kTrusted if the estimate is sure, or kUncertain.
  Trust trust = Trust::kNotYet;
  // Set with kDecision.
  float required_mw = 0.0f;      // must be shed now; method 0: ΔP_v, eq. (29)
  float nadir_hz = kNotANumber;  // if nothing more is shed; only with method 1, after an onset
  float shed_before_mw = 0.0f;   // State::account.shed_mw; only with method 1
  bool shed = false;             // by criterion (1): the relay opens, now or after delay_s
  bool relay_closed = true;
  Cause cause = Cause::kNone;
};

// Configures the outlet at start-up. Returns false if the hardware is not supported.
bool configure(const Hardware& hardware, Config& config);

// Resets the state to that of start-up. It sets field by field, because a temporary State would not
// fit onto an outlet's stack.
void reset(State& state);

// Applies new settings. Refused settings leave the old ones in force. Settings that are accepted
// during an event, or while a decision is due, come into force afterwards, by renew().
SettingsError apply(Config& config, State& state, const Settings& settings);

// Puts settings that were accepted during an event into force once it is over. To be called after
// each report. Returns true if it did.
bool renew(Config& config, const State& state);

// The settings that were accepted last. Requires has_settings.
const Settings& accepted(const Config& config);

// To be called when samples were lost, before the next step(). Phase and time are then unknown: the
// tracker acquires the frequency again, and a current event is abandoned.
void lose_track(State& state);

// Criterion (3). Returns true if the relay changed. Switching on also clears State::account.
bool command(State& state, bool close);

// Takes up to `count` samples, but none beyond the end of the current report. Returns the number
// taken. `ready` is set if `report` was filled.
std::size_t step(const Config& config, State& state, const std::int16_t* samples, std::size_t count,
                 Report& report, bool& ready);

}  // namespace gs::outlet
