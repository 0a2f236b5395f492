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
    {"NoneOfThem", "count = 3", "count = 0",
     "test.toml:58:9: count is 0; it must be a whole number from 1 to 1000"},
    {"TooMany", "count = 3", "count = 1001",
     "test.toml:58:9: count is 1001; it must be a whole number from 1 to 1000"},
    {"TooManyInSum", "count = 2", "count = 998", "test.toml:72:1: more than 1000 outlets in all"},
    {"SameIdTwice", "id = \"alone\"", "id = \"shed-2\"",
     "test.toml:71:6: there is an outlet \"shed-2\" already; give this one another id"},
    {"IdWithABlank", "id = \"alone\"", "id = \"all alone\"",
     "test.toml:71:6: id is \"all alone\"; it must be of letters, digits, '-', '_' and '.', at "
     "most 64 of them"},
    {"EmptyId", "id = \"alone\"", "id = \"\"", "test.toml:71:6: id is an empty text"},
    {"NegativeAccumulated", "accumulated_mw = 100.0", "accumulated_mw = -1",
     "test.toml:61:18: accumulated_mw is -1; it must be at least 0 and at most 800 (the grid's "
     "load)"},
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
    {"ThresholdZero", "threshold_mw = 200.0", "threshold_mw = 0",
     "test.toml:63:16: threshold_mw is 0; it must be at least 1e-06 and at most 10000000"},
    {"ThresholdBelowAnyPower", "threshold_mw = 200.0", "threshold_mw = 1e-300",
     "test.toml:63:16: threshold_mw is 1e-300; it must be at least 1e-06 and at most 10000000"},
    {"ThresholdAboveAnyPower", "threshold_mw = 200.0", "threshold_mw = 1e300",
     "test.toml:63:16: threshold_mw is 1e+300; it must be at least 1e-06 and at most 10000000"},
    {"SwitchOffAtNominalInSinglePrecision", "switch_off_hz = 58.5", "switch_off_hz = 59.9999999",
     "test.toml:64:17: switch_off_hz is 59.9999999; in the outlets' single precision that is "
     "nominal_hz itself"},
    {"SwitchOffAtNominal", "switch_off_hz = 58.5", "switch_off_hz = 60",
     "test.toml:64:17: switch_off_hz is 60; it must be at least 48 and below 60 (the grid's "
     "nominal_hz)"},
    {"SwitchOffFarBelow", "switch_off_hz = 58.5", "switch_off_hz = 47.9",
     "test.toml:64:17: switch_off_hz is 47.9; it must be at least 48 and below 60 (the grid's "
     "nominal_hz)"},
    {"DropZero", "event_drop_hz = 0.03", "event_drop_hz = 0",
     "test.toml:65:17: event_drop_hz is 0; it must be above 0 and at most 1"},
    {"DropInMillihertz", "event_drop_hz = 0.03", "event_drop_hz = 30",
     "test.toml:65:17: event_drop_hz is 30; it must be above 0 and at most 1"},
    {"DepartureZero", "event_departure_hz = 0.04", "event_departure_hz = 0",
     "test.toml:66:22: event_departure_hz is 0; it must be above 0 and at most 1"},
    {"HitsNotWhole", "condition_hits = 12", "condition_hits = 12.5",
     "test.toml:67:18: condition_hits is 12.5; it must be a whole number from 0 to 1000"},
    {"SlopeOfOneSample", "lse_samples = 8", "lse_samples = 1",
     "test.toml:68:15: lse_samples is 1; it must be a whole number from 2 to 64"},
    {"TooManyEkfSamples", "ekf_samples = 30", "ekf_samples = 201",
     "test.toml:69:15: ekf_samples is 201; it must be a whole number from 1 to 200"},
    {"UnknownSetting", "ekf_samples = 30", "ekf_sample = 30",
     "test.toml:69:1: unknown key \"ekf_sample\" in [[outlet]]; did you mean \"ekf_samples\"?"},
};
INSTANTIATE_TEST_SUITE_P(Outlets, Refuses, testing::ValuesIn(kOutlets), name_of);

