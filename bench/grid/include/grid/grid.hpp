// A power system as the frequency response model sees it: plants, load, and what is wanted of the
// control. Pure data: bench/profile fills it from a grid file, SfrModel and bench/control_centre
// use it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gsbench::grid {

// One generator in operation. Tripped ones are left out (eq. 2).
struct Plant {
  std::string id;
  double rating_mw = 0.0;  // > 0
  double inertia_s = 0.0;  // H on its own rating, > 0
  double droop_pu = 0.0;   // R on its own rating, > 0
};

// A load block in order of importance, the least important first (§4.1).
struct Block {
  std::string id;
  double power_mw = 0.0;  // > 0
};

// What a publication prints for this grid, to be shown beside our own figures.
struct Reference {
  std::string source;
  std::optional<double> t_nadir_s;
  std::optional<double> threshold_mw;
  std::vector<double> condition_rocof_hz_s;  // row by row, from f_n down; empty: none printed
  std::string note;                          // why figures differ, for the reader of a report
};

// Of the rows of Table 1: no outlet resolves less than a millihertz.
constexpr double kLowestConditionRow_hz = 0.001;

struct Grid {
  std::string name;
  std::string title;
  std::string source;
  std::string path;                // of the file, as opened; empty where it is in none
  std::string sha256;              // of the file's text, hexadecimal; empty where it is in no file
  double nominal_hz = 50.0;        // f_n, the frequency before the contingency; > 0
  double threshold_hz = 49.5;      // f_s, the nadir that must not be undershot; 0 < f_s < f_n
  double base_mw = 0.0;            // S_B, base of D, H and R; > 0
  double load_mw = 0.0;            // P_L of eq. (17); > 0
  double damping_pu = 0.0;         // D >= 0
  double gain_km = 0.95;           // K_m > 0
  double reheat_fraction = 0.3;    // F_H, 0 … 1
  double reheat_s = 8.0;           // T_R > 0
  double condition_row_hz = 0.05;  // height of a row of Table 1; >= kLowestConditionRow_hz
  std::vector<Plant> plants;       // at least one
  std::vector<Block> blocks;       // may be empty
  Reference reference;
};

// One step of the power balance at `at_s`: positive is lost generation, negative is shed load.
struct PowerChange {
  double at_s = 0.0;
  double power_mw = 0.0;
};

// A grid that makes no sense. what() names the field, its value and what would be right; field and
// index let whoever read the grid from a file point at the line.
struct GridError : std::invalid_argument {
  GridError(std::string field_path, int position, const std::string& message)
      : std::invalid_argument(message), field(std::move(field_path)), index(position) {}

  // Table and key as in a grid file: "system.damping_pu", "plant.inertia_s", "block.power_mw",
  // "reference.condition_rocof_hz_s"; only "plant" where there is none at all.
  std::string field;
  int index;  // from 0, of the plant, the block or the reference's row; -1 where there is but one
};

// Throws GridError for the first field that is not finite, outside its range, or at odds with
// another. The ranges reach far beyond any real system: they catch a wrong unit (W for MW) and keep
// the model's arithmetic finite.
void check(const Grid& grid);

// What is permitted of a grid's fields, both ends included. No power system comes near the ends; a
// value past them was given in another unit.
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
