// The campaigns of §6.3.
#include "sections.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <campaign/estimates.hpp>
#include <outlet/loss_estimator.hpp>

namespace gsbench::paper {
namespace {

using campaign::EstimateOptions;
using campaign::EstimateResult;
using campaign::Histogram;
using campaign::LossInstant;
using campaign::Mode;
using campaign::NoiseDistribution;
using record::FigureTable;
using record::kNoFigure;

constexpr int kMostDecimals_pu = 4;  // 0.01 MW

struct PrintedRange {
  double from_pu;
  double to_pu;
  double percent;
};

double within_pct(const Histogram& estimates, double percent) {
  const double span = kLoss_mw * 0.01 * percent;
  return 100.0 * estimates.share_between(kLoss_mw - span, kLoss_mw + span);
}

// The shares of the estimates in the ranges that the paper prints.
FigureTable ranges(const std::vector<PrintedRange>& printed, const std::string& first_name,
                   const Histogram& first, const std::string& second_name,
                   const Histogram& second) {
  FigureTable table = {
      "Share of the estimates, %", "range, p.u.", {{"paper", 4}, {first_name}, {second_name}}, {}};
  for (const PrintedRange& range : printed) {
    const double from_mw = kPu_mw * range.from_pu;
    const double to_mw = kPu_mw * range.to_pu;
    table.rows.push_back({fmt::format("{:.1f} … {:.1f}", range.from_pu, range.to_pu),
                          {range.percent, 100.0 * first.share_between(from_mw, to_mw),
                           100.0 * second.share_between(from_mw, to_mw)}});
  }
  const auto number = [](const Histogram& estimates) {
    return static_cast<std::uint64_t>(estimates.count() + estimates.missing());
  };
  set_share_decimals(table, 1, 100.0, number(first));
  set_share_decimals(table, 2, 100.0, number(second));
  return table;
}

// The shares in steps of step_mw.
record::CurvePlot plot_of(const std::string& caption, double from_mw, double to_mw, double step_mw,
                          const std::vector<std::pair<std::string, Histogram>>& of) {
  record::CurvePlot plot = {caption, "MW", "share per step, %"};
  plot.steps = true;
  const auto steps = std::lround((to_mw - from_mw) / step_mw);
  for (long step = 0; step <= steps; ++step) {
    plot.x.push_back(from_mw + step_mw * static_cast<double>(step));
  }
  for (const auto& [name, estimates] : of) {
    record::Curve curve{name, {}};
    for (const double mw : plot.x) {
      curve.y.push_back(100.0 * estimates.share_between(mw, mw + step_mw));
    }
    plot.curves.push_back(curve);
  }
  return plot;
}

record::FigureRow figures_row(const std::string& name, const EstimateResult& result) {
  const Histogram& ekf = result.ekf_mw;
  return {name,
          {within_pct(ekf, 4.0), 100.0 - within_pct(ekf, 10.0), ekf.mean() / kPu_mw,
           ekf.standard_deviation() / kPu_mw, ekf.standard_deviation() / result.bound_mw,
           std::max(std::fabs(ekf.smallest() - kLoss_mw), std::fabs(ekf.largest() - kLoss_mw)) /
               kLoss_mw * 100.0}};
}

enum : std::size_t { kWithin4, kBeyond10, kMean, kSigma, kSigmaByBound };

// A table with the decimals that the number of trajectories supports.
FigureTable figures_table(const std::string& caption, std::vector<record::FigureRow> rows,
                          std::uint64_t trajectories) {
  FigureTable table = {caption,
                       "",
                       {{"within 4 %, %"},
                        {"beyond 10 %, %"},
                        {"mean, p.u."},
                        {"σ, p.u."},
                        {"σ/bound"},
                        {"largest error, %", 1}},
                       std::move(rows)};
  set_share_decimals(table, kWithin4, 100.0, trajectories);
  set_share_decimals(table, kBeyond10, 100.0, trajectories);
  double sigma_pu = 0.0;
  double sigma_by_bound = 0.0;
  for (const record::FigureRow& row : table.rows) {
    sigma_pu = std::fmax(sigma_pu, row.figures[kSigma]);
    sigma_by_bound = std::fmax(sigma_by_bound, row.figures[kSigmaByBound]);
  }
  const auto n = static_cast<double>(trajectories);
  table.columns[kMean].decimals = decimals_of(sigma_pu / std::sqrt(n), kMostDecimals_pu);
  table.columns[kSigma].decimals = decimals_of(sigma_pu / std::sqrt(2.0 * n), kMostDecimals_pu);
  table.columns[kSigmaByBound].decimals = decimals_of(sigma_by_bound / std::sqrt(2.0 * n), 3);
  return table;
}

// How much the result depends on the choices that the paper leaves open.
FigureTable over_choices(Study& study, const Execution& execution, double parameter_error) {
  std::vector<record::FigureRow> rows;
  int n = 0;
  for (const Mode mode : {Mode::kPaper, Mode::kFirmware}) {
    const char* const name = mode == Mode::kPaper    ? kPaperMethod
                             : parameter_error > 0.0 ? "experiment"
                                                     : "firmware";
    for (const NoiseDistribution distribution :
         {NoiseDistribution::kUniform, NoiseDistribution::kGaussian}) {
      for (const LossInstant instant : {LossInstant::kOnReport, LossInstant::kBetweenReports}) {
        EstimateOptions choice = study.campaign(mode, parameter_error);
        choice.distribution = distribution;
        choice.instant = instant;
        const EstimateResult& result = study.result(choice, nth_of(execution, n++, 9));
        rows.push_back(figures_row(
            fmt::format("{}, {}, {}", name, name_of(distribution), text_of(instant)), result));
      }
    }
  }
  EstimateOptions wide_start = study.campaign(Mode::kPaper, parameter_error);
  wide_start.paper_loss_sigma_mw = 0.3 * study.grid.base_mw;
  wide_start.paper_t_x_sigma_s = 0.05;
  const EstimateResult& result = study.result(wide_start, nth_of(execution, n, 9));
  rows.push_back(figures_row(
      fmt::format("{}, EKF start σ {:g} MW and {:g} ms", kPaperMethod,
                  wide_start.paper_loss_sigma_mw, 1000.0 * wide_start.paper_t_x_sigma_s),
      result));
  return figures_table(
      "The same for each choice that the paper leaves open: uniform ±0.01 Hz or Gaussian σ = 0.01 "
      "Hz "
      "noise, loss on a report or between reports",
      std::move(rows), study.options.trajectories);
}

}  // namespace

PageSection table3(Study& study, const Execution& execution) {
  EstimateOptions choice = study.campaign(Mode::kPaper);
  choice.distribution = NoiseDistribution::kUniform;
  const EstimateResult& uniform = study.result(choice, nth_of(execution, 0, 2));
  choice.distribution = NoiseDistribution::kGaussian;
  const EstimateResult& gaussian = study.result(choice, nth_of(execution, 1, 2));
  FigureTable table = ranges({{7, 8, 0.1424},
                              {6, 7, 8.3166},
                              {5, 6, 36.9292},
                              {4, 5, 41.6360},
                              {3, 4, 12.5295},
                              {2, 3, 0.4463}},
                             text_of(NoiseDistribution::kUniform), uniform.lse_mw,
                             text_of(NoiseDistribution::kGaussian), gaussian.lse_mw);
  const int decimals = decimals_of(gaussian.lse_mw.standard_deviation() / kPu_mw /
                                       std::sqrt(static_cast<double>(gaussian.trajectories)),
                                   kMostDecimals_pu);
  const FigureTable figures = {
      "LSE over ten measurements",
      "",
      table.columns,
      {{"mean, p.u.",
        {kNoFigure, uniform.lse_mw.mean() / kPu_mw, gaussian.lse_mw.mean() / kPu_mw},
        decimals},
       {"σ, p.u.",
        {kNoFigure, uniform.lse_mw.standard_deviation() / kPu_mw,
         gaussian.lse_mw.standard_deviation() / kPu_mw},
        decimals}}};
  const record::CurvePlot plot =
      plot_of("Estimates of 500 MW by LSE.", 200.0, 800.0, 5.0,
              {{"uniform", uniform.lse_mw}, {"Gaussian", gaussian.lse_mw}});
  return {
      {table, figures},
      {plot},
      {"Paper's method and firmware have the same LSE. The paper's table has a standard "
       "deviation of about 0.80 p.u. and a mean of 4.91 p.u.; none of the readings of \"a random "
       "noise within ±0.01 Hz\" that were tried gives exactly this table. The mean of LSE is "
       "below 5 p.u. because eq. (18) needs the slope at the instant of the loss and LSE "
       "measures that of the first 160 ms."}};
}

PageSection fig16(Study& study, const Execution& /*execution*/) {
  const grid::Grid& grid = study.grid;
  record::CurvePlot plot = {"Estimates of 500 MW after each measurement, in three trajectories.",
                            "s after the loss", "MW"};
  const gs::outlet::Settings settings = campaign::estimate_settings(grid);
  for (std::size_t k = 1; k <= campaign::kSamples; ++k) {
    plot.x.push_back(campaign::kReport_s * static_cast<double>(k));
  }
  for (std::uint64_t number = 0; number < 3; ++number) {
    gs::outlet::LossEstimator<float> outlet;
    record::Curve curve{"trajectory " + std::to_string(number), {}};
    const auto deviations_hz = campaign::trajectory(grid, study.campaign(Mode::kFirmware), number);
    for (std::size_t k = 0; k < deviations_hz.size(); ++k) {
      take(settings, settings.response, outlet, deviations_hz[k], static_cast<int>(k));
      curve.y.push_back(outlet.started ? static_cast<double>(outlet.ekf.loss_mw) : kNoFigure);
    }
    plot.curves.push_back(curve);
  }
  return {{}, {plot}, {}};
}

PageSection table4(Study& study, const Execution& execution) {
  const FigureTable choices = over_choices(study, execution, 0.0);
  const EstimateResult& paper_method = study.result(study.campaign(Mode::kPaper), quiet(execution));
  const EstimateResult& firmware = study.result(study.campaign(Mode::kFirmware), quiet(execution));
  const FigureTable table = figures_table(
      "EKF over forty measurements after LSE over ten, " +
          text_of(study.options.choices.noise_distribution),
      {{"paper", {92.38, kNoFigure, kNoFigure, kNoFigure, kNoFigure, kNoFigure}},
       figures_row(kPaperMethod, paper_method),
       figures_row(kFirmware, firmware),
       {"Cramér–Rao bound, instant unknown",
        {kNoFigure, kNoFigure, kNoFigure, firmware.bound_mw / kPu_mw, 1.0, kNoFigure}}},
      study.options.trajectories);
  const FigureTable shares = ranges({{5.2, 5.4, 3.6692},
                                     {5.0, 5.2, 50.3811},
                                     {4.8, 5.0, 41.9954},
                                     {4.6, 4.8, 3.9086},
                                     {4.4, 4.6, 0.0457}},
                                    kPaperMethod, paper_method.ekf_mw, kFirmware, firmware.ekf_mw);
  const record::CurvePlot plot =
      plot_of("Estimates of 500 MW by EKF.", 460.0, 540.0, 0.5,
              {{kPaperMethod, paper_method.ekf_mw}, {kFirmware, firmware.ekf_mw}});
  return {{shares, table, choices},
          {plot},
          {"The innovation is that of the full model, f − h(X); eq. (28) as printed has its "
           "linearisation.",
           "The firmware's event is given: it is the first report after the loss, and the "
           "frequency before the loss is exact. A shipped outlet detects the event about 120 ms "
           "later and measures that frequency: Fig. 19 and `gsbench study` show its estimates, "
           "starting from the sampled voltage.",
           "The bound is that of all fifty measurements without knowledge of the instant. The "
           "firmware may pass it: its EKF also gets the last four of LSE's measurements and a "
           "standard deviation of the instant."}};
}

PageSection table5(Study& study, const Execution& execution) {
  constexpr double kError = 0.05;
  const FigureTable choices = over_choices(study, execution, kError);
  const EstimateResult& paper_method =
      study.result(study.campaign(Mode::kPaper, kError), quiet(execution));
  const EstimateResult& firmware =
      study.result(study.campaign(Mode::kFirmware, kError), quiet(execution));
  const FigureTable table =
      figures_table("EKF with an error of up to 5 % in each parameter, " +
                        text_of(study.options.choices.noise_distribution),
                    {{"paper", {72.33, kNoFigure, kNoFigure, kNoFigure, kNoFigure, kNoFigure}},
                     figures_row(kPaperMethod, paper_method),
                     figures_row(kReconciled, firmware)},
                    study.options.trajectories);
  const FigureTable shares =
      ranges({{5.6, 6.0, 0.0364},
              {5.4, 5.6, 1.4662},
              {5.2, 5.4, 13.5019},
              {5.0, 5.2, 37.6247},
              {4.8, 5.0, 35.7036},
              {4.6, 4.8, 10.7807},
              {4.4, 4.6, 0.8698},
              {4.0, 4.4, 0.0167}},
             kPaperMethod, paper_method.ekf_mw, kReconciled, firmware.ekf_mw);
  return {
      {shares, table, choices},
      {},
      {"G_1, G_2, ω_n, ω_r and φ have independent relative errors, uniform within ±5 %. The "
       "paper's method uses the five as they are, although they then contradict one another.",
       "The experiment is not part of any product. The firmware's four parameters cannot "
       "contradict one another. Here they are computed from the five erroneous ones: K from G_1, "
       "G_2 and φ; ζ·ω_n and ω_r² from ω_n and ω_r; ω_n²·T_R from all five. The relations "
       "G_2·sin φ = −G_1 and ω_r = ω_n·√(1 − ζ²) average some of the errors, and the bias of a "
       "mean of reciprocals is corrected. A control centre does not do that: it sends the "
       "parameters that follow from the grid's file.",
       "The bound is that for exact parameters."}};
}

}  // namespace gsbench::paper
