#include "sections.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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
  return mode == Mode::kPaper ? kPaperMethod : parameter_error > 0.0 ? kReconciled : kFirmware;
}

std::string name_of(NoiseDistribution distribution) {
  return distribution == NoiseDistribution::kUniform ? "uniform" : "Gaussian";
}

std::string text_of(NoiseDistribution distribution) {
  return distribution == NoiseDistribution::kUniform ? "uniform ±0.01 Hz" : "Gaussian σ = 0.01 Hz";
}

std::string text_of(LossInstant instant) {
  return instant == LossInstant::kOnReport ? "on a report" : "between reports";
}

std::string text_of(const campaign::Counting& counting) {
  return fmt::format("slope over {} samples, {} slopes from sample {}, > {} hits", counting.window,
                     counting.count, counting.first, counting.more_than);
}

int decimals_of(double standard_error, int most) {
  if (!(standard_error > 0.0)) {
    return most;
  }
  return std::clamp(-static_cast<int>(std::floor(std::log10(standard_error))), 0, most);
}

void set_share_decimals(record::FigureTable& table, std::size_t column, double whole,
                        std::uint64_t trajectories) {
  constexpr int kMost = 6;
  const auto n = static_cast<double>(trajectories);
  double largest = 1.0 / n;
  for (const record::FigureRow& row : table.rows) {
    const double share = row.figures[column] / whole;
    largest = std::fmax(largest, std::sqrt(share * (1.0 - share) / n));
  }
  table.columns[column].decimals = decimals_of(whole * largest, kMost);
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
