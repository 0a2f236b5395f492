// From an event to a lost power: conditions counted, LSE over the first measurements, EKF over the
// rest (§5.2–5.4, Fig. 10), and a status that says whether the result may be acted on.
#pragma once

#include <cstdint>

#include <outlet/event_detector.hpp>
#include <outlet/loss_estimator.hpp>

namespace gs::outlet {

enum class Trust : std::uint8_t {
  kTrusted = 0,
  kNotYet = 1,         // the EKF has not started, or has had too few measurements
  kUnsteadyStart = 2,  // f was not steady before the event: f_0 says little
  kResidual = 3,       // measurements do not follow the model: another loss, another grid
  kAtBound = 4,        // ΔP or t_x stands at what is physical
  kUncertain = 5,      // σ of ΔP above a tenth of it
};
constexpr Trust kLastTrust = Trust::kUncertain;

const char* to_string(Trust trust);

struct EstimatorState : LossEstimator<float> {
  Baseline baseline;
  std::uint16_t reports = 0;  // since the event; the event's own report is 0
  std::uint16_t hits = 0;     // of the load-shedding conditions
};

// With the event's own measurement as the first.
void begin(EstimatorState& state, const Baseline& baseline);

// One report of an event under way: its frequency and the line through the newest few, whose middle
// and slope the conditions are held against. `valid` false: the measurement is passed over, time
// goes on.
void observe(const Settings& settings, float nominal_hz, EstimatorState& state, bool valid,
             float frequency_hz, const Line& line);

// All reports of the estimate are in.
bool complete(const Settings& settings, const EstimatorState& state);

Trust trust(const Settings& settings, const EstimatorState& state);

float loss_sigma_mw(const EstimatorState& state);

// Instant of the loss against the event's report, the tracker's own delay taken off.
float loss_instant_s(const EstimatorState& state);

}  // namespace gs::outlet
