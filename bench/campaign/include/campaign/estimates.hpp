// A campaign: many simulated noisy frequency curves (trajectories) after a loss, from each of which
// LSE and EKF estimate the loss (§6.3, Tables 3–5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <campaign/work.hpp>
#include <grid/grid.hpp>
#include <outlet/settings.hpp>

namespace gsbench::campaign {

// kPaper: the paper's equations and procedure, LSE over ten samples and EKF over the next forty.
// kFirmware: the firmware's estimators. The event is given here; a real outlet has to detect it.
// See estimate_settings().
enum class Mode : std::uint8_t { kPaper, kFirmware };
// The paper states only "within ±0.01 Hz", not the distribution.
enum class NoiseDistribution : std::uint8_t { kUniform, kGaussian };
// Instant of the loss. kOnReport: one report interval before the first sample, as in the paper.
// kBetweenReports: uniformly distributed over that interval.
enum class LossInstant : std::uint8_t { kOnReport, kBetweenReports };

constexpr std::uint64_t kMostTrajectories = std::uint64_t{1} << 32;  // the number of noise streams

struct EstimateOptions {
  double loss_mw = 500.0;
  Mode mode = Mode::kFirmware;
  NoiseDistribution distribution = NoiseDistribution::kUniform;
  double noise_hz = 0.01;  // half width if uniform, standard deviation if Gaussian
  LossInstant instant = LossInstant::kOnReport;
  // Largest relative error of each of G_1, G_2, ω_n, ω_r and φ, uniformly distributed (Table 5).
  // The firmware's four parameters (gs::outlet::ResponseOf) are then computed from these five. This
  // is an experiment; a control centre does not send such parameters.
  double parameter_error = 0.0;
  // Initial standard deviations of the paper's EKF; the paper does not state them.
  double paper_loss_sigma_mw = 80.0;     // of ΔP
  double paper_t_x_sigma_s = 0.02;       // of t_x
  std::uint64_t trajectories = 1000000;  // up to kMostTrajectories
  std::uint64_t seed = 1;
};

struct EstimateResult {
  std::uint64_t trajectories = 0;  // computed
  Histogram lse_mw;
  Histogram ekf_mw;
  double bound_mw = 0.0;  // Cramér–Rao bound of σ for ΔP, with t_x unknown, from all samples
};

// As in the shipped firmware and the paper: LSE over the first samples, EKF over the later ones
// and, in the firmware, also over the last gs::outlet::kSharedSamples of the LSE.
constexpr std::size_t kLseSamples = gs::outlet::Settings{}.lse_samples;
constexpr std::size_t kEkfSamples = gs::outlet::Settings{}.ekf_samples;
constexpr std::size_t kSamples = kLseSamples + kEkfSamples;
constexpr double kReport_s = gs::outlet::kReport_ms / 1000.0;

// Blocks until all trajectories are computed or `execution` is stopped. Throws
// std::invalid_argument for options out of range or an invalid grid. Also throws it for an
// overdamped grid in mode kPaper or with a parameter error, because the paper's parameters do not
// exist for it.
//
// `sink` gets the EKF's estimates of trajectories first … first+count−1, on any thread and in any
// order. With a sink this process computes all trajectories and shares none with other processes.
using EstimateSink =
    std::function<void(std::uint64_t first, const float* ekf_mw, std::size_t count)>;
EstimateResult estimate(const grid::Grid& grid, const EstimateOptions& options,
                        const Execution& execution, const EstimateSink& sink = {});

// The kSamples deviations of one of these trajectories, Hz.
std::vector<float> trajectory(const grid::Grid& grid, const EstimateOptions& options,
                              std::uint64_t number);

// The settings for the estimate of a trajectory: as shipped, except for event_drops = 1 and
// event_lag_s = 0 (shipped: 5 and 0.008 s). The event is given: it is the first report after the
// loss, and the frequency before the loss is exact. The initial t_x of the EKF is event_drops
// reports and event_lag_s before the event: 16 ms here, 88 ms as shipped.
gs::outlet::Settings estimate_settings(const grid::Grid& grid);

// Cramér–Rao bound: the lowest σ, in MW, of an unbiased estimate of the loss from samples
// first … last. The noise of each sample has σ = sigma_hz. The instant of the loss is also unknown.
// Samples are 16 ms apart; sample 1 is 16 ms after the loss.
double cramer_rao_mw(const grid::Grid& grid, double loss_mw, int first, int last, double sigma_hz);

}  // namespace gsbench::campaign
