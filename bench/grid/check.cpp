#include <fmt/format.h>

#include <grid/grid.hpp>

namespace gsbench::grid {
namespace {

// One entry of the grid file's table `table`; `name` identifies it in messages.
struct Place {
  std::string table;
  int index;
  std::string name;

  // `correction`: what would be right.
  [[noreturn]] void refuse(const std::string& key, double value,
                           const std::string& correction) const {
    throw GridError(table + "." + key, index,
                    fmt::format("{}{} is {}; it must be {}", name, key, value, correction));
  }
  void require(const std::string& key, double value, const Limits& limits) const {
    const bool holds = value >= limits.low && value <= limits.high;  // never for NaN
    if (!holds) {
      refuse(key, value, fmt::format("from {} to {}", limits.low, limits.high));
    }
  }
};

void check_system(const Grid& grid) {
  const Place system{"system", -1, ""};
  system.require("nominal_hz", grid.nominal_hz, kFrequency_hz);
  system.require("threshold_hz", grid.threshold_hz, kFrequency_hz);
  if (grid.threshold_hz >= grid.nominal_hz) {
    system.refuse("threshold_hz", grid.threshold_hz,
                  fmt::format("below {} (nominal_hz)", grid.nominal_hz));
  }
  system.require("base_mw", grid.base_mw, kPower_mw);
  system.require("load_mw", grid.load_mw, kPower_mw);
  if (grid.credible_loss_mw) {
    system.require("credible_loss_mw", *grid.credible_loss_mw, kPower_mw);
    if (*grid.credible_loss_mw > grid.base_mw) {
      system.refuse("credible_loss_mw", *grid.credible_loss_mw,
                    fmt::format("at most {} (base_mw)", grid.base_mw));
    }
  }
  system.require("damping_pu", grid.damping_pu, kDamping_pu);
  system.require("gain_km", grid.gain_km, kGain);
  system.require("reheat_fraction", grid.reheat_fraction, kFraction);
  system.require("reheat_s", grid.reheat_s, kTime_s);
  system.require("condition_row_hz", grid.condition_row_hz, kConditionRow_hz);
}

void check_plants(const Grid& grid) {
  if (grid.plants.empty()) {
    throw GridError("plant", -1, "the grid has no plant; it must have at least one in operation");
  }
  for (std::size_t i = 0; i < grid.plants.size(); ++i) {
    const Plant& plant = grid.plants[i];
    const Place place{"plant", static_cast<int>(i),
                      fmt::format("plant {} \"{}\": ", i + 1, plant.id)};
    place.require("rating_mw", plant.rating_mw, kPower_mw);
    place.require("inertia_s", plant.inertia_s, kTime_s);
    place.require("droop_pu", plant.droop_pu, kDroop_pu);
  }
}

void check_blocks(const Grid& grid) {
  double less_important_mw = 0.0;
  for (std::size_t i = 0; i < grid.blocks.size(); ++i) {
    const Block& block = grid.blocks[i];
    const Place place{"block", static_cast<int>(i),
                      fmt::format("block {} \"{}\": ", i + 1, block.id)};
    place.require("power_mw", block.power_mw, kPower_mw);
    if (less_important_mw + block.power_mw > grid.load_mw) {
      place.refuse("power_mw", block.power_mw,
                   fmt::format("at most {}, so that all blocks together do not exceed {} (load_mw)",
                               grid.load_mw - less_important_mw, grid.load_mw));
    }
    less_important_mw += block.power_mw;
  }
}

void check_reference(const Grid& grid) {
  const Place reference{"reference", -1, "reference: "};
  if (grid.reference.t_nadir_s) {
    reference.require("t_nadir_s", *grid.reference.t_nadir_s, kTime_s);
  }
  if (grid.reference.threshold_mw) {
    reference.require("threshold_mw", *grid.reference.threshold_mw, kPower_mw);
  }
  for (std::size_t i = 0; i < grid.reference.condition_rocof_hz_s.size(); ++i) {
    const Place row{"reference", static_cast<int>(i), fmt::format("reference row {}: ", i + 1)};
    row.require("condition_rocof_hz_s", grid.reference.condition_rocof_hz_s[i],
                kConditionRocof_hz_s);
  }
}

}  // namespace

void check(const Grid& grid) {
  check_system(grid);
  check_plants(grid);
  check_blocks(grid);
  check_reference(grid);
}

}  // namespace gsbench::grid
