#include "batches.hpp"
#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <campaign/estimates.hpp>
#include <campaign/kernel.hpp>
#include <grid/sfr_model.hpp>
#include <models/noise.hpp>
#include <outlet/front_end.hpp>

namespace gsbench::campaign {
namespace {

// A loss between reports has one of that many equidistant instants, batch by batch.
constexpr std::size_t kInstants = 64;

enum : std::size_t { kLse, kEkf };

void check(const EstimateOptions& options) {
  demand(options.loss_mw > 0.0 && std::isfinite(options.loss_mw),
         fmt::format("a loss of {:g} MW is not above 0", options.loss_mw));
  demand(options.noise_hz >= 0.0 && options.noise_hz <= 1.0,
         fmt::format("a noise of {:g} Hz is not within 0 … 1 Hz", options.noise_hz));
  demand(options.parameter_error >= 0.0 && options.parameter_error <= 0.5,
         fmt::format("a parameter error of {:g} is not within 0 … 0.5", options.parameter_error));
  demand(options.paper_loss_sigma_mw > 0.0 && options.paper_loss_sigma_mw <= 1.0e5,
         fmt::format("the start of the paper's EKF: a standard deviation of LSE of {:g} MW is not "
                     "above 0 and at most 100000 MW",
                     options.paper_loss_sigma_mw));
  demand(
      options.paper_t_x_sigma_s > 0.0 && options.paper_t_x_sigma_s <= 0.5,
      fmt::format("the start of the paper's EKF: a standard deviation of the instant of {:g} s is "
                  "not above 0 and at most 0.5 s",
                  options.paper_t_x_sigma_s));
  demand(options.trajectories > 0 && options.trajectories <= kMostTrajectories,
         fmt::format("{} trajectories are not within 1 … 2^32", options.trajectories));
}

// The frequency's deviation at each sample, for each instant of the loss.
class CleanSignal {
 public:
  CleanSignal(const grid::SfrModel& model, const EstimateOptions& options)
      : instants_(options.instant == LossInstant::kOnReport ? 1 : kInstants) {
    for (std::size_t instant = 0; instant < instants_; ++instant) {
      const double early =
          instants_ == 1 ? 0.0
                         : (static_cast<double>(instant) + 0.5) / static_cast<double>(instants_);
      for (std::size_t k = 1; k <= kSamples; ++k) {
        deviations_hz_.push_back(static_cast<float>(
            options.loss_mw *
            model.unit_deviation_hz(kReport_s * (static_cast<double>(k) - early))));
      }
    }
  }

  const float* of_batch(std::uint64_t batch) const {
    return deviations_hz_.data() + batch % instants_ * kSamples;
  }

 private:
  std::size_t instants_;
  std::vector<float> deviations_hz_;
};

// The relative errors of G_1, G_2, ω_n, ω_r and φ.
using Errors = std::array<Lanes, 5>;

Errors make_errors(const EstimateOptions& options, std::uint64_t batch) {
  float values[5 * kLanes] = {};
  models::add_uniform_to_each(
      {options.seed, models::kTrajectoryParameters, static_cast<std::uint32_t>(batch * kLanes)},
      kLanes, 5, static_cast<float>(options.parameter_error), values);
  Errors errors;
  for (std::size_t i = 0; i < 5; ++i) {
    errors[i] = load(values + i * kLanes);
  }
  return errors;
}

template <class Parameter>
Parameter with_error(float value, const Parameter& error) {
  return (error + 1.0F) * value;
}

// The estimators of a campaign, with the parameters common to all batches.
class Estimators {
 public:
  Estimators(const grid::Grid& grid, const grid::SfrModel& model, const EstimateOptions& options,
             const CleanSignal& clean)
      : options_(options), settings_(estimate_settings(grid)) {
    if (const auto parameters = grid::underdamped_parameters(model, grid.reheat_s)) {
      paper_.gain_hz_per_mw = static_cast<float>(model.gain_hz_per_mw());
      paper_.alpha = static_cast<float>(parameters->alpha);
      paper_.sigma_per_s = static_cast<float>(model.sigma_per_s());
      paper_.omega_r = static_cast<float>(parameters->omega_r);
      paper_.phi = static_cast<float>(parameters->phi);
    } else if (options.mode == Mode::kPaper || options.parameter_error > 0.0) {
      throw std::invalid_argument("grid " + grid.name +
                                  " is overdamped: the paper's parameters do not exist for it");
    }
    start_.ekf.measurement_sigma_hz = static_cast<float>(std::max(noise_sigma_hz(options), 1e-4));
    start_.ekf.loss_sigma_mw = static_cast<float>(options.paper_loss_sigma_mw);
    start_.ekf.t_x_sigma_s = static_cast<float>(options.paper_t_x_sigma_s);
    start_.ekf.largest_loss_mw = settings_.largest_loss_mw;
    start_.t_x_s = -gs::outlet::kReport_s;
    if (options.mode == Mode::kFirmware && options.parameter_error > 0.0) {
      excess_ = reciprocal_excess(clean);
    }
  }

