// Many losses of power, each measured with noise and estimated by LSE and EKF (§6.3, Tables 3–5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <campaign/work.hpp>
#include <grid/grid.hpp>
#include <outlet/settings.hpp>

namespace gsbench::campaign {

// kPaper: the paper's equations and its course of things, LSE over ten samples and EKF over the
// forty that follow. kFirmware: the firmware's estimators at a known event, which an outlet has yet
// to detect: see estimate_settings().
enum class Mode : std::uint8_t { kPaper, kFirmware };
// "Within ±0.01 Hz" leaves it open.
enum class NoiseDistribution : std::uint8_t { kUniform, kGaussian };
// When the loss is: a whole report before the first sample, as in the paper, or anywhere in it.
enum class LossInstant : std::uint8_t { kOnReport, kBetweenReports };

constexpr std::uint64_t kMostTrajectories = std::uint64_t{1} << 32;  // streams are so many

struct EstimateOptions {
  double loss_mw = 500.0;
  Mode mode = Mode::kFirmware;
  NoiseDistribution distribution = NoiseDistribution::kUniform;
  double noise_hz = 0.01;  // half width, or standard deviation
  LossInstant instant = LossInstant::kOnReport;
  // Each of G_1, G_2, ω_n, ω_r and ∅ is off by up to so much of itself, uniformly (Table 5). The
  // firmware's four parameters are then reconciled from these five: an experiment, since no control
  // centre does that.
  double parameter_error = 0.0;
  // Where the paper's EKF starts, which it does not tell: standard deviations of LSE and t_x.
  double paper_loss_sigma_mw = 80.0;
  double paper_t_x_sigma_s = 0.02;
  std::uint64_t trajectories = 1000000;  // up to kMostTrajectories
  std::uint64_t seed = 1;
};

struct EstimateResult {
  std::uint64_t trajectories = 0;  // done
  Histogram lse_mw;
  Histogram ekf_mw;
  double bound_mw = 0.0;  // Cramér–Rao, of ΔP with t_x unknown, over all samples
};

// As outlets ship, and as in the paper: LSE takes the first samples, EKF the others.
constexpr std::size_t kLseSamples = gs::outlet::Settings{}.lse_samples;
constexpr std::size_t kEkfSamples = gs::outlet::Settings{}.ekf_samples;
constexpr std::size_t kSamples = kLseSamples + kEkfSamples;
constexpr double kReport_s = gs::outlet::kReport_ms / 1000.0;

// Throws std::invalid_argument for options or a grid that make no sense, or an overdamped grid
// where the paper's parameters, which it has none of, are asked for.
//
// `sink`, where there is one, is given the EKF's estimates of trajectories first … first+count−1,
// from any thread and in any order. All of them: with a sink this process shares none out.
using EstimateSink =
    std::function<void(std::uint64_t first, const float* ekf_mw, std::size_t count)>;
EstimateResult estimate(const grid::Grid& grid, const EstimateOptions& options,
                        const Execution& execution, const EstimateSink& sink = {});

// One trajectory of those, for whoever wants to follow it: kSamples deviations.
std::vector<float> trajectory(const grid::Grid& grid, const EstimateOptions& options,
                              std::uint64_t number);

// The settings with which a trajectory is estimated: as shipped, but for an event that is known.
// Its report is the first after the loss and the frequency before it is exact, where outlets ship
// with five drops to detect one by, start the EKF 8 ms before these, and measure the frequency
// before.
gs::outlet::Settings estimate_settings(const grid::Grid& grid);

// σ of the best unbiased estimate of a loss from samples first … last, 16 ms apart and the first of
// them 16 ms after the loss, each with that σ; the instant is unknown as well.
double cramer_rao_mw(const grid::Grid& grid, double loss_mw, int first, int last, double sigma_hz);

}  // namespace gsbench::campaign
