#include "batches.hpp"
#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include <campaign/conditions.hpp>
#include <campaign/kernel.hpp>
#include <grid/sfr_model.hpp>
#include <outlet/decision.hpp>

namespace gsbench::campaign {
namespace {

void check(const ConditionOptions& options) {
  const Counting& counting = options.counting;
  demand(counting.window >= 2 && counting.window <= 64,
         fmt::format("a slope over {} samples is not over 2 … 64", counting.window));
  demand(counting.first >= 0 && counting.first <= 1000,
         fmt::format("the first sample that counts, {}, is not within 0 … 1000", counting.first));
  demand(counting.count >= 1 && counting.count <= 1000,
         fmt::format("{} slopes that count are not within 1 … 1000", counting.count));
  demand(counting.more_than >= 0 && counting.more_than < counting.count,
         fmt::format("the number of hits to exceed, {}, is not within 0 … {} for {} slopes",
                     counting.more_than, counting.count - 1, counting.count));
  demand(options.noise_hz >= 0.0 && options.noise_hz <= 1.0,
         fmt::format("a noise of {:g} Hz is not within 0 … 1 Hz", options.noise_hz));
  demand(options.trajectories > 0 && options.trajectories <= kMostTrajectories,
         fmt::format("{} trajectories are not within 1 … 2^32", options.trajectories));
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
  // The first lines may start before the loss.
  const int before = std::max(0, options.counting.window - 1 - options.counting.first);
  Counting counted = options.counting;
  counted.first += before;
  std::vector<float> clean;
  for (int k = 1 - before; k <= counted.first + counted.count - before; ++k) {
    clean.push_back(static_cast<float>(
        options.loss_mw * model.unit_deviation_hz(kReport_s * static_cast<double>(k))));
  }
  const auto each = [&](const float* deviations_hz, std::uint64_t, std::uint64_t count,
                        Histograms& own) {
    float hits[kLanes];
    count_conditions(settings, nominal_hz, counted, deviations_hz, hits);
    for (std::uint64_t i = 0; i < count; ++i) {
      own[0].add(static_cast<double>(hits[i]));
    }
  };
  Histograms histograms = {Histogram(0.0, static_cast<double>(counted.count) + 1.0,
                                     static_cast<std::size_t>(counted.count) + 1)};
  run_batches(
      options, clean.size(), [&](std::uint64_t) { return clean.data(); }, each, execution,
      histograms);
  const Histogram& hits = histograms[0];
  ConditionResult result = {static_cast<std::uint64_t>(hits.count()), 0, hits};
  for (int n = 0; n <= counted.count; ++n) {
    if (gs::outlet::enough_hits(n, counted.more_than)) {
      result.needed += static_cast<std::uint64_t>(hits.in_bin(static_cast<std::size_t>(n)));
    }
  }
  return result;
}

}  // namespace gsbench::campaign
