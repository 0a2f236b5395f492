#include <grid_test/example_grids.hpp>

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include <grid/sfr_model.hpp>

namespace gsbench::grid {
namespace {

using ::testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Grid grid_with_blocks() {
  Grid grid = ieee24();
  grid.blocks = {{"first", 50.0}, {"second", 60.0}};
  return grid;
}

struct Refusal {
  const char* name;
  void (*spoil)(Grid&);
  const char* field;
  int index;
  const char* message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) {
  *out << refusal.name;
}

class CheckRefuses : public ::testing::TestWithParam<Refusal> {};

TEST_P(CheckRefuses, NamingFieldValueAndWhatIsRight) {
  Grid grid = grid_with_blocks();
  ASSERT_NO_THROW(check(grid));
  GetParam().spoil(grid);
  try {
    check(grid);
    FAIL() << "accepted";
  } catch (const GridError& error) {
    EXPECT_EQ(error.field, GetParam().field);
    EXPECT_EQ(error.index, GetParam().index);
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
  }
  EXPECT_THROW(SfrModel{grid}, GridError) << "the model must not be made of such a grid";
}

const Refusal kRefusals[] = {
    {"NominalZero", [](Grid& g) { g.nominal_hz = 0.0; }, "system.nominal_hz", -1,
     "nominal_hz is 0: must be from 0.001 to 1000"},
    {"NominalInfinite", [](Grid& g) { g.nominal_hz = kInfinity; }, "system.nominal_hz", -1,
     "nominal_hz is inf: must be"},
    {"ThresholdZero", [](Grid& g) { g.threshold_hz = 0.0; }, "system.threshold_hz", -1,
     "threshold_hz is 0: must be from "},
    {"ThresholdNaN", [](Grid& g) { g.threshold_hz = kNaN; }, "system.threshold_hz", -1,
     "threshold_hz is nan: must be"},
    {"ThresholdAtNominal", [](Grid& g) { g.threshold_hz = 50.0; }, "system.threshold_hz", -1,
     "threshold_hz is 50: must be below nominal_hz, 50"},
    {"ThresholdAboveNominal", [](Grid& g) { g.threshold_hz = 50.5; }, "system.threshold_hz", -1,
     "threshold_hz is 50.5: must be below nominal_hz, 50"},
    {"BaseZero", [](Grid& g) { g.base_mw = 0.0; }, "system.base_mw", -1,
     "base_mw is 0: must be from "},
    {"BaseInWatts", [](Grid& g) { g.base_mw = 2745e6; }, "system.base_mw", -1,
     "base_mw is 2745000000: must be from 1e-06 to 10000000"},
    {"LoadNegative", [](Grid& g) { g.load_mw = -5.0; }, "system.load_mw", -1,
     "load_mw is -5: must be from "},
    {"DampingNegative", [](Grid& g) { g.damping_pu = -0.1; }, "system.damping_pu", -1,
     "damping_pu is -0.1: must be from 0 to 1000"},
    {"DampingNaN", [](Grid& g) { g.damping_pu = kNaN; }, "system.damping_pu", -1,
     "damping_pu is nan: must be from 0"},
    {"GainZero", [](Grid& g) { g.gain_km = 0.0; }, "system.gain_km", -1,
     "gain_km is 0: must be from "},
    {"ReheatFractionNegative", [](Grid& g) { g.reheat_fraction = -0.01; }, "system.reheat_fraction",
     -1, "reheat_fraction is -0.01: must be from 0 to 1"},
    {"ReheatFractionInPercent", [](Grid& g) { g.reheat_fraction = 30.0; }, "system.reheat_fraction",
     -1, "reheat_fraction is 30: must be from 0 to 1"},
    {"ReheatTimeZero", [](Grid& g) { g.reheat_s = 0.0; }, "system.reheat_s", -1,
     "reheat_s is 0: must be from "},
    {"ReheatTimeInMilliseconds", [](Grid& g) { g.reheat_s = 8000.0; }, "system.reheat_s", -1,
     "reheat_s is 8000: must be from 0.001 to 1000"},
    {"RowTooLow", [](Grid& g) { g.condition_row_hz = 0.0009; }, "system.condition_row_hz", -1,
     "condition_row_hz is 0.0009: must be from 0.001"},
    {"NoPlant", [](Grid& g) { g.plants.clear(); }, "plant", -1, "no plant"},
    {"RatingZero", [](Grid& g) { g.plants[3].rating_mw = 0.0; }, "plant.rating_mw", 3,
     "plant 4 \"other bus\": rating_mw is 0: must be from "},
    {"InertiaZero", [](Grid& g) { g.plants[0].inertia_s = 0.0; }, "plant.inertia_s", 0,
     "plant 1 \"bus 1\": inertia_s is 0: must be from "},
    {"InertiaNegative", [](Grid& g) { g.plants[8].inertia_s = -9.3; }, "plant.inertia_s", 8,
     "inertia_s is -9.3: must be from "},
    {"InertiaNaN", [](Grid& g) { g.plants[1].inertia_s = kNaN; }, "plant.inertia_s", 1,
     "inertia_s is nan: must be from "},
    {"DroopZero", [](Grid& g) { g.plants[2].droop_pu = 0.0; }, "plant.droop_pu", 2,
     "droop_pu is 0: must be from 0.0001 to 10"},
    {"DroopGivenAsItsInverse", [](Grid& g) { g.plants[2].droop_pu = 22.0; }, "plant.droop_pu", 2,
     "droop_pu is 22: must be from 0.0001 to 10"},
    {"BlockWithoutPower", [](Grid& g) { g.blocks[1].power_mw = 0.0; }, "block.power_mw", 1,
     "block 2 \"second\": power_mw is 0: must be from "},
    {"BlocksBeyondTheLoad", [](Grid& g) { g.blocks[1].power_mw = 2696.0; }, "block.power_mw", 1,
     "power_mw is 2696: all blocks together must not exceed load_mw, 2745"},
    {"ReferenceNadirTimeNegative", [](Grid& g) { g.reference.t_nadir_s = -1.0; },
     "reference.t_nadir_s", -1, "t_nadir_s is -1: must be from "},
    {"ReferenceThresholdNaN", [](Grid& g) { g.reference.threshold_mw = kNaN; },
     "reference.threshold_mw", -1, "threshold_mw is nan: must be from "},
    {"ReferenceRowRising",
     [](Grid& g) {
       g.reference.condition_rocof_hz_s = {-0.3, 0.1};
     },
     "reference.condition_rocof_hz_s", 1, "reference row 2: condition_rocof_hz_s is 0.1: must be"},
};

INSTANTIATE_TEST_SUITE_P(EveryField, CheckRefuses, ::testing::ValuesIn(kRefusals),
                         [](const auto& refusal) { return std::string(refusal.param.name); });

TEST(Check, AcceptsAGridAtTheEdgesOfItsRanges) {
  Grid grid = ieee24();
  grid.damping_pu = 0.0;
  grid.reheat_fraction = 0.0;
  grid.condition_row_hz = 0.001;
  EXPECT_NO_THROW(check(grid));
  grid.reheat_fraction = 1.0;
  EXPECT_NO_THROW(check(grid));
}

TEST(Check, KeepsTheModelFiniteAtTheFarCornersOfItsRanges) {
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
