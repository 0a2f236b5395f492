#include "batches.hpp"
#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <campaign/conditions.hpp>
#include <campaign/kernel.hpp>
#include <grid/sfr_model.hpp>
#include <outlet/decision.hpp>

namespace gsbench::campaign {
namespace {

void check(const ConditionOptions& options) {
  const Counting& counting = options.counting;
  const auto demand = [](bool holds, const char* otherwise) {
    if (!holds) {
      throw std::invalid_argument(otherwise);
    }
  };
  demand(counting.window >= 2 && counting.window <= 64, "a line takes 2 … 64 samples");
  demand(counting.first >= 0 && counting.first <= 1000, "counting begins within 1000 samples");
  demand(counting.count >= 1 && counting.count <= 1000, "1 … 1000 lines count");
  demand(counting.more_than >= 0 && counting.more_than < counting.count,
         "hits must be able to exceed the number above which load shedding is needed");
  demand(options.noise_hz >= 0.0 && options.noise_hz <= 1.0, "the noise must be within 0 … 1 Hz");
  demand(options.trajectories > 0 && options.trajectories <= kMostTrajectories,
         "there must be 1 … 2^32 trajectories");
}

}  // namespace

Counting shipped_counting(const grid::Grid& grid) {
  const gs::outlet::Settings settings = control_centre::grid_settings(grid);
  return {settings.rocof_samples, settings.lse_samples, settings.ekf_samples,
          settings.condition_hits};
}

ConditionResult count_conditions(const grid::Grid& grid, const ConditionOptions& options,
                                 const Execution& execution) {
  check(options);
  const grid::SfrModel model(grid);
  const gs::outlet::Settings settings = control_centre::grid_settings(grid);
  const auto nominal_hz = static_cast<float>(grid.nominal_hz);
  const Counting& counting = options.counting;
  // Lines may reach back before the loss.
  const int before = std::max(0, counting.window - 1 - counting.first);
  const CountedConditions counted = {counting.window, counting.first + before, counting.count};
  const auto samples =
      static_cast<std::size_t>(counted.first) + static_cast<std::size_t>(counted.count);
  std::vector<float> clean;
  for (std::size_t k = 0; k < samples; ++k) {
    const double t_s = kReportS * (static_cast<double>(k) + 1.0 - static_cast<double>(before));
    clean.push_back(static_cast<float>(options.loss_mw * model.unit_deviation_hz(t_s)));
  }
  const auto work = [&](std::uint64_t block, Histograms& own) {
    std::vector<float> deviations_hz(samples * kLanes);
    each_batch(block, options.trajectories,
               [&](std::uint64_t, std::uint64_t first, std::uint64_t count) {
                 measure(options, clean.data(), samples, first, deviations_hz.data());
                 float hits[kLanes];
                 count_conditions(settings, nominal_hz, counted, deviations_hz.data(), hits);
                 for (std::uint64_t i = 0; i < count; ++i) {
                   own[0].add(static_cast<double>(hits[i]));
                 }
               });
  };
  Histograms histograms = {Histogram(0.0, static_cast<double>(counting.count) + 1.0,
                                     static_cast<std::size_t>(counting.count) + 1)};
  run_blocks(blocks_of(options.trajectories), execution, work, histograms);
  const Histogram& hits = histograms[0];
  ConditionResult result = {static_cast<std::uint64_t>(hits.count()), 0, hits};
  for (int n = 0; n <= counting.count; ++n) {
    if (gs::outlet::enough_hits(n, counting.more_than)) {
      result.needed += static_cast<std::uint64_t>(hits.in_bin(static_cast<std::size_t>(n)));
    }
  }
  return result;
}

}  // namespace gsbench::campaign