  static double noise_sigma_hz(const EstimateOptions& options) {
    return options.distribution == NoiseDistribution::kUniform ? options.noise_hz / std::sqrt(3.0)
                                                               : options.noise_hz;
  }

  Estimates estimate(std::uint64_t batch, const float* deviations_hz) const {
    const bool exact = options_.parameter_error == 0.0;
    if (options_.mode == Mode::kFirmware) {
      return exact ? estimate_as_outlet(settings_, settings_.response, deviations_hz)
                   : estimate_as_outlet(settings_, response_with(make_errors(options_, batch)),
                                        deviations_hz);
    }
    const float k_lse = gs::outlet::k_lse_mw_per_hz_s(settings_.response);
    return exact ? estimate_as_paper(start_, k_lse, paper_, deviations_hz)
                 : estimate_as_paper(start_, k_lse, paper_with(make_errors(options_, batch)),
                                     deviations_hz);
  }

 private:
  PaperModel<Lanes> paper_with(const Errors& e) const {
    return {with_error(paper_.gain_hz_per_mw, e[0]),
            // alpha = G_2/G_1 has the errors of both.
            with_error(paper_.alpha, e[1]) * (1.0F / (e[0] + 1.0F)),
            with_error(paper_.sigma_per_s, e[2]), with_error(paper_.omega_r, e[3]),
            with_error(paper_.phi, e[4])};
  }

  // An experiment; a control centre does not send this. With independent errors the five parameters
  // contradict two relations: f starts at f_0, so that G_2·sin φ = −G_1, and ω_r = ω_n·√(1 − ζ²).
  // The four parameters of an outlet cannot. Here they are computed from G_1, G_2 and ω_n, each of
  // which follows from the five in two ways: the mean of both is used, weighted if their errors
  // differ.
  gs::outlet::ResponseOf<Lanes> response_with(const Errors& e) const {
    constexpr float kOwn = 0.66F;  // the other follows from φ, too, and has twice the variance
    constexpr float kOther = 1.0F - kOwn;
    const Lanes phi = with_error(paper_.phi, e[4]);
    const Lanes sine = gs::outlet::sine(phi);
    const Lanes g_1 = with_error(paper_.gain_hz_per_mw, e[0]);
    const Lanes g_2 = with_error(paper_.gain_hz_per_mw * paper_.alpha, e[1]);
    const Lanes gain = g_1 * kOwn - g_2 * sine * kOther;
    const Lanes oscillation = g_2 * kOwn - g_1 / sine * kOther;
    const Lanes pace = (e[2] + e[3]) * 0.5F + 1.0F;  // the mean of both ω
    const Lanes omega_r = pace * paper_.omega_r;
    gs::outlet::ResponseOf<Lanes> response;
    response.gain_hz_per_mw = gain * (1.0F + excess_);
    response.sigma_per_s = pace * paper_.sigma_per_s;
    response.discriminant_per_s2 = omega_r * omega_r;
    response.initial_slope_per_s =
        response.sigma_per_s + omega_r * oscillation / gain * gs::outlet::cosine(phi);
    return response;
  }

