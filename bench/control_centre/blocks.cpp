#include <control_centre/blocks.hpp>
#include <control_centre/threshold.hpp>

#include <stdexcept>

#include <fmt/format.h>

#include <grid/sfr_model.hpp>

namespace gsbench::control_centre {
namespace {

// The paper's sum runs over its own index i; the sum over j = 1 … i−1 is meant, the blocks that are
// already off.
double eq17_hz(const grid::Grid& grid, double less_important_mw, double power_mw) {
  return grid.threshold_hz -
         power_mw / (grid.damping_pu * (grid.load_mw - less_important_mw)) * grid.nominal_hz;
}

}  // namespace

double accumulated_mw(double less_important_mw, double group_mw, Accumulation accumulation) {
  return less_important_mw + (accumulation == Accumulation::kWholeGroup ? 1.0 : 0.5) * group_mw;
}

Stages::Stages(const grid::Grid& grid) {
  const double depth_hz = grid.nominal_hz - grid.threshold_hz;
  first_hz_ = grid.threshold_hz - kMargin * depth_hz;
  mw_per_hz_ = kDroopFactor * threshold_mw(grid::SfrModel(grid), grid.threshold_hz) / depth_hz;
}

std::vector<BlockSetting> block_settings(const grid::Grid& grid, Accumulation accumulation,
                                         Rules rules) {
  grid::check(grid);
  if (rules == Rules::kPaper && !grid.blocks.empty() && grid.damping_pu == 0.0) {
    throw grid::GridError(
        "system.damping_pu", -1,
        "damping_pu is 0; it must be above 0 if there are blocks, because eq. (17) "
        "divides by it");
  }
  const Stages stages(grid);
  std::vector<BlockSetting> settings;
  double less_important_mw = 0.0;
  for (const grid::Block& block : grid.blocks) {
    const double accumulated = accumulated_mw(less_important_mw, block.power_mw, accumulation);
    const double switch_off = rules == Rules::kPaper
                                  ? eq17_hz(grid, less_important_mw, block.power_mw)
                                  : stages.switch_off_hz(accumulated);
    if (switch_off <= 0.0) {
      throw grid::GridError(
          "block.power_mw", static_cast<int>(settings.size()),
          fmt::format("block {} \"{}\": power_mw is {}, which gives a switching-off frequency{} of "
                      "{} Hz; it must be smaller, so that the frequency is above 0",
                      settings.size() + 1, block.id, block.power_mw,
                      rules == Rules::kPaper ? ", eq. (17)," : "", switch_off));
    }
    settings.push_back({block.id, block.power_mw, accumulated, switch_off});
    less_important_mw += block.power_mw;
  }
  return settings;
}

double eq17_switch_off_hz(const grid::Grid& grid, double less_important_mw, double power_mw) {
  if (!(less_important_mw >= 0.0 && power_mw >= 0.0 &&
        less_important_mw + power_mw <= grid.load_mw)) {
    throw std::invalid_argument(
        fmt::format("power_mw is {} and the load that is shed before is {} MW; both must be at "
                    "least 0, and their sum at most {} (load_mw)",
                    power_mw, less_important_mw, grid.load_mw));
  }
  if (power_mw == 0.0) {
    return grid.threshold_hz;  // eq. (17) without own load, also for damping_pu = 0
  }
  const double switch_off = eq17_hz(grid, less_important_mw, power_mw);
  if (!(switch_off > 0.0)) {
    throw std::invalid_argument(
        fmt::format("power_mw is {} and damping_pu {}, which gives a switching-off frequency, "
                    "eq. (17), of {} Hz; it must be above 0",
                    power_mw, grid.damping_pu, switch_off));
  }
  return switch_off;
}

}  // namespace gsbench::control_centre
