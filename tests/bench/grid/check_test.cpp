#include <grid_test/example_grids.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <grid/sfr_model.hpp>

namespace gsbench::grid {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Grid grid_with_blocks() {
  Grid grid = ieee24();
  grid.blocks = {{"first", 50.0}, {"second", 60.0}};
  return grid;
}

struct Refusal {
  void (*spoil)(Grid&);
  const char* field;
  const char* message;  // a part of it
  int index = -1;
};

const Refusal kRefusals[] = {
    {[](Grid& g) { g.nominal_hz = 0.0; }, "system.nominal_hz",
     "is 0; it must be from 0.001 to 1000"},
    {[](Grid& g) { g.nominal_hz = kInfinity; }, "system.nominal_hz", "is inf; it must be"},
    {[](Grid& g) { g.threshold_hz = 0.0; }, "system.threshold_hz", "is 0; it must be from "},
    {[](Grid& g) { g.threshold_hz = kNaN; }, "system.threshold_hz", "is nan; it must be"},
    {[](Grid& g) { g.threshold_hz = 50.0; }, "system.threshold_hz",
     "is 50; it must be below 50 (nominal_hz)"},
    {[](Grid& g) { g.threshold_hz = 50.5; }, "system.threshold_hz",
     "is 50.5; it must be below 50 (nominal_hz)"},
    {[](Grid& g) { g.base_mw = 0.0; }, "system.base_mw", "is 0; it must be from "},
    {[](Grid& g) { g.base_mw = 2745e6; }, "system.base_mw",
     "is 2745000000; it must be from 1e-06 to 10000000"},
    {[](Grid& g) { g.load_mw = -5.0; }, "system.load_mw", "is -5; it must be from "},
    {[](Grid& g) { g.credible_loss_mw = 0.0; }, "system.credible_loss_mw",
     "is 0; it must be from 1e-06 to 10000000"},
    {[](Grid& g) { g.credible_loss_mw = 2746.0; }, "system.credible_loss_mw",
     "is 2746; it must be at most 2745 (base_mw)"},
    {[](Grid& g) { g.damping_pu = -0.1; }, "system.damping_pu",
     "is -0.1; it must be from 0 to 1000"},
    {[](Grid& g) { g.damping_pu = kNaN; }, "system.damping_pu", "is nan; it must be from 0"},
    {[](Grid& g) { g.gain_km = 0.0; }, "system.gain_km", "is 0; it must be from "},
    {[](Grid& g) { g.reheat_fraction = -0.01; }, "system.reheat_fraction",
     "is -0.01; it must be from 0 to 1"},
    {[](Grid& g) { g.reheat_fraction = 30.0; }, "system.reheat_fraction",
     "is 30; it must be from 0 to 1"},
    {[](Grid& g) { g.reheat_s = 0.0; }, "system.reheat_s", "is 0; it must be from "},
    {[](Grid& g) { g.reheat_s = 8000.0; }, "system.reheat_s",
     "is 8000; it must be from 0.001 to 1000"},
    {[](Grid& g) { g.condition_row_hz = 0.0009; }, "system.condition_row_hz",
     "is 0.0009; it must be from 0.001"},
    {[](Grid& g) { g.plants[3].rating_mw = 0.0; }, "plant.rating_mw",
     "plant 4 \"other bus\": rating_mw is 0; it must be from ", 3},
    {[](Grid& g) { g.plants[0].inertia_s = 0.0; }, "plant.inertia_s",
     "plant 1 \"bus 1\": inertia_s is 0; it must be from ", 0},
    {[](Grid& g) { g.plants[8].inertia_s = -9.3; }, "plant.inertia_s",
     "inertia_s is -9.3; it must be from ", 8},
    {[](Grid& g) { g.plants[1].inertia_s = kNaN; }, "plant.inertia_s",
     "inertia_s is nan; it must be from ", 1},
    {[](Grid& g) { g.plants[2].droop_pu = 0.0; }, "plant.droop_pu",
     "droop_pu is 0; it must be from 0.0001 to 10", 2},
    {[](Grid& g) { g.plants[2].droop_pu = 22.0; }, "plant.droop_pu",
     "droop_pu is 22; it must be from 0.0001 to 10", 2},
    {[](Grid& g) { g.blocks[1].power_mw = 0.0; }, "block.power_mw",
     "block 2 \"second\": power_mw is 0; it must be from ", 1},
    {[](Grid& g) { g.blocks[1].power_mw = 2696.0; }, "block.power_mw",
     "power_mw is 2696; it must be at most 2695, so that all blocks together do not exceed 2745 "
     "(load_mw)",
     1},
    {[](Grid& g) { g.reference.t_nadir_s = -1.0; }, "reference.t_nadir_s",
     "is -1; it must be from "},
    {[](Grid& g) { g.reference.threshold_mw = kNaN; }, "reference.threshold_mw",
     "is nan; it must be from "},
    {[](Grid& g) {
       g.reference.condition_rocof_hz_s = {-0.3, 0.1};
     },
     "reference.condition_rocof_hz_s", "reference row 2: condition_rocof_hz_s is 0.1; it must be",
     1},
};

TEST(Check, RefusesWithFieldValueAndValidRange) {
  for (const auto& [spoil, field, message, index] : kRefusals) {
    Grid grid = grid_with_blocks();
    ASSERT_NO_THROW(check(grid));
    spoil(grid);
    const std::string name = std::string(field).substr(std::string(field).find('.') + 1);
    const auto checked = [&grid] { check(grid); };
    expect_refused(checked, field, index, name + " is ");
    expect_refused(checked, field, index, message);
    EXPECT_THROW(SfrModel{grid}, GridError) << "the model must refuse the grid, too";
  }
}

TEST(Check, RefusesAGridWithoutPlants) {
  Grid grid = ieee24();
  grid.plants.clear();
  expect_refused([&] { check(grid); }, "plant", -1, "has no plant");
}

TEST(Check, AcceptsValuesAtTheEndsOfTheRanges) {
  Grid grid = ieee24();
  grid.damping_pu = 0.0;
  grid.reheat_fraction = 0.0;
  grid.condition_row_hz = 0.001;
  EXPECT_NO_THROW(check(grid));
  grid.reheat_fraction = 1.0;
  EXPECT_NO_THROW(check(grid));
}

TEST(Check, KeepsTheModelFiniteAtTheEndsOfTheRanges) {
  for (const double inertia_s : {1e-3, 1000.0}) {
    for (const double droop_pu : {1e-4, 10.0}) {
      for (const double reheat_s : {1e-3, 1000.0}) {
        Grid grid = ieee24();
        grid.reheat_s = reheat_s;
        for (Plant& plant : grid.plants) {
          plant.inertia_s = inertia_s;
          plant.droop_pu = droop_pu;
        }
        EXPECT_TRUE(std::isfinite(SfrModel(grid).unit_deviation_hz(1.0)))
            << inertia_s << ' ' << droop_pu << ' ' << reheat_s;
      }
    }
  }
}

}  // namespace
}  // namespace gsbench::grid
