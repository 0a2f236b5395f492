// Estimate of the lost power after an event (§5.2–5.4, Fig. 10). The estimator runs the LSE over
// the first measurements and the EKF over the rest. It counts how often the load-shedding
// conditions are met, and rates the result (Trust).
#pragma once

#include <cstdint>

#include <outlet/event_detector.hpp>
#include <outlet/loss_estimator.hpp>

namespace gs::outlet {

enum class Trust : std::uint8_t {
  kTrusted = 0,
  kNotYet = 1,         // the EKF has not started, or has had too few measurements
  kUnsteadyStart = 2,  // f was not steady before the event, so f_0 is not reliable
  kResidual = 3,       // measurements do not follow the model: another loss, another grid
  kAtBound = 4,        // ΔP or t_x is at a physical bound
  kUncertain = 5,      // σ of ΔP above a tenth of ΔP
};
constexpr Trust kLastTrust = Trust::kUncertain;

const char* to_string(Trust trust);

struct EstimatorState : LossEstimator<float> {
  Baseline baseline;
  std::uint16_t reports = 0;  // since the event; the event's own report is 0
  std::uint16_t hits = 0;     // of the load-shedding conditions
};

// Starts an estimate. The first call of observe() must pass the event's own measurement.
void begin(EstimatorState& state, const Baseline& baseline);

// Takes one report of the current event. Must be called for every report, each 16 ms. The
// conditions are evaluated on `line`, which is fitted through the newest measurements. If `valid`
// is false, the measurement is ignored, but the report still counts as elapsed time.
void observe(const Settings& settings, float nominal_hz, EstimatorState& state, bool valid,
             float frequency_hz, const Line& line);

// True once all reports of the estimate have been taken.
bool complete(const Settings& settings, const EstimatorState& state);

Trust trust(const Settings& settings, const EstimatorState& state);

float loss_sigma_mw(const EstimatorState& state);

// Instant of the loss relative to the event's report, s. The tracker's delay is subtracted.
float loss_instant_s(const EstimatorState& state);

}  // namespace gs::outlet