  // An estimate divides by the response, and the mean of a reciprocal is above the reciprocal of
  // the mean by the relative variance. Returns that variance for the given parameter error, to
  // first order: the sum of the squares of each error's effect, by 3 for a uniform distribution.
  float reciprocal_excess(const CleanSignal& clean) const {
    float alone[5][kLanes] = {};
    Errors errors;
    for (std::size_t i = 0; i < 5; ++i) {
      alone[i][i] = static_cast<float>(options_.parameter_error);
      errors[i] = load(alone[i]);
    }
    float deviations_hz[kSamples * kLanes];
    spread(clean.of_batch(0), kSamples, deviations_hz);
    const Estimates estimates = estimate_as_outlet(settings_, response_with(errors), deviations_hz);
    const float exact_mw = estimates.ekf_mw[5];  // a lane without an error
    float squares = 0.0F;
    for (std::size_t i = 0; i < 5; ++i) {
      const float part = estimates.ekf_mw[i] / exact_mw - 1.0F;
      squares += part * part;
    }
    return squares / 3.0F;
  }

  const EstimateOptions& options_;
  float excess_ = 0.0F;
  gs::outlet::Settings settings_;
  PaperModel<float> paper_;
  PaperStart start_;
};

Histogram histogram_of(double loss_mw) {
  return {0.0, 2.0 * loss_mw, 20000};
}

}  // namespace

gs::outlet::Settings estimate_settings(const grid::Grid& grid) {
  gs::outlet::Settings settings = control_centre::grid_settings(grid);
  settings.event_drops = 1;
  settings.event_lag_s = 0.0F;
  return settings;
}

EstimateResult estimate(const grid::Grid& grid, const EstimateOptions& options,
                        const Execution& execution, const EstimateSink& sink) {
  check(options);
  const grid::SfrModel model(grid);
  const CleanSignal clean(model, options);
  const Estimators estimators(grid, model, options, clean);
  Histograms histograms = {histogram_of(options.loss_mw), histogram_of(options.loss_mw)};
  const auto each = [&](const float* deviations_hz, std::uint64_t first, std::uint64_t count,
                        Histograms& own) {
    const Estimates estimates = estimators.estimate(first / kLanes, deviations_hz);
    for (std::uint64_t i = 0; i < count; ++i) {
      own[kLse].add(static_cast<double>(estimates.lse_mw[i]));
      own[kEkf].add(static_cast<double>(estimates.ekf_mw[i]));
    }
    if (sink) {
      sink(first, estimates.ekf_mw, count);
    }
  };
  Execution own = execution;
  if (sink) {
    own.reduction = &kOneProcess;
  }
  run_batches(
      options, kSamples, [&](std::uint64_t batch) { return clean.of_batch(batch); }, each, own,
      histograms);
  const std::int64_t done = histograms[kEkf].count() + histograms[kEkf].missing();
  return {static_cast<std::uint64_t>(done), histograms[kLse], histograms[kEkf],
          cramer_rao_mw(grid, options.loss_mw, 1, kSamples, Estimators::noise_sigma_hz(options))};
}

std::vector<float> trajectory(const grid::Grid& grid, const EstimateOptions& options,
                              std::uint64_t number) {
  check(options);
  const CleanSignal clean(grid::SfrModel(grid), options);
  float deviations_hz[kSamples * kLanes];
  measure(options, clean.of_batch(number / kLanes), kSamples, number - number % kLanes,
          deviations_hz);
  std::vector<float> one;
  for (std::size_t k = 0; k < kSamples; ++k) {
    one.push_back(deviations_hz[k * kLanes + number % kLanes]);
  }
  return one;
}

double cramer_rao_mw(const grid::Grid& grid, double loss_mw, int first, int last, double sigma_hz) {
  const grid::SfrModel model(grid);
  // Fisher's information about (ΔP, t_x): ∂f/∂ΔP and ∂f/∂t_x = −∂f/∂t.
  double ll = 0.0;
  double lt = 0.0;
  double tt = 0.0;
  for (int k = first; k <= last; ++k) {
    const double t_s = kReport_s * static_cast<double>(k);
    const double by_loss = model.unit_deviation_hz(t_s);
    const double by_instant = -loss_mw * model.unit_rocof_hz_s(t_s);
    ll += by_loss * by_loss;
    lt += by_loss * by_instant;
    tt += by_instant * by_instant;
  }
  return sigma_hz * std::sqrt(tt / (ll * tt - lt * lt));
}

}  // namespace gsbench::campaign
