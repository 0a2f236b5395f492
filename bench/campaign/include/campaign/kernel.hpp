// The firmware's estimators for a batch of kLanes trajectories. Arrays of values are ordered by
// sample: that of sample k and lane i is at [k·kLanes + i].
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

// As an outlet from its event on; the first of kSamples is that of the event. `Parameter` is float,
// or Lanes if each trajectory has its own parameters.
template <class Parameter>
Estimates estimate_as_outlet(const gs::outlet::Settings& settings,
                             const gs::outlet::ResponseOf<Parameter>& response,
                             const float* deviations_hz);

// As the paper: LSE, then the EKF, started with the result of LSE, over the following samples.
template <class Parameter>
Estimates estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                            const PaperModel<Parameter>& model, const float* deviations_hz);

// Counts in `hits` how often the load-shedding conditions are met. `deviations_hz` has
// counted.first + counted.count measurements. The slope at measurement k is fitted over
// measurements k − window + 1 … k; those of the first slope that counts must exist.
void count_conditions(const gs::outlet::Settings& settings, float nominal_hz,
                      const Counting& counted, const float* deviations_hz, float hits[kLanes]);

// Takes one measurement of each trajectory. `report`: reports since that of the event, which is 0.
void take_report(const gs::outlet::Settings& settings, gs::outlet::LossEstimator<Lanes>& estimator,
                 const float deviation_hz[kLanes], int report);

}  // namespace gsbench::campaign
