// The paper's §6 computed again: each of its tables and figures beside ours.
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
  std::string title;  // with the paper's section
};

// In the paper's order.
std::vector<Item> items();

// What the paper leaves open, and how it is read here where nobody says otherwise. Tables tell how
// much they move over it.
struct Choices {
  campaign::NoiseDistribution noise_distribution =
      campaign::NoiseDistribution::kUniform;  // of "a noise within ±0.01 Hz"
  campaign::LossInstant loss_instant = campaign::LossInstant::kOnReport;
  // Table 2: the slope over ten samples, counted from the first on for about as long as the paper's
  // figures tell, more than 15 hits.
  campaign::Counting counting = {10, 0, 36, 15};
  // Where the paper's EKF starts: standard deviations of LSE and of t_x.
  double ekf_loss_sigma_mw = 80.0;
  double ekf_t_x_sigma_s = 0.02;
};

struct Options {
  std::vector<std::string> only;  // ids; none: all
  std::uint64_t trajectories = 1000000;
  std::uint64_t seed = 1;
  Choices choices;
  // P^A of the firmware's fleets; the paper's way has eq. (11).
  control_centre::Accumulation accumulation = control_centre::Accumulation::kHalfGroup;
  // Plays the 500 MW experiment for Fig. 19, from the voltage on. None: not played.
  std::function<record::RunRecord(const campaign::Execution&)> play_experiment;
};

// What was reproduced. Throws std::invalid_argument for an id that there is none of, and as the
// campaigns do. Stopped, it holds what was done so far, and says so.
record::Page reproduce(const grid::Grid& grid, const Options& options,
                       const campaign::Execution& execution);

}  // namespace gsbench::paper
