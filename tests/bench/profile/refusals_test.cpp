// Each slip in a profile's head, grid, signal and limits has its own message and exact place.
#include <profile_test/texts.hpp>

#include <gtest/gtest.h>

namespace gsbench::profile::test {
namespace {

class RefusesOfALossesProfile : public testing::TestWithParam<Spoilt> {};

TEST_P(RefusesOfALossesProfile, WithPlaceAndRemedy) {
  ASSERT_EQ(refusal(kLossesInPlace), "");
  EXPECT_EQ(refusal(replaced(kLossesInPlace, GetParam().what, GetParam().by)), GetParam().message);
}

class RefusesOfAMinimalProfile : public testing::TestWithParam<Spoilt> {};

TEST_P(RefusesOfAMinimalProfile, WithPlaceAndRemedy) {
  ASSERT_EQ(refusal(kMinimal), "");
  EXPECT_EQ(refusal(replaced(kMinimal, GetParam().what, GetParam().by)), GetParam().message);
}

class RefusesOfAPointsProfile : public testing::TestWithParam<Spoilt> {};

TEST_P(RefusesOfAPointsProfile, WithPlaceAndRemedy) {
  ASSERT_EQ(refusal(kPoints), "");
  EXPECT_EQ(refusal(replaced(kPoints, GetParam().what, GetParam().by)), GetParam().message);
}

std::string name_of(const testing::TestParamInfo<Spoilt>& info) {
  return info.param.name;
}

const Spoilt kHeadAndShape[] = {
    {"MalformedToml", "duration_s = 6.0", "duration_s = = 6.0",
     "test.toml:6:14: not well-formed TOML: Error while parsing value: could not determine value "
     "type"},
    {"KeyTwice", "max = 0", "max = 0\nmax = 1",
     "test.toml:11:7: not well-formed TOML: Error while parsing key-value pair: cannot redefine "
     "existing integer 'max'"},
    {"NoTitle", "title = \"A test\"", "",
     "test.toml:1:1: a profile lacks \"title\": a text in quotes"},
    {"EmptyTitle", "\"A test\"", "\"\"", "test.toml:1:9: title is an empty text"},
    {"UnknownKeyNearNone", "source", "colour = 1\nsource",
     "test.toml:2:1: unknown key \"colour\" in a profile; its keys are: title, source, seed, grid, "
     "signal, outlet, command, expect"},
    {"UnknownTable", "[[outlet]]", "[[oulet]]",
     "test.toml:7:3: unknown key \"oulet\" in a profile; did you mean \"outlet\"?"},
    {"NoGrid", "[grid]\nsystem = \"ieee24\"", "",
     "test.toml:1:1: a profile lacks \"grid\": the power system: [grid] system = \"ieee24\""},
    {"NoSystem", "system = \"ieee24\"", "",
     "test.toml:3:1: [grid] lacks \"system\": a grid's name (\"ieee24\"), its path, or "
     "[grid.system]"},
    {"UnknownGrid", "ieee24", "ieee25",
     "test.toml:4:10: no grid \"ieee25\"; did you mean \"ieee24\"? (a file of your own is given by "
     "its path, ending in .toml)"},
    {"UnknownGridFile", "ieee24", "ieee24.toml",
     "test.toml:4:10: no grid \"ieee24.toml\"; shipped grids are: ieee24, ieee24-by-unit, "
     "island-60hz (a file of your own is given by its path, ending in .toml)"},
    {"SystemOfWrongType", "\"ieee24\"", "24",
     "test.toml:4:10: system is 24; it must be a text in quotes"},
    {"BlockBesideANamedGrid", "[signal]", "[[grid.block]]\nid = \"a\"\npower_mw = 1\n[signal]",
     "test.toml:5:1: block belongs to a grid in place ([grid.system]); this profile takes the grid "
     "\"ieee24\""},
    {"NoSignal", "[signal]\nduration_s = 6.0", "",
     "test.toml:1:1: a profile lacks \"signal\": what is played: [signal] duration_s = …"},
    {"SignalIsNoTable", "[signal]\nduration_s = 6.0", "[[signal]]\nduration_s = 6.0",
     "test.toml:5:1: [signal] must be a table, not an array"},
    {"NoOutlet", "[[outlet]]", "",
     "test.toml:1:1: a profile lacks \"outlet\": at least one [[outlet]]"},
    {"OutletIsNoArray", "[[outlet]]", "[outlet]",
     "test.toml:7:1: outlet is a table; it must be an array of tables"},
    {"NoExpectation", "[[expect]]\nmeasure = \"event.count\"\nmax = 0", "",
     "test.toml:1:1: a profile lacks \"expect\": at least one [[expect]]: a run without limits "
     "proves nothing"},
    {"UnknownMeasure", "event.count", "event.cuont",
     "test.toml:9:11: unknown measure \"event.cuont\"; did you mean \"event.count\"?"},
    {"UnitForAPlainNumber", "max = 0", "max = 0\nunit = \"s\"",
     "test.toml:11:8: event.count has no unit; leave it out"},
    {"NoLimit", "max = 0", "",
     "test.toml:8:1: [[expect]] lacks \"min\": min, max or both, of event.count"},
    {"EqualsForANumber", "max = 0", "equals = \"0\"",
     "test.toml:10:10: event.count is a number; it takes min and max"},
};
INSTANTIATE_TEST_SUITE_P(HeadAndShape, RefusesOfAMinimalProfile, testing::ValuesIn(kHeadAndShape),
                         name_of);

const Spoilt kSignal[] = {
    {"NoDuration", "duration_s = 6.0", "",
     "test.toml:5:1: [signal] lacks \"duration_s\": the length of the run, in seconds"},
    {"TextForANumber", "6.0", "\"6 s\"",
     "test.toml:6:14: duration_s is the text \"6 s\"; it must be a plain number, in the unit that "
     "its name says"},
    {"SampleRateWithoutWhole16Ms", "6.0", "6.0\nsample_rate_hz = 11025",
     "test.toml:7:18: sample_rate_hz is 11025: 16 ms is no whole number of samples; it must be a "
     "multiple of 1000"},
    {"SampleRateWithoutWhole1Ms", "6.0", "6.0\nsample_rate_hz = 12500",
     "test.toml:7:18: sample_rate_hz is 12500: 1 ms is no whole number of samples; it must be a "
     "multiple of 1000"},
    {"SampleRateNotWhole", "6.0", "6.0\nsample_rate_hz = 8000.0",
     "test.toml:7:18: sample_rate_hz is 8000.0; it must be a whole number from 1000 to 32000"},
};
INSTANTIATE_TEST_SUITE_P(Signal, RefusesOfAMinimalProfile, testing::ValuesIn(kSignal), name_of);

const Spoilt kDisturbances[] = {
    {"HarmonicRowTooShort", "[28, 1.0, -10.0]", "[28, 1.0]",
     "test.toml:43:31: an item of harmonics is an array of 2 values; it must be [order, "
     "pct, deg]"},
    {"HarmonicRowNoArray", "[28, 1.0, -10.0]", "28",
     "test.toml:43:31: an item of harmonics is 28; it must be [order, pct, deg]"},
    {"HarmonicOrderNotWhole", "[28,", "[2.5,",
     "test.toml:43:32: order is 2.5; it must be a whole number from 2 to 50"},
    {"HarmonicOrderTwice", "[28,", "[26,", "test.toml:43:32: order 26 is there twice"},
    {"HarmonicOrderInTheSet", "[28,", "[5,", "test.toml:43:32: order 5 is there twice"},
    {"HarmonicAboveHalfTheSampleRate", "[28,", "[34,",
     "test.toml:43:32: order 34 lies at 2040 Hz, not below half of sample_rate_hz"},
    {"HarmonicAmplitudeNegative", "1.0, -10.0", "-1.0, -10.0",
     "test.toml:43:36: pct is -1; it must be at least 0 and at most 100"},
    {"HarmonicPhaseBeyondATurn", "-10.0", "-370.0",
     "test.toml:43:41: deg is -370; it must be at least -360 and at most 360"},
    {"NoHarmonicInTheList", "[[26, 5.0, 90.0], [28, 1.0, -10.0]]", "[]",
     "test.toml:43:13: harmonics is empty; leave it out, or give an array of [order, pct, deg]"},
    // The figures are those of sin θ + Σ a sin(kθ + φ) over a period, worked out elsewhere.
    {"StepAboveFullScale", "level_pct = 40.0", "level_pct = 140.0",
     "test.toml:47:1: the voltage reaches 1.587 pu (at 5 s, with harmonics and offset); a source "
     "plays 1.5 pu at most"},
    {"StepsAboveFullScaleTogether", "at_s = 8.0\nlevel_pct = 0.0",
     "at_s = 6.0\nlevel_pct = 130.0\n[[signal.amplitude_step]]\nat_s = 7.0\nlevel_pct = 110",
     "test.toml:51:1: the voltage reaches 1.62 pu (at 7 s, with harmonics and offset); a source "
     "plays 1.5 pu at most"},
    {"HarmonicsAboveFullScale", "5.0, 90.0", "60.0, 90.0",
     "test.toml:43:13: the voltage reaches 1.682 pu (at 0 s, with harmonics and offset); a source "
     "plays 1.5 pu at most"},
    {"OffsetAboveFullScale", "dc_offset_pct = 0.25", "dc_offset_pct = -90",
     "test.toml:45:17: the voltage reaches 1.951 pu (at 0 s, with harmonics and offset); a source "
     "plays 1.5 pu at most"},
    {"StepAfterTheEnd", "at_s = 8.0", "at_s = 10.0",
     "test.toml:52:8: at_s is 10; it must be at least 0 and below 10 (the run's duration)"},
    {"StepEndsAfterTheEnd", "duration_s = 1.5", "duration_s = 5.5",
     "test.toml:49:14: the step ends at 10.5 s, after the run's 10 s; leave duration_s out for a "
     "step that lasts to the end"},
    {"StepWithoutLevel", "level_pct = 40.0", "",
     "test.toml:47:1: [[signal.amplitude_step]] lacks \"level_pct\": a number must be given: at "
     "least 0 and at most 150"},
    {"JumpAfterTheEnd", "at_s = 3.0", "at_s = 12.0",
     "test.toml:55:8: at_s is 12; it must be at least 0 and below 10 (the run's duration)"},
    {"LossAfterTheEnd", "at_s = 4.0", "at_s = 40.0",
     "test.toml:34:8: at_s is 40; it must be at least 0 and below 10 (the run's duration)"},
    {"LossOfNothing", "power_mw = 100.0", "power_mw = 0",
     "test.toml:38:12: power_mw is 0: no loss at all; leave it out"},
    {"LossAboveTheLoad", "power_mw = 100.0", "power_mw = 900",
     "test.toml:38:12: power_mw is 900; it must be at least -800 and at most 800 (the grid's "
     "load)"},
    {"LossesAboveTheLoadInSum", "power_mw = -50.0", "power_mw = 750.0",
     "test.toml:33:1: the losses add up to 850 MW by 4 s, more than the grid's load of 800 MW"},
    {"LossesAndPoints", "harmonic_set", "frequency = [[0, 60]]\nharmonic_set",
     "test.toml:44:13: the frequency comes from [[grid.loss]], from frequency points or from a "
     "recording; this profile gives more than one of them"},
    {"LossesAndRecording", "[[signal.phase_jump]]",
     "[signal.trace]\nfile = \"r\"\ntime = \"t\"\nfrequency = \"f\"\n[[signal.phase_jump]]",
     "test.toml:54:1: the frequency comes from [[grid.loss]], from frequency points or from a "
     "recording; this profile gives more than one of them"},
};
INSTANTIATE_TEST_SUITE_P(Disturbances, RefusesOfALossesProfile, testing::ValuesIn(kDisturbances),
                         name_of);

const Spoilt kCourse[] = {
    {"TimesThatDoNotAscend", "[6.0, 49.8]", "[2.0, 49.8]",
     "test.toml:7:41: t_s is 2 after 2; times must ascend"},
    {"PointAfterTheEnd", "[6.0, 49.8]", "[6.5, 49.8]",
     "test.toml:7:41: t_s is 6.5; it must be at least 0 and at most 6 (the run's duration)"},
    {"PointFarFromNominal", "[2.0, 49.5]", "[2.0, 4.95]",
     "test.toml:7:33: hz is 4.95; it must be at least 25 and at most 75"},
    {"PointWithAText", "[2.0, 49.5]", "[2.0, \"49.5\"]",
     "test.toml:7:33: hz is the text \"49.5\"; it must be a plain number, in the unit "
     "that its name says"},
    {"PointsAndRecording", "[[outlet]]",
     "[signal.trace]\nfile = \"r\"\ntime = \"t\"\nfrequency = \"f\"\n[[outlet]]",
     "test.toml:8:1: the frequency comes from [[grid.loss]], from frequency points or from a "
     "recording; this profile gives more than one of them"},
};
INSTANTIATE_TEST_SUITE_P(Course, RefusesOfAPointsProfile, testing::ValuesIn(kCourse), name_of);

const Spoilt kLimits[] = {
    {"UnitOfAnotherDimension", "unit = \"s\"", "unit = \"MW\"",
     "test.toml:83:8: event.delay is not in \"MW\"; its unit must be s or ms or us"},
    {"UnknownUnit", "unit = \"s\"", "unit = \"seconds\"",
     "test.toml:83:8: event.delay is not in \"seconds\"; its unit must be s or ms or us"},
    {"NoUnit", "unit = \"s\"", "",
     "test.toml:81:1: [[expect]] lacks \"unit\": event.delay is in s or ms or us"},
    {"MinAboveMax", "min = 0.03", "min = 0.3",
     "test.toml:84:7: min is 0.3, above max 0.16: nothing could pass"},
    {"UnknownGroup", "outlets = [\"early\"]", "outlets = [\"erly\"]",
     "test.toml:86:12: no group \"erly\"; did you mean \"early\"?"},
    {"NoGroupInTheList", "outlets = [\"early\"]", "outlets = []",
     "test.toml:86:11: outlets is empty; leave it out, or give an array of texts in quotes"},
    {"GroupIsNoText", "outlets = [\"early\"]", "outlets = [1]",
     "test.toml:86:12: an item of outlets is 1; it must be a text in quotes"},
    {"LimitForAWord", "equals = \"open\"", "max = 1",
     "test.toml:89:7: relay.end is a word, not a number; it takes equals"},
    {"NoWord", "equals = \"open\"", "",
     "test.toml:87:1: [[expect]] lacks \"equals\": the word that relay.end must be"},
    {"UnknownWord", "equals = \"open\"", "equals = \"opne\"",
     "test.toml:89:10: equals is \"opne\"; did you mean \"open\"?"},
};
INSTANTIATE_TEST_SUITE_P(Limits, RefusesOfALossesProfile, testing::ValuesIn(kLimits), name_of);

TEST(Nesting, OfTablesByDotsOrBracketsIsRefusedBeforeItCouldOverflowTheStack) {
  const auto repeated = [](const std::string& piece, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += piece;
    return text;
  };
  const std::string says = "tables within tables, 65 deep; 64 at most";
  EXPECT_EQ(refusal(repeated("a.", 50000) + "b = 1\n"), "test.toml:1:130: " + says);
  EXPECT_EQ(refusal("[" + repeated("a.", 50000) + "b]\n"), "test.toml:1:129: " + says);
  EXPECT_EQ(refusal("x = " + repeated("[", 50000)), "test.toml:1:69: " + says);
  EXPECT_EQ(refusal("x = " + repeated("{a = ", 50000)), "test.toml:1:325: " + says);
  EXPECT_EQ(refusal("x = 1\ny = " + repeated("{a.b.c = ", 50000)), "test.toml:2:196: " + says);
  // A long text that ends in a quote of its own.
  EXPECT_EQ(refusal(R"(x = ["""q"""", )" + repeated("[", 50000)), "test.toml:1:79: " + says);
}

TEST(Nesting, CountsNoDotsOrBracketsOfTextsCommentsAndNumbers) {
  const std::string dots(1000, '.');
  const std::string brackets(1000, '[');
  const std::string escaped = "\\\"" + dots;
  const auto titled = [](const std::string& title) {
    return replaced(kMinimal, "\"A test\"", title);
  };
  EXPECT_EQ(refusal(titled("\"" + dots + brackets + escaped + "\"  # " + dots + brackets)), "");
  EXPECT_EQ(refusal(titled("'" + dots + brackets + "'")), "");
  EXPECT_EQ(refusal(titled("\"\"\"" + dots + "\n\"" + brackets + "\"\"\"")), "");
  std::string points = "duration_s = 6.0\nfrequency = [";
  for (int i = 0; i < 500; ++i) {
    points += "[" + std::to_string(0.01 * i) + ", 50.0],\n";
  }
  EXPECT_EQ(refusal(replaced(kMinimal, "duration_s = 6.0", points + "]")), "");
}

}  // namespace
}  // namespace gsbench::profile::test
