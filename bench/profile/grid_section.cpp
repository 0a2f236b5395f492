#include "grid_section.hpp"

#include <control_centre/blocks.hpp>
#include <control_centre/conditions.hpp>

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include <outlet/settings.hpp>

namespace gsbench::profile {
namespace {

constexpr const char* kInPlaceName = "in the profile";

void read_system(const Table& table, grid::Grid& grid) {
  grid.nominal_hz = table.required_number("nominal_hz");
  if (grid.nominal_hz != 50.0 && grid.nominal_hz != 60.0) {
    table.refuse("nominal_hz", fmt::format("nominal_hz is {}; outlets are made for 50 and for 60",
                                           grid.nominal_hz));
  }
  grid.threshold_hz = table.required_number("threshold_hz");
  grid.base_mw = table.required_number("base_mw");
  grid.load_mw = table.required_number("load_mw");
  grid.damping_pu = table.required_number("damping_pu");
  grid.gain_km = table.number("gain_km").value_or(grid.gain_km);
  grid.reheat_fraction = table.number("reheat_fraction").value_or(grid.reheat_fraction);
  grid.reheat_s = table.number("reheat_s").value_or(grid.reheat_s);
  grid.condition_row_hz = table.number("condition_row_hz").value_or(grid.condition_row_hz);
}

grid::Plant read_plant(const Table& table) {
  grid::Plant plant;
  plant.id = table.required_text("id");
  plant.rating_mw = table.required_number("rating_mw");
  plant.inertia_s = table.required_number("inertia_s");
  const auto inverse = table.number("inverse_droop_pu", above(0.0));
  const auto droop = table.number("droop_pu");
  if (inverse && droop) table.refuse("droop_pu", "give droop_pu or inverse_droop_pu, not both");
  if (!inverse && !droop) table.refuse_missing("droop_pu", "a number, or inverse_droop_pu");
  plant.droop_pu = droop ? *droop : 1.0 / *inverse;
  return plant;
}

grid::Block read_block(const Table& table) {
  return {table.required_text("id"), table.required_number("power_mw")};
}

grid::Reference read_reference(const Table& table) {
  grid::Reference reference;
  reference.source = table.required_text("source");
  reference.t_nadir_s = table.number("t_nadir_s");
  reference.threshold_mw = table.number("threshold_mw");
  reference.condition_rocof_hz_s = table.numbers("condition_rocof_hz_s");
  reference.note = table.text("note").value_or("");
  return reference;
}

// Where in the file the field of a GridError stands: the narrowest of array item, value and table
// that there is.
Position position_of(const Table& holder, const grid::GridError& error) {
  const auto dot = error.field.find('.');
  const Value* found = holder.table(error.field.substr(0, dot));
  if (found == nullptr) return holder.at();
  const auto index = static_cast<std::size_t>(error.index);
  const auto item = [&](const Value& value) {
    const auto* items = std::get_if<Array>(&value.data);
    return items != nullptr && error.index >= 0 && index < items->size() ? &(*items)[index]
                                                                         : &value;
  };
  found = item(*found);
  const auto* entries = std::get_if<Entries>(&found->data);
  if (entries == nullptr || dot == std::string::npos) return found->at;
  const std::string key = error.field.substr(dot + 1);
  for (const Entry& entry : *entries) {
    if (entry.key == key || entry.key == "inverse_" + key) return item(entry.value)->at;
  }
  return found->at;
}

// `holder` holds [system], [[plant]], [[block]] and [reference].
grid::Grid read_parts(const Table& holder, std::string name, std::string title,
                      std::string source) {
  const Document& document = holder.document();
  grid::Grid grid;
  grid.name = std::move(name);
  grid.title = std::move(title);
  grid.source = std::move(source);
  if (!holder.has("system")) holder.refuse_missing("system", "the grid's parameters");
  read_system(Table(document, *holder.table("system"), "[system]",
                    {"nominal_hz", "threshold_hz", "base_mw", "load_mw", "damping_pu", "gain_km",
                     "reheat_fraction", "reheat_s", "condition_row_hz"}),
              grid);
  for (const Value* plant : holder.tables("plant")) {
    grid.plants.push_back(
        read_plant(Table(document, *plant, "[[plant]]",
                         {"id", "rating_mw", "inertia_s", "inverse_droop_pu", "droop_pu"})));
  }
  for (const Value* block : holder.tables("block")) {
    grid.blocks.push_back(read_block(Table(document, *block, "[[block]]", {"id", "power_mw"})));
  }
  if (const Value* reference = holder.table("reference")) {
    grid.reference = read_reference(
        Table(document, *reference, "[reference]",
              {"source", "t_nadir_s", "threshold_mw", "condition_rocof_hz_s", "note"}));
  }
  try {
    control_centre::block_settings(grid);  // checks the grid, too
  } catch (const grid::GridError& error) {
    holder.refuse(position_of(holder, error), error.what());
  }
  return grid;
}

}  // namespace

grid::Grid read_grid_file(const NamedFile& file) {
  const std::string text = read_file(file.path);
  const Document document = parse_toml(text, file.path);
  const Table top(document, document.root, "a grid file",
                  {"title", "source", "system", "plant", "block", "reference"});
  grid::Grid grid =
      read_parts(top, file.name, top.required_text("title"), top.required_text("source"));
  grid.path = file.path;
  grid.sha256 = sha256(text);
  return grid;
}

grid::Grid read_grid_section(const Table& section, const std::string& title,
                             const std::string& source) {
  if (!section.has("system")) {
    section.refuse_missing("system", "a grid's name (\"ieee24\"), its path, or [grid.system]");
  }
  if (std::holds_alternative<Entries>(section.table("system")->data)) {
    return read_parts(section, kInPlaceName, title, source);
  }
  const std::string name = section.required_text("system");
  for (const char* part : {"plant", "block", "reference"}) {
    if (section.has(part)) {
      section.refuse(part, fmt::format("{} belongs to a grid in place ([grid.system]); this "
                                       "profile takes the grid \"{}\"",
                                       part, name));
    }
  }
  const auto folder = std::filesystem::path(section.document().path).parent_path().string();
  const auto file = find_grid(name, folder);
  if (!file) section.refuse("system", no_such_grid(name));
  return read_grid_file(*file);
}

void check_conditions(const Table& section, const grid::Grid& grid) {
  const std::size_t rows =
      control_centre::conditions(grid::SfrModel(grid), grid.threshold_hz, grid.condition_row_hz)
          .size();
  if (rows <= gs::outlet::kMaxConditions) return;
  const Value* system = section.table("system");
  Position at = system->at;
  if (const auto* entries = std::get_if<Entries>(&system->data)) {
    for (const Entry& entry : *entries) {
      if (entry.key == "condition_row_hz") at = entry.value.at;
    }
  }
  section.refuse(at, fmt::format("rows of {} Hz make {} load-shedding conditions; an outlet keeps "
                                 "{} at most: condition_row_hz must be greater",
                                 grid.condition_row_hz, rows, gs::outlet::kMaxConditions));
}

}  // namespace gsbench::profile
