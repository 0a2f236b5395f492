// The firmware's estimators over a batch of trajectories, kLanes at a time. Values stand sample by
// sample: that of sample k and lane i at [k·kLanes + i].
#pragma once

#include <campaign/conditions.hpp>
#include <campaign/estimates.hpp>
#include <campaign/lanes.hpp>
#include <campaign/paper_model.hpp>
#include <outlet/loss_estimator.hpp>

namespace gsbench::campaign {

struct PaperStart {
  gs::outlet::EkfSettings ekf;
  float t_x_s = 0.0f;  // against the first sample
};

struct Estimates {
  float lse_mw[kLanes];
  float ekf_mw[kLanes];
};

// As an outlet does from its event on, the first of kSamples being the event's own. `Parameter`:
// float, or Lanes where each has its own.
template <class Parameter>
Estimates estimate_as_outlet(const gs::outlet::Settings& settings,
                             const gs::outlet::ResponseOf<Parameter>& response,
                             const float* deviations_hz);

// As the paper has it: LSE, and from its result EKF over the samples that follow.
template <class Parameter>
Estimates estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                            const PaperModel<Parameter>& model, const float* deviations_hz);

// How often the load-shedding conditions are met. There are counted.first + counted.count samples,
// of which the line of sample k is that of k − window + 1 … k; the first line lies within them.
void count_conditions(const gs::outlet::Settings& settings, float nominal_hz,
                      const Counting& counted, const float* deviations_hz, float hits[kLanes]);

// One measurement of each, as many reports after the event's own, which is report 0.
void take_report(const gs::outlet::Settings& settings, gs::outlet::LossEstimator<Lanes>& estimator,
                 const float deviation_hz[kLanes], int report);

}  // namespace gsbench::campaign
