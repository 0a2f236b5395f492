// Each slip in outlets, commands and a grid in place has its own message and exact place.
#include <profile_test/texts.hpp>

#include <gtest/gtest.h>

namespace gsbench::profile::test {
namespace {

class Refuses : public testing::TestWithParam<Spoilt> {};

TEST_P(Refuses, WithPlaceAndRemedy) {
  ASSERT_EQ(refusal(kLossesInPlace), "");
  EXPECT_EQ(refusal(replaced(kLossesInPlace, GetParam().what, GetParam().by)), GetParam().message);
}

std::string name_of(const testing::TestParamInfo<Spoilt>& info) {
  return info.param.name;
}

const Spoilt kOutlets[] = {
    {"TooManyInSum", "count = 2", "count = 998", "test.toml:72:1: more than 1000 outlets in all"},
    {"SameIdTwice", "id = \"alone\"", "id = \"shed-2\"",
     "test.toml:71:6: there is an outlet \"shed-2\" already; give this one another id"},
    {"IdWithABlank", "id = \"alone\"", "id = \"all alone\"",
     "test.toml:71:6: id is \"all alone\"; it must be of letters, digits, '-', '_' and '.', at "
     "most 64 of them"},
    {"AccumulatedAboveTheLoad", "accumulated_mw = 100.0", "accumulated_mw = 801",
     "test.toml:61:18: accumulated_mw is 801; it must be at least 0 and at most 800 (the grid's "
     "load)"},
    {"PowerAboveTwiceAccumulated", "power_mw = 40.0", "power_mw = 240.0",
     "test.toml:62:12: power_mw is 240; it must be above 0 and at most 200 (twice accumulated_mw, "
     "which counts half of the outlet's own block)"},
    {"RefusedByTheFirmware", "id = \"alone\"", "id = \"alone\"\naccumulated_mw = 300.0",
     "test.toml:70:1: the firmware refuses these settings: switching-off frequency not from 80 % "
     "of "
     "nominal to below nominal"},
    {"ThresholdBelowAnyPower", "threshold_mw = 200.0", "threshold_mw = 1e-300",
     "test.toml:63:16: threshold_mw is 1e-300; in the outlets' single precision that is 0, which "
     "is out of its "
     "range"},
    {"SwitchOffAtNominalInSinglePrecision", "switch_off_hz = 58.5", "switch_off_hz = 59.9999999",
     "test.toml:64:17: switch_off_hz is 59.9999999; in the outlets' single precision that is 60, "
     "which is out of its range"},
    {"SwitchOffAtNominal", "switch_off_hz = 58.5", "switch_off_hz = 60",
     "test.toml:64:17: switch_off_hz is 60; it must be at least 48 and below 60 (the grid's "
     "nominal_hz)"},
    {"SwitchOffFarBelow", "switch_off_hz = 58.5", "switch_off_hz = 47.9",
     "test.toml:64:17: switch_off_hz is 47.9; it must be at least 48 and below 60 (the grid's "
     "nominal_hz)"},
};
INSTANTIATE_TEST_SUITE_P(Outlets, Refuses, testing::ValuesIn(kOutlets), name_of);

const Spoilt kCommands[] = {
    {"AfterTheEnd", "[[command]]\nat_s = 7.0", "[[command]]\nat_s = 10.5",
     "test.toml:75:8: at_s is 10.5; it must be at least 0 and below 10 (the run's duration)"},
    {"UnknownOutlet", "\"alone\", \"early\"", "\"alone\", \"shed-4\"",
     "test.toml:76:21: no outlet or group \"shed-4\"; did you mean \"shed-1\"?"},
    {"NobodyNamed", "[\"alone\", \"early\"]", "[]",
     "test.toml:76:11: outlets is empty; leave it out, or give an array of texts in quotes"},
    {"NoPosition", "switch = \"off\"", "",
     "test.toml:78:1: [[command]] lacks \"switch\": \"off\" or \"on\""},
};
INSTANTIATE_TEST_SUITE_P(Commands, Refuses, testing::ValuesIn(kCommands), name_of);

const Spoilt kGrids[] = {
    {"NominalThatNoOutletIsMadeFor", "nominal_hz = 60.0", "nominal_hz = 55.0",
     "test.toml:5:14: nominal_hz is 55; outlets are made for 50 and for 60"},
    {"MoreConditionsThanOutletsKeep", "condition_row_hz = 0.1", "condition_row_hz = 0.02",
     "test.toml:13:20: rows of 0.02 Hz make 35 load-shedding conditions; an outlet keeps 32 at "
     "most: condition_row_hz must be greater"},
    {"ThresholdAboveNominal", "threshold_hz = 59.3", "threshold_hz = 60.5",
     "test.toml:6:16: threshold_hz is 60.5: must be below nominal_hz, 60"},
    {"DroopTwice", "droop_pu = 0.04", "droop_pu = 0.04\ninverse_droop_pu = 25",
     "test.toml:23:12: give droop_pu or inverse_droop_pu, not both"},
    {"NoDroop", "droop_pu = 0.04", "",
     "test.toml:19:1: [[grid.plant]] lacks \"droop_pu\": a number, or inverse_droop_pu"},
    {"ReferenceRowNotANumber", "[-0.5, 0.0]", "[-0.5, inf]",
     "test.toml:31:31: an item of condition_rocof_hz_s is inf; it must be at least -1000 and "
     "at most 0"},
};
INSTANTIATE_TEST_SUITE_P(Grids, Refuses, testing::ValuesIn(kGrids), name_of);

TEST(Refuses, AGridWithoutPlants) {
  std::string text = kLossesInPlace;
  const auto first = text.find("[[grid.plant]]");
  text.erase(first, text.find("[[grid.block]]") - first);
  EXPECT_EQ(refusal(text), "test.toml:4:1: no plant: a grid must have at least one in operation");
}

}  // namespace
}  // namespace gsbench::profile::test
