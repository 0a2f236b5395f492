// Each slip in a profile has its own message and exact place.
#include <profile_test/texts.hpp>

#include <vector>

#include <gmock/gmock.h>

namespace gsbench::profile::test {
namespace {

struct Slip {
  const char* what;     // is replaced …
  const char* by;       // … by this
  const char* message;  // line:column: what is wrong, and what would be right
};

void expect_refused(const std::string& text, const std::vector<Slip>& slips) {
  ASSERT_EQ(refusal(text), "");
  for (const auto& [what, by, message] : slips) {
    EXPECT_EQ(refusal(replaced(text, what, by)), std::string("test.toml:") + message) << by;
  }
}

const std::vector<Slip> kOfMinimal = {
    {"duration_s = 6.0", "duration_s = = 6.0",
     "6:14: not well-formed TOML: Error while parsing value: could not determine value type"},
    {"max = 0", "max = 0\nmax = 1",
     "11:7: not well-formed TOML: Error while parsing key-value pair: cannot redefine existing "
     "integer 'max'"},
    {"title = \"A test\"", "", "1:1: a profile lacks \"title\": a text in quotes"},
    {"\"A test\"", "\"\"", "1:9: title is an empty text"},
    {"source", "colour = 1\nsource",
     "2:1: unknown key \"colour\" in a profile; its keys are: title, source, seed, grid, signal, "
     "outlet, command, expect"},
    {"[[outlet]]", "[[oulet]]",
     "7:3: unknown key \"oulet\" in a profile; did you mean \"outlet\"?"},
    {"[grid]\nsystem = \"ieee24\"", "",
     "1:1: a profile lacks \"grid\": the power system: [grid] system = \"ieee24\""},
    {"system = \"ieee24\"", "",
     "3:1: [grid] lacks \"system\": a grid's name (\"ieee24\"), its path, or [grid.system]"},
    {"ieee24", "ieee25",
     "4:10: no grid \"ieee25\"; did you mean \"ieee24\"? (a file of your own is given by its path, "
     "ending in .toml)"},
    {"ieee24", "ieee24.toml",
     "4:10: no grid \"ieee24.toml\"; shipped grids are: ieee24, ieee24-by-unit, island-60hz (a "
     "file of your own is given by its path, ending in .toml)"},
    {"\"ieee24\"", "24", "4:10: system is 24; it must be a text in quotes"},
    {"[signal]", "[[grid.block]]\nid = \"a\"\npower_mw = 1\n[signal]",
     "5:1: block belongs to a grid in place ([grid.system]); this profile takes the grid "
     "\"ieee24\""},
    {"[signal]\nduration_s = 6.0", "",
     "1:1: a profile lacks \"signal\": what is played: [signal] duration_s = …"},
    {"[signal]\nduration_s = 6.0", "[[signal]]\nduration_s = 6.0",
     "5:1: [signal] must be a table, not an array"},
    {"[[outlet]]", "", "1:1: a profile lacks \"outlet\": at least one [[outlet]]"},
    {"[[outlet]]", "[outlet]", "7:1: outlet is a table; it must be an array of tables"},
    {"[[expect]]\nmeasure = \"event.count\"\nmax = 0", "",
     "1:1: a profile lacks \"expect\": at least one [[expect]]: a run without limits proves "
     "nothing"},
    {"max = 0", "max = 0\nunit = \"s\"", "11:8: event.count has no unit; leave it out"},
    {"max = 0", "", "8:1: [[expect]] lacks \"min\": min, max or both, of event.count"},
    {"max = 0", "equals = \"0\"", "10:10: event.count is a number; it takes min and max"},
    {"duration_s", "duration",
     "6:1: unknown key \"duration\" in [signal]; did you mean \"duration_s\"?"},
    {"event.count", "tracker.eror.rms",
     "9:11: unknown measure \"tracker.eror.rms\"; did you mean \"tracker.error.rms\"?"},
    {"duration_s = 6.0", "",
     "5:1: [signal] lacks \"duration_s\": the length of the run, in seconds"},
    {"6.0", "\"6 s\"",
     "6:14: duration_s is the text \"6 s\"; it must be a plain number, in the unit that its name "
     "says"},
    {"6.0", "6.0\nsample_rate_hz = 11025",
     "7:18: sample_rate_hz is 11025: 16 ms is no whole number of samples; it must be a multiple of "
     "1000"},
    {"6.0", "6.0\nsample_rate_hz = 12500",
     "7:18: sample_rate_hz is 12500: 1 ms is no whole number of samples; it must be a multiple of "
     "1000"},
    {"6.0", "6.0\nsample_rate_hz = 8000.0",
     "7:18: sample_rate_hz is 8000.0; it must be a whole number from 1000 to 32000"},
};

const std::vector<Slip> kOfLosses = {
    // Disturbances.
    {"[28, 1.0, -10.0]", "[28, 1.0]",
     "43:31: an item of harmonics is an array of 2 values; it must be [order, pct, deg]"},
    {"[28, 1.0, -10.0]", "28", "43:31: an item of harmonics is 28; it must be [order, pct, deg]"},
    {"[28,", "[2.5,", "43:32: order is 2.5; it must be a whole number from 2 to 50"},
    {"[28,", "[26,", "43:32: order 26 is there twice"},
    {"[28,", "[5,", "43:32: order 5 is there twice"},
    {"[28,", "[34,", "43:32: order 34 lies at 2040 Hz, not below half of sample_rate_hz"},
    {"1.0, -10.0", "-1.0, -10.0", "43:36: pct is -1; it must be at least 0 and at most 100"},
    {"-10.0", "-370.0", "43:41: deg is -370; it must be at least -360 and at most 360"},
    {"[[26, 5.0, 90.0], [28, 1.0, -10.0]]", "[]",
     "43:13: harmonics is empty; leave it out, or give an array of [order, pct, deg]"},
    // The figures are those of sin θ + Σ a sin(kθ + φ) over a period, worked out elsewhere.
    {"level_pct = 40.0", "level_pct = 140.0",
     "47:1: the voltage reaches 1.587 pu (at 5 s, with harmonics and offset); a source plays 1.5 "
     "pu at most"},
    {"at_s = 8.0\nlevel_pct = 0.0",
     "at_s = 6.0\nlevel_pct = 130.0\n[[signal.amplitude_step]]\nat_s = 7.0\nlevel_pct = 110",
     "51:1: the voltage reaches 1.62 pu (at 7 s, with harmonics and offset); a source plays 1.5 pu "
     "at most"},
    {"5.0, 90.0", "60.0, 90.0",
     "43:13: the voltage reaches 1.682 pu (at 0 s, with harmonics and offset); a source plays 1.5 "
     "pu at most"},
    {"dc_offset_pct = 0.25", "dc_offset_pct = -90",
     "45:17: the voltage reaches 1.951 pu (at 0 s, with harmonics and offset); a source plays 1.5 "
     "pu at most"},
    {"at_s = 8.0", "at_s = 10.0",
     "52:8: at_s is 10; it must be at least 0 and below 10 (the run's duration)"},
    {"duration_s = 1.5", "duration_s = 5.5",
     "49:14: the step ends at 10.5 s, after the run's 10 s; leave duration_s out for a step that "
     "lasts to the end"},
    {"level_pct = 40.0", "",
     "47:1: [[signal.amplitude_step]] lacks \"level_pct\": a number must be given: at least 0 and "
     "at most 150"},
    {"at_s = 3.0", "at_s = 12.0",
     "55:8: at_s is 12; it must be at least 0 and below 10 (the run's duration)"},
    {"at_s = 4.0", "at_s = 40.0",
     "34:8: at_s is 40; it must be at least 0 and below 10 (the run's duration)"},
    {"power_mw = 100.0", "power_mw = 0", "38:12: power_mw is 0: no loss at all; leave it out"},
    {"power_mw = 100.0", "power_mw = 900",
     "38:12: power_mw is 900; it must be at least -800 and at most 800 (the grid's load)"},
    {"power_mw = -50.0", "power_mw = 750.0",
     "33:1: the losses add up to 850 MW by 4 s, more than the grid's load of 800 MW"},
    {"harmonic_set", "frequency = [[0, 60]]\nharmonic_set",
     "44:13: the frequency comes from [[grid.loss]], from frequency points or from a recording; "
     "this profile gives more than one of them"},
    {"[[signal.phase_jump]]",
     "[signal.trace]\nfile = \"r\"\ntime = \"t\"\nfrequency = \"f\"\n[[signal.phase_jump]]",
     "54:1: the frequency comes from [[grid.loss]], from frequency points or from a recording; "
     "this profile gives more than one of them"},
    // Limits.
    {"unit = \"s\"", "unit = \"MW\"",
     "83:8: event.delay is not in \"MW\"; its unit must be s or ms or us"},
    {"unit = \"s\"", "unit = \"seconds\"",
     "83:8: event.delay is not in \"seconds\"; its unit must be s or ms or us"},
    {"unit = \"s\"", "", "81:1: [[expect]] lacks \"unit\": event.delay is in s or ms or us"},
    {"min = 0.03", "min = 0.3", "84:7: min is 0.3, above max 0.16: nothing could pass"},
    {"outlets = [\"early\"]", "outlets = [\"erly\"]",
     "86:12: no group \"erly\"; did you mean \"early\"?"},
    {"outlets = [\"early\"]", "outlets = []",
     "86:11: outlets is empty; leave it out, or give an array of texts in quotes"},
    {"outlets = [\"early\"]", "outlets = [1]",
     "86:12: an item of outlets is 1; it must be a text in quotes"},
    {"equals = \"open\"", "max = 1", "89:7: relay.end is a word, not a number; it takes equals"},
    {"equals = \"open\"", "", "87:1: [[expect]] lacks \"equals\": the word that relay.end must be"},
    {"equals = \"open\"", "equals = \"opne\"", "89:10: equals is \"opne\"; did you mean \"open\"?"},
    // Outlets and commands.
    {"count = 2", "count = 998", "72:1: more than 1000 outlets in all"},
    {"id = \"alone\"", "id = \"shed-2\"",
     "71:6: there is an outlet \"shed-2\" already; give this one another id"},
    {"id = \"alone\"", "id = \"all alone\"",
     "71:6: id is \"all alone\"; it must be of letters, digits, '-', '_' and '.', at most 64 of "
     "them"},
    {"accumulated_mw = 100.0", "accumulated_mw = 801",
     "61:18: accumulated_mw is 801; it must be at least 0 and at most 800 (the grid's load)"},
    {"power_mw = 40.0", "power_mw = 240.0",
     "62:12: power_mw is 240; it must be above 0 and at most 200 (twice accumulated_mw, which "
     "counts half of the outlet's own block)"},
    {"id = \"alone\"", "id = \"alone\"\naccumulated_mw = 300.0",
     "70:1: the firmware refuses these settings: switching-off frequency not from 80 % of nominal "
     "to below nominal"},
    {"threshold_mw = 200.0", "threshold_mw = 1e-300",
     "63:16: threshold_mw is 1e-300; in the outlets' single precision that is 0, which is out of "
     "its range"},
    {"switch_off_hz = 58.5", "switch_off_hz = 59.9999999",
     "64:17: switch_off_hz is 59.9999999; in the outlets' single precision that is 60, which is "
     "out of its range"},
    {"switch_off_hz = 58.5", "switch_off_hz = 60",
     "64:17: switch_off_hz is 60; it must be at least 48 and below 60 (the grid's nominal_hz)"},
    {"switch_off_hz = 58.5", "switch_off_hz = 47.9",
     "64:17: switch_off_hz is 47.9; it must be at least 48 and below 60 (the grid's nominal_hz)"},
    {"[[command]]\nat_s = 7.0", "[[command]]\nat_s = 10.5",
     "75:8: at_s is 10.5; it must be at least 0 and below 10 (the run's duration)"},
    {"\"alone\", \"early\"", "\"alone\", \"shed-4\"",
     "76:21: no outlet or group \"shed-4\"; did you mean \"shed-1\"?"},
    {"[\"alone\", \"early\"]", "[]",
     "76:11: outlets is empty; leave it out, or give an array of texts in quotes"},
    {"switch = \"off\"", "", "78:1: [[command]] lacks \"switch\": \"off\" or \"on\""},
    // The grid in place.
    {"nominal_hz = 60.0", "nominal_hz = 55.0",
     "5:14: nominal_hz is 55; outlets are made for 50 and for 60"},
    {"condition_row_hz = 0.1", "condition_row_hz = 0.02",
     "13:20: rows of 0.02 Hz make 35 load-shedding conditions; an outlet keeps 32 at most: "
     "condition_row_hz must be greater"},
    {"threshold_hz = 59.3", "threshold_hz = 60.5",
     "6:16: threshold_hz is 60.5: must be below nominal_hz, 60"},
    {"droop_pu = 0.04", "droop_pu = 0.04\ninverse_droop_pu = 25",
     "23:12: give droop_pu or inverse_droop_pu, not both"},
    {"droop_pu = 0.04", "",
     "19:1: [[grid.plant]] lacks \"droop_pu\": a number, or inverse_droop_pu"},
    {"[-0.5, 0.0]", "[-0.5, inf]",
     "31:31: an item of condition_rocof_hz_s is inf; it must be at least -1000 and at most 0"},
};

const std::vector<Slip> kOfPoints = {
    {"[6.0, 49.8]", "[2.0, 49.8]", "7:41: t_s is 2 after 2; times must ascend"},
    {"[6.0, 49.8]", "[6.5, 49.8]",
     "7:41: t_s is 6.5; it must be at least 0 and at most 6 (the run's duration)"},
    {"[2.0, 49.5]", "[2.0, 4.95]", "7:33: hz is 4.95; it must be at least 25 and at most 75"},
    {"[2.0, 49.5]", "[2.0, \"49.5\"]",
     "7:33: hz is the text \"49.5\"; it must be a plain number, in the unit that its name says"},
    {"[[outlet]]", "[signal.trace]\nfile = \"r\"\ntime = \"t\"\nfrequency = \"f\"\n[[outlet]]",
     "8:1: the frequency comes from [[grid.loss]], from frequency points or from a recording; this "
     "profile gives more than one of them"},
    {"[[outlet]]",
     "dc_offset_pct = 20.0\n[[signal.amplitude_step]]\nat_s = 1.0\nduration_s = 3.0\n"
     "level_pct = 140.0\n[[outlet]]",
     "9:1: the voltage reaches 1.6 pu (at 1 s, with harmonics and offset); a source plays 1.5 pu "
     "at most"},
};

TEST(Refusal, NamesPlaceAndRemedy) {
  expect_refused(kMinimal, kOfMinimal);
  expect_refused(kLossesInPlace, kOfLosses);
  expect_refused(kPoints, kOfPoints);
}

TEST(Refusal, OfAGridWithoutPlants) {
  std::string text = kLossesInPlace;
  const auto first = text.find("[[grid.plant]]");
  text.erase(first, text.find("[[grid.block]]") - first);
  EXPECT_EQ(refusal(text), "test.toml:4:1: no plant: a grid must have at least one in operation");
}

TEST(Refusal, TakesNoLongerOnAnEndlessWord) {
  EXPECT_THAT(refusal(replaced(kMinimal, "event.count", std::string(1000000, 'x'))),
              testing::HasSubstr("measures are: tracker.delay, "));
}

TEST(Nesting, OfTablesByDotsOrBracketsIsRefusedBeforeItCouldOverflowTheStack) {
  const auto repeated = [](const std::string& piece, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) {
      text += piece;
    }
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