const Spoilt kCommands[] = {
    {"AfterTheEnd", "[[command]]\nat_s = 7.0", "[[command]]\nat_s = 10.5",
     "test.toml:75:8: at_s is 10.5; it must be at least 0 and below 10 (the run's duration)"},
    {"UnknownOutlet", "\"alone\", \"early\"", "\"alone\", \"shed-4\"",
     "test.toml:76:21: no outlet or group \"shed-4\"; did you mean \"shed-1\"?"},
    {"NobodyNamed", "[\"alone\", \"early\"]", "[]",
     "test.toml:76:11: outlets is empty; leave it out, or give an array of texts"},
    {"OutletsIsAText", "[\"alone\", \"early\"]", "\"alone\"",
     "test.toml:76:11: outlets is the text \"alone\"; it must be an array of texts"},
    {"UnknownPosition", "switch = \"off\"", "switch = \"of\"",
     "test.toml:80:10: switch is \"of\"; did you mean \"off\"?"},
    {"NoPosition", "switch = \"off\"", "",
     "test.toml:78:1: [[command]] lacks \"switch\": \"off\" or \"on\""},
};
INSTANTIATE_TEST_SUITE_P(Commands, Refuses, testing::ValuesIn(kCommands), name_of);

const Spoilt kGrids[] = {
    {"NoBase", "base_mw = 900.0", "",
     "test.toml:4:1: [system] lacks \"base_mw\": a number must be given: a finite number"},
    {"NominalThatNoOutletIsMadeFor", "nominal_hz = 60.0", "nominal_hz = 55.0",
     "test.toml:5:14: nominal_hz is 55; outlets are made for 50 and for 60"},
    {"MoreConditionsThanOutletsKeep", "condition_row_hz = 0.1", "condition_row_hz = 0.02",
     "test.toml:13:20: rows of 0.02 Hz make 35 load-shedding conditions; an outlet keeps 32 at "
     "most: condition_row_hz must be greater"},
    {"NegativeDamping", "damping_pu = 1.5", "damping_pu = -1.5",
     "test.toml:9:14: damping_pu is -1.5: must be from 0 to 1000"},
    {"ThresholdAboveNominal", "threshold_hz = 59.3", "threshold_hz = 60.5",
     "test.toml:6:16: threshold_hz is 60.5: must be below nominal_hz, 60"},
    {"NoInertia", "inertia_s = 5.0", "inertia_s = 0",
     "test.toml:22:13: plant 2 \"two\": inertia_s is 0: must be from 0.001 to 1000"},
    {"DroopNegative", "droop_pu = 0.04", "droop_pu = -0.04",
     "test.toml:23:12: plant 2 \"two\": droop_pu is -0.04: must be from 0.0001 to 10"},
    {"InverseDroopZero", "inverse_droop_pu = 20.0", "inverse_droop_pu = 0",
     "test.toml:18:20: inverse_droop_pu is 0; it must be above 0"},
    {"InverseDroopFarOff", "inverse_droop_pu = 20.0", "inverse_droop_pu = 1e9",
     "test.toml:18:20: plant 1 \"one\": droop_pu is 1e-09: must be from 0.0001 to 10"},
    {"DroopTwice", "droop_pu = 0.04", "droop_pu = 0.04\ninverse_droop_pu = 25",
     "test.toml:23:12: give droop_pu or inverse_droop_pu, not both"},
    {"NoDroop", "droop_pu = 0.04", "",
     "test.toml:19:1: [[plant]] lacks \"droop_pu\": a number, or inverse_droop_pu"},
    {"BlockOfNoPower", "power_mw = 30.0", "power_mw = 0",
     "test.toml:26:12: block 1 \"least\": power_mw is 0: must be from 1e-06 to 10000000"},
    {"ReferenceRowNotANumber", "[-0.5, 0.0]", "[-0.5, inf]",
     "test.toml:31:31: condition_rocof_hz_s is inf; it must be a finite number"},
    {"UnknownKeyOfAPlant", "rating_mw = 400.0", "rating_mva = 400.0",
     "test.toml:21:1: unknown key \"rating_mva\" in [[plant]]; did you mean \"rating_mw\"?"},
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
