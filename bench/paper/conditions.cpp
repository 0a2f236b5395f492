// Load-shedding conditions under noise, §6.2.
#include "sections.hpp"
#include <control_centre/threshold.hpp>

#include <fmt/format.h>

#include <grid/sfr_model.hpp>

namespace gsbench::paper {
namespace {

using campaign::ConditionOptions;
using campaign::Counting;
using campaign::NoiseDistribution;
using record::FigureTable;

struct Cell {
  double loss_mw;
  double noise_hz;
  double printed;
};
constexpr Cell kCells[] = {{380.0, 0.0, 1.0}, {380.0, 0.005, 0.999992}, {380.0, 0.01, 0.978264},
                           {320.0, 0.0, 0.0}, {320.0, 0.005, 0.001029}, {320.0, 0.01, 0.117682}};

double probability(Study& study, const Cell& cell, const Counting& counting,
                   NoiseDistribution distribution, const Execution& execution) {
  ConditionOptions choice;
  choice.loss_mw = cell.loss_mw;
  choice.noise_hz = cell.noise_hz;
  choice.counting = counting;
  choice.distribution = distribution;
  choice.trajectories = study.options.trajectories;
  choice.seed = study.options.seed;
  return count_conditions(study.grid, choice, execution).probability();
}

// The cells with the most noise, for each way to count.
FigureTable over_choices(Study& study, const Execution& execution) {
  FigureTable table = {
      "The same probability for ±0.01 Hz (or σ = 0.01 Hz), for each choice that the paper leaves "
      "open",
      "how ROCOF and hits are counted",
      {{"380 MW, uniform"}, {"320 MW, uniform"}, {"380 MW, Gaussian"}, {"320 MW, Gaussian"}},
      {}};
  const Counting countings[] = {{8, 0, 38, 15},  {10, 0, 36, 15},  {8, 10, 40, 15},
                                {8, 10, 40, 20}, {16, 10, 40, 20}, {24, 10, 40, 20}};
  int n = 0;
  for (const Counting& counting : countings) {
    record::FigureRow row = {text_of(counting), {}};
    for (const NoiseDistribution distribution :
         {NoiseDistribution::kUniform, NoiseDistribution::kGaussian}) {
      for (const Cell& cell : {kCells[2], kCells[5]}) {
        row.figures.push_back(
            probability(study, cell, counting, distribution,
                        nth_of(execution, n++, 4 * static_cast<int>(std::size(countings)))));
      }
    }
    table.rows.push_back(row);
  }
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    set_share_decimals(table, column, 1.0, study.options.trajectories);
  }
  return table;
}

}  // namespace

PageSection table2(Study& study, const Execution& execution) {
  const Choices& choices = study.options.choices;
  const Counting shipped = campaign::shipped_counting(study.grid);
  FigureTable table = {"Probability of deciding that load shedding is needed",
                       "loss, noise",
                       {{"paper", 6}, {kPaperMethod}, {kFirmware}},
                       {}};
  const char* const sign = choices.noise_distribution == NoiseDistribution::kUniform ? "±" : "σ = ";
  const Execution half = nth_of(execution, 0, 2);
  int n = 0;
  for (const Cell& cell : kCells) {
    record::FigureRow row = {fmt::format("{:g} MW, {}{:g} Hz", cell.loss_mw, sign, cell.noise_hz),
                             {cell.printed}};
    for (const Counting& counting : {choices.counting, shipped}) {
      row.figures.push_back(
          probability(study, cell, counting, choices.noise_distribution, nth_of(half, n++, 12)));
    }
    table.rows.push_back(row);
  }
  set_share_decimals(table, 1, 1.0, study.options.trajectories);
  set_share_decimals(table, 2, 1.0, study.options.trajectories);
  const double threshold_mw =
      control_centre::threshold_mw(grid::SfrModel(study.grid), study.grid.threshold_hz);
  return {
      {table, over_choices(study, nth_of(execution, 1, 2))},
      {},
      {fmt::format("Above the threshold loss of {:.1f} MW the probability should be 1, below it 0. "
                   "The firmware column uses the shipped setting for all six cells: it compares "
                   "the slope over eight measurements with the condition for their mean, over "
                   "the forty reports of the EKF, and needs more than 20 hits. Its event is the "
                   "first report after the loss; an outlet detects the event about 120 ms later.",
                   threshold_mw)}};
}

}  // namespace gsbench::paper
