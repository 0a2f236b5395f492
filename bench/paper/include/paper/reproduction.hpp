// Reproduces the tables and figures of the paper's §6. The computed values are printed beside the
// paper's values.
#pragma once

#include <control_centre/blocks.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <campaign/conditions.hpp>
#include <campaign/estimates.hpp>
#include <campaign/work.hpp>
#include <grid/grid.hpp>
#include <record/page.hpp>
#include <record/run_record.hpp>

namespace gsbench::paper {

struct Item {
  std::string id;     // "table4"
  std::string title;  // includes the number of the paper's section
};

// In the paper's order.
std::vector<Item> items();

// Choices that the paper leaves open, with the defaults used here. The tables show how much the
// result depends on each.
struct Choices {
  campaign::NoiseDistribution noise_distribution =
      campaign::NoiseDistribution::kUniform;  // "a noise within ±0.01 Hz"
  campaign::LossInstant loss_instant = campaign::LossInstant::kOnReport;
  // For Table 2: each slope is over ten samples; 36 slopes are counted, from the first sample on
  // (read from the paper's figures); more than 15 hits are required.
  campaign::Counting counting = {10, 0, 36, 15};
  // Initial standard deviations of the paper's EKF: of ΔP and of t_x.
  double ekf_loss_sigma_mw = 80.0;
  double ekf_t_x_sigma_s = 0.02;
};

struct Options {
  std::vector<std::string> only;         // ids of sections; empty: all
  std::uint64_t trajectories = 1000000;  // simulated noisy frequency curves, for each table
  std::uint64_t seed = 1;
  Choices choices;
  // How P^A is computed for the firmware's fleets. The paper's method always uses eq. (11).
  control_centre::Accumulation accumulation = control_centre::Accumulation::kHalfGroup;
  // Runs the 500 MW experiment for Fig. 19, starting from voltage samples. Empty: the experiment
  // is not run.
  std::function<record::RunRecord(const campaign::Execution&)> run_experiment;
};

// Computes the chosen sections. Blocks until they are done or `execution` is stopped. After a stop,
// the page has the sections done so far and a fact "stopped". Throws std::invalid_argument for an
// unknown id, and whatever the campaigns throw.
record::Page reproduce(const grid::Grid& grid, const Options& options,
                       const campaign::Execution& execution);

}  // namespace gsbench::paper
