#include "sections.hpp"

namespace gsbench::paper {

using campaign::EstimateOptions;
using campaign::EstimateResult;
using campaign::LossInstant;
using campaign::Mode;
using campaign::NoiseDistribution;

EstimateOptions Study::campaign(Mode mode, double parameter_error) const {
  EstimateOptions all;
  all.loss_mw = kLoss_mw;
  all.mode = mode;
  all.distribution = options.choices.noise_distribution;
  all.noise_hz = kNoise_hz;
  all.instant = options.choices.loss_instant;
  all.parameter_error = parameter_error;
  all.paper_loss_sigma_mw = options.choices.ekf_loss_sigma_mw;
  all.paper_t_x_sigma_s = options.choices.ekf_t_x_sigma_s;
  all.trajectories = options.trajectories;
  all.seed = options.seed;
  return all;
}

const EstimateResult& Study::result(const EstimateOptions& campaign, const Execution& execution) {
  const auto key = std::make_tuple(campaign.mode, campaign.distribution, campaign.instant,
                                   campaign.parameter_error, campaign.paper_loss_sigma_mw,
                                   campaign.paper_t_x_sigma_s);
  const auto found = results.find(key);
  if (found != results.end()) {
    return found->second;
  }
  return results.emplace(key, estimate(grid, campaign, execution)).first->second;
}

std::string name_of(Mode mode, double parameter_error) {
  return mode == Mode::kPaper ? kPaperWay : parameter_error > 0.0 ? kReconciled : kFirmware;
}

std::string text_of(NoiseDistribution distribution) {
  return distribution == NoiseDistribution::kUniform ? "uniform ±0.01 Hz" : "Gaussian σ = 0.01 Hz";
}

std::string text_of(LossInstant instant) {
  return instant == LossInstant::kOnReport ? "loss on a report" : "loss between reports";
}

std::string text_of(const campaign::Counting& counting) {
  return "slope over " + std::to_string(counting.window) + ", from sample " +
         std::to_string(counting.first) + " on, " + std::to_string(counting.count) +
         " lines, more than " + std::to_string(counting.more_than) + " hits";
}

Execution nth_of(const Execution& execution, int n, int all) {
  Execution part = execution;
  if (execution.progress) {
    part.progress = [progress = execution.progress, n, all](double done) {
      progress((n + done) / all);
    };
  }
  return part;
}

}  // namespace gsbench::paper
