// The firmware's estimators for a batch of kLanes trajectories. Arrays of values are ordered by
// sample: the value of sample k in lane i is at [k·kLanes + i].
#pragma once

#include <campaign/conditions.hpp>
#include <campaign/estimates.hpp>
#include <campaign/lanes.hpp>
#include <campaign/paper_model.hpp>
#include <outlet/loss_estimator.hpp>

namespace gsbench::campaign {

struct PaperStart {
  gs::outlet::EkfSettings ekf;
  float t_x_s = 0.0f;  // relative to the first sample
};

struct Estimates {
  float lse_mw[kLanes];
  float ekf_mw[kLanes];
};

// Estimates as an outlet does from its event on. `deviations_hz` has kSamples measurements of each
// trajectory; the first is the measurement of the event. `Parameter` is float, or Lanes if each
// trajectory has its own parameters.
template <class Parameter>
Estimates estimate_as_outlet(const gs::outlet::Settings& settings,
                             const gs::outlet::ResponseOf<Parameter>& response,
                             const float* deviations_hz);

// Estimates as in the paper: LSE over the first samples, then the EKF over the following ones. The
// EKF starts from the result of LSE.
template <class Parameter>
Estimates estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                            const PaperModel<Parameter>& model, const float* deviations_hz);

// Counts in `hits` how often the load-shedding conditions are met. `deviations_hz` has
// counted.first + counted.count measurements. The slope at measurement k is fitted over
// measurements k − window + 1 … k. Therefore counted.first must be at least window − 1.
void count_conditions(const gs::outlet::Settings& settings, float nominal_hz,
                      const Counting& counted, const float* deviations_hz, float hits[kLanes]);

// Takes one measurement of each trajectory. `report`: number of the report, counted from the event,
// which is report 0.
void take_report(const gs::outlet::Settings& settings, gs::outlet::LossEstimator<Lanes>& estimator,
                 const float deviation_hz[kLanes], int report);

}  // namespace gsbench::campaign
