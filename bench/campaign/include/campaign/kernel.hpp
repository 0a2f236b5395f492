// The firmware's estimators over a batch of trajectories, kLanes at a time. Values stand sample by
// sample: that of sample k and lane i at [k·kLanes + i].
#pragma once

#include <campaign/lanes.hpp>
#include <campaign/paper_model.hpp>
#include <outlet/loss_estimator.hpp>

namespace gsbench::campaign {

struct PaperStart {
  int lse_samples = 10;
  gs::outlet::EkfSettings ekf;
  float t_x_s = 0.0f;  // against the first sample
};

struct Estimates {
  float lse_mw[kLanes];
  float ekf_mw[kLanes];
};

// As an outlet does from its event on, the first sample being the event's own.
void estimate_as_outlet(const gs::outlet::Settings& settings, const float* deviations_hz,
                        int samples, Estimates& estimates);
// The same, each lane with parameters of its own.
void estimate_as_outlet(const gs::outlet::Settings& settings,
                        const gs::outlet::ResponseOf<Lanes>& response, const float* deviations_hz,
                        int samples, Estimates& estimates);

// As the paper has it: LSE, and from its result EKF over the samples that follow.
void estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                       const PaperModel<float>& model, const float* deviations_hz, int samples,
                       Estimates& estimates);
void estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                       const PaperModel<Lanes>& model, const float* deviations_hz, int samples,
                       Estimates& estimates);

struct CountedConditions {
  int window = 8;  // samples in a line
  int first = 0;   // sample whose line counts first; its line lies within the samples
  int count = 40;
};

// How often the load-shedding conditions are met. `frequencies_hz` hold first + count samples, of
// which the line of sample k is that of k − window + 1 … k.
void count_conditions(const gs::outlet::Settings& settings, float nominal_hz,
                      const CountedConditions& counted, const float* deviations_hz,
                      float hits[kLanes]);

// One measurement of each, as many reports after the event's own, which is report 0.
void take_report(const gs::outlet::Settings& settings, gs::outlet::LossEstimator<Lanes>& estimator,
                 const float deviation_hz[kLanes], int report);

}  // namespace gsbench::campaign
