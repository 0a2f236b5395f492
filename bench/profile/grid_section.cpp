#include "sections.hpp"
#include <control_centre/blocks.hpp>
#include <control_centre/threshold.hpp>

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include <grid/grid.hpp>
#include <outlet/settings.hpp>

namespace gsbench::profile {
namespace {

using keys::Key;
using keys::Table;

constexpr const char* kInPlaceName = "in the profile";

Key number(const char* name, const char* unit, const grid::Limits& limits, const char* meaning) {
  return keys::number(name, unit, keys::between(limits.low, limits.high), meaning);
}

std::vector<Key> system_keys() {
  const grid::Grid defaults;
  return {
      keys::number("nominal_hz", "Hz", keys::between(50.0, 60.0), "f_n: nominal frequency")
          .permits("50 or 60")
          .require(),
      number("threshold_hz", "Hz", grid::kFrequency_hz, "f_s: lowest permitted nadir")
          .permits("0.001 … below nominal")
          .require(),
      number("base_mw", "MW", grid::kPower_mw, "S_B: base power of D, H and R").require(),
      number("load_mw", "MW", grid::kPower_mw, "P_L: total load, for eq. (17)").require(),
      number(
          "credible_loss_mw", "MW", grid::kPower_mw,
          "largest credible loss (reference incident): the threshold loss in the outlets' "
          "settings is such that f_s is kept after this loss, although outlets act 0.968 s later")
          .permits("10⁻⁶ … `base_mw`")
          .or_else("1.4 times the threshold loss by eq. (15)"),
      number("damping_pu", "p.u.", grid::kDamping_pu, "D: load damping")
          .permits("0 … 1000; above 0 if there are blocks")
          .require(),
      number("gain_km", "", grid::kGain, "K_m: mechanical power gain").by_default(defaults.gain_km),
      number("reheat_fraction", "", grid::kFraction,
             "F_H: fraction of the power from the high-pressure turbine")
          .by_default(defaults.reheat_fraction),
      number("reheat_s", "s", grid::kTime_s, "T_R: reheat time constant")
          .by_default(defaults.reheat_s),
      number("condition_row_hz", "Hz", grid::kConditionRow_hz,
             "frequency step between the rows of Table 1")
          .permits(
              "0.001 … 1000; the resulting table may have at most 32 rows if a profile uses the "
              "grid")
          .by_default(defaults.condition_row_hz),
  };
}

// [[plant]], [[block]] and [reference], of a grid file or of an inline grid.
std::vector<Key> part_keys() {
  return {
      keys::tables(
          "plant", "The plants in operation; at least one.",
          {keys::text("id", "name of the plant").require(),
           number("rating_mw", "MW", grid::kPower_mw, "rated power").require(),
           number("inertia_s", "s", grid::kTime_s, "H: inertia constant on the plant's rating")
               .require(),
           number("droop_pu", "p.u.", grid::kDroop_pu, "R: governor droop on the plant's rating")
               .or_else("required, or `inverse_droop_pu`"),
           keys::number("inverse_droop_pu", "p.u.",
                        keys::between(1.0 / grid::kDroop_pu.high, 1.0 / grid::kDroop_pu.low), "1/R")
               .or_else("required, or `droop_pu`")}),
      keys::tables("block", "Load blocks in the order of shedding, the least important first.",
                   {keys::text("id", "name of the block").require(),
                    number("power_mw", "MW", grid::kPower_mw, "load of the block")
                        .permits("10⁻⁶ … 10⁷; all blocks together at most `load_mw`; switching-off "
                                 "frequency of eq. (17) above 0 Hz")
                        .require()}),
      keys::table(
          "reference",
          "Published values for this grid. Reports compare the computed ones with them.",
          {keys::text("source", "the publication").require(),
           number("t_nadir_s", "s", grid::kTime_s, "time of the nadir after the threshold loss"),
           number("threshold_mw", "MW", grid::kPower_mw, "threshold loss"),
           keys::array("condition_rocof_hz_s", number("", "Hz/s", grid::kConditionRocof_hz_s, ""),
                       "ROCOF limits of Table 1, from f_n downwards"),
           keys::text("note", "why the computed values differ")}),
  };
}

void read_system(const Table& table, grid::Grid& grid) {
  grid.nominal_hz = table.number("nominal_hz");
  if (grid.nominal_hz != 50.0 && grid.nominal_hz != 60.0) {
    table.refuse("nominal_hz",
                 fmt::format("nominal_hz is {}; it must be 50 or 60", grid.nominal_hz));
  }
  grid.threshold_hz = table.number("threshold_hz");
  grid.base_mw = table.number("base_mw");
  grid.load_mw = table.number("load_mw");
  grid.credible_loss_mw = table.find_number("credible_loss_mw");
  grid.damping_pu = table.number("damping_pu");
  grid.gain_km = table.number("gain_km");
  grid.reheat_fraction = table.number("reheat_fraction");
  grid.reheat_s = table.number("reheat_s");
  grid.condition_row_hz = table.number("condition_row_hz");
}

grid::Plant read_plant(const Table& table) {
  grid::Plant plant;
  plant.id = table.text("id");
  plant.rating_mw = table.number("rating_mw");
  plant.inertia_s = table.number("inertia_s");
  const auto inverse = table.find_number("inverse_droop_pu");
  const auto droop = table.find_number("droop_pu");
  if (inverse && droop) {
    table.refuse("droop_pu", "both droop_pu and inverse_droop_pu are given; give only one");
  }
  if (!inverse && !droop) {
    table.refuse_missing("droop_pu", "droop_pu or inverse_droop_pu");
  }
  plant.droop_pu = droop ? *droop : 1.0 / *inverse;
  return plant;
}

grid::Reference read_reference(const Table& table) {
  grid::Reference reference;
  reference.source = table.text("source");
  reference.t_nadir_s = table.find_number("t_nadir_s");
  reference.threshold_mw = table.find_number("threshold_mw");
  reference.condition_rocof_hz_s = table.numbers("condition_rocof_hz_s");
  reference.note = table.find_text("note").value_or("");
  return reference;
}

// Position of a GridError's field in the file, or of the table that should hold it.
keys::Position position_of(const Table& holder, const grid::GridError& error) {
  const auto dot = error.field.find('.');
  const std::string part = error.field.substr(0, dot);
  if (dot == std::string::npos) {
    return holder.at(part);
  }
  const Table table = error.index < 0
                          ? holder.table(part)
                          : holder.tables(part).at(static_cast<std::size_t>(error.index));
  return table.at(error.field.substr(dot + 1));
}

// `holder` holds [system], [[plant]], [[block]] and [reference].
grid::Grid read_parts(const Table& holder, std::string name, std::string title,
                      std::string source) {
  grid::Grid grid;
  grid.name = std::move(name);
  grid.title = std::move(title);
  grid.source = std::move(source);
  read_system(holder.table("system"), grid);
  for (const Table& plant : holder.tables("plant")) {
    grid.plants.push_back(read_plant(plant));
  }
  for (const Table& block : holder.tables("block")) {
    grid.blocks.push_back({block.text("id"), block.number("power_mw")});
  }
  if (holder.has("reference")) {
    grid.reference = read_reference(holder.table("reference"));
  }
  try {
    // Also check the grid. Outlets may be sent the settings of either.
    for (const auto rules : {control_centre::Rules::kGsbench, control_centre::Rules::kPaper}) {
      control_centre::block_settings(grid, control_centre::Accumulation::kHalfGroup, rules);
    }
  } catch (const grid::GridError& error) {
    holder.refuse(position_of(holder, error), error.what());
  }
  return grid;
}

}  // namespace

const Key& grid_keys() {
  static const Key keys = [] {
    Key file = keys::table(
        "a grid file", "",
        {keys::text("title", "title in lists and reports, one line").require(),
         keys::text("source", "origin of the figures").require(),
         keys::table("system", "Parameters of the frequency response model.", system_keys())
             .require("[system] with the parameters of the grid")});
    for (Key& part : part_keys()) {
      file.inner.push_back(std::move(part));
    }
    return file;
  }();
  return keys;
}

Key grid_section_keys() {
  Key section =
      keys::table("grid", "The power system and its disturbances.",
                  {keys::text_or_table(
                       "system",
                       "a shipped grid (`\"ieee24\"`), the path of a `.toml` file relative to the "
                       "profile, or an inline grid: `[grid.system]`, `[[grid.plant]]`, "
                       "`[[grid.block]]`, `[grid.reference]`, with the keys of [a grid](#a-grid)",
                       system_keys())
                       .described_in("a grid")
                       .require("a grid's name (\"ieee24\"), its path, or [grid.system]")})
          .require("the power system, e.g. [grid] system = \"ieee24\"");
  for (Key& part : part_keys()) {
    part.meaning = "part of an inline grid";
    section.inner.push_back(part.described_in("a grid"));
  }
  section.inner.push_back(frequency_before_key());
  section.inner.push_back(loss_keys());
  return section;
}

grid::Grid read_grid_text(const NamedFile& file, const std::string& text) {
  const keys::Document document = keys::parse_toml(text, file.path);
  const Table top(document, grid_keys());
  grid::Grid grid = read_parts(top, file.name, top.text("title"), top.text("source"));
  grid.path = file.path;
  grid.sha256 = sha256(text);
  return grid;
}

grid::Grid read_grid_section(const Table& section, const std::string& title,
                             const std::string& source, const std::optional<std::string>& copy,
                             std::string& text) {
  if (section.holds_table("system")) {
    return read_parts(section, kInPlaceName, title, source);
  }
  const std::string name = section.text("system");
  for (const char* part : {"plant", "block", "reference"}) {
    if (section.has(part)) {
      section.refuse(part, fmt::format("{} is only valid with an inline grid ([grid.system]), but "
                                       "system is \"{}\"; omit one of the two",
                                       part, name));
    }
  }
  const auto folder = std::filesystem::path(section.document().path).parent_path().string();
  if (copy) {
    text = *copy;
    return read_grid_text(copied_grid(name, folder), text);
  }
  const auto file = find_grid(name, folder);
  if (!file) {
    section.refuse("system", unknown_grid(name));
  }
  text = read_file(file->path);
  return read_grid_text(*file, text);
}

void check_conditions(const Table& section, const grid::Grid& grid) {
  const std::size_t rows =
      control_centre::conditions(grid::SfrModel(grid), grid.threshold_hz, grid.condition_row_hz)
          .size();
  if (rows <= gs::outlet::kMaxConditions) {
    return;
  }
  const keys::Position at = section.holds_table("system")
                                ? section.table("system").at("condition_row_hz")
                                : section.at("system");
  section.refuse(at, fmt::format("condition_row_hz is {}, which gives {} load-shedding conditions; "
                                 "an outlet stores at most {}: increase condition_row_hz",
                                 grid.condition_row_hz, rows, gs::outlet::kMaxConditions));
}

}  // namespace gsbench::profile
