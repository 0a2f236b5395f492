// A power system for the frequency response model: plants, load, load blocks and the threshold
// frequency. Data only: bench/profile reads it from a grid file, SfrModel and bench/control_centre
// use it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gsbench::grid {

// One generator in operation. Tripped generators are not included (eq. 2).
struct Plant {
  std::string id;
  double rating_mw = 0.0;  // > 0
  double inertia_s = 0.0;  // H on its own rating, > 0
  double droop_pu = 0.0;   // R on its own rating, > 0
};

// A load block. Blocks are ordered by importance, the least important first (§4.1).
struct Block {
  std::string id;
  double power_mw = 0.0;  // > 0
};

// Published values for this grid, for comparison with the computed ones.
struct Reference {
  std::string source;
  std::optional<double> t_nadir_s;
  std::optional<double> threshold_mw;
  std::vector<double> condition_rocof_hz_s;  // row by row, from f_n down; empty: not published
  std::string note;                          // why computed values differ, for reports
};

// Smallest frequency step between rows of Table 1: outlets do not resolve less than a millihertz.
constexpr double kLowestConditionRow_hz = 0.001;

struct Grid {
  std::string name;
  std::string title;
  std::string source;
  std::string path;            // of the grid file, as opened; empty for an inline grid
  std::string sha256;          // of the file's text, hexadecimal; empty for an inline grid
  double nominal_hz = 50.0;    // f_n, the frequency before the contingency; > 0
  double threshold_hz = 49.5;  // f_s, the lowest permitted nadir; 0 < f_s < f_n
  double base_mw = 0.0;        // S_B, base of D, H and R; > 0
  double load_mw = 0.0;        // P_L of eq. (17); > 0
  // Largest loss that the outlets' threshold allows their delay for, <= base_mw; if not given, it
  // is derived from the threshold loss (control_centre/threshold.hpp).
  std::optional<double> credible_loss_mw;
  double damping_pu = 0.0;         // D >= 0
  double gain_km = 0.95;           // K_m > 0
  double reheat_fraction = 0.3;    // F_H, 0 … 1
  double reheat_s = 8.0;           // T_R > 0
  double condition_row_hz = 0.05;  // step between rows of Table 1; >= kLowestConditionRow_hz
  std::vector<Plant> plants;       // at least one
  std::vector<Block> blocks;       // may be empty
  Reference reference;
};

// One change of the power balance: positive is lost generation, negative is shed load.
struct PowerChange {
  double at_s = 0.0;
  double power_mw = 0.0;
  double ramp_s = 0.0;  // the power changes linearly over this time from at_s on; 0: at once

  // The part that has changed `since_s` after at_s, MW; since_s >= 0.
  double changed_mw(double since_s) const {
    return since_s < ramp_s ? power_mw * since_s / ramp_s : power_mw;
  }
};

// An invalid grid. what() gives the field, its value and what would be right. The reader of a grid
// file uses field and index to find the position in the file.
struct GridError : std::invalid_argument {
  GridError(std::string field_path, int position, const std::string& message)
      : std::invalid_argument(message), field(std::move(field_path)), index(position) {}

  // Table and key as in a grid file: "system.damping_pu", "plant.inertia_s", "block.power_mw",
  // "reference.condition_rocof_hz_s"; "plant" if the grid has no plant.
  std::string field;
  int index;  // of the plant, the block or the reference's row, from 0; -1 for other fields
};

// Throws GridError for the first field that is not finite, out of range, or inconsistent with
// another. The ranges are far wider than any real system: they detect a wrong unit (W instead of
// MW) and keep the model's arithmetic finite.
void check(const Grid& grid);

// Permitted ranges of a grid's fields, both ends included.
struct Limits {
  double low;
  double high;
};

constexpr Limits kFrequency_hz{1e-3, 1e3};
constexpr Limits kPower_mw{1e-6, 1e7};
constexpr Limits kTime_s{1e-3, 1e3};
constexpr Limits kDamping_pu{0.0, 1e3};
constexpr Limits kGain{1e-3, 1e3};
constexpr Limits kFraction{0.0, 1.0};
constexpr Limits kDroop_pu{1e-4, 10.0};
constexpr Limits kConditionRow_hz{kLowestConditionRow_hz, 1e3};
constexpr Limits kConditionRocof_hz_s{-1e3, 0.0};

}  // namespace gsbench::grid
