// Each mistake in a profile has its own message with the exact position.
#include <profile_test/texts.hpp>

#include <vector>

#include <gmock/gmock.h>

namespace gsbench::profile::test {
namespace {

struct Mistake {
  const char* what;     // text to replace …
  const char* by;       // … and its replacement
  const char* message;  // line:column: what is wrong, and what would be right
};

void expect_refused(const std::string& text, const std::vector<Mistake>& mistakes) {
  ASSERT_EQ(refusal(text), "");
  for (const auto& [what, by, message] : mistakes) {
    EXPECT_EQ(refusal(replaced(text, what, by)), std::string("test.toml:") + message) << by;
  }
}

const std::vector<Mistake> kOfMinimal = {
    {"duration_s = 6.0", "duration_s = = 6.0",
     "6:14: invalid TOML: Error while parsing value: could not determine value type"},
    {"max = 0", "max = 0\nmax = 1",
     "11:7: invalid TOML: Error while parsing key-value pair: cannot redefine existing integer "
     "'max'"},
    {"title = \"A test\"", "", "1:1: missing key \"title\" in a profile; give a text in quotes"},
    {"\"A test\"", "\"\"", "1:9: title is an empty text; it must not be empty"},
    {"source", "colour = 1\nsource",
     "2:1: unknown key \"colour\" in a profile; valid keys are: title, source, seed, grid, signal, "
     "outlet, settings, command, expect"},
    {"[[outlet]]", "[[oulet]]",
     "7:3: unknown key \"oulet\" in a profile; did you mean \"outlet\"?"},
    {"[grid]\nsystem = \"ieee24\"", "",
     "1:1: missing key \"grid\" in a profile; give the power system, e.g. [grid] system = "
     "\"ieee24\""},
    {"system = \"ieee24\"", "",
     "3:1: missing key \"system\" in [grid]; give a grid's name (\"ieee24\"), its path, or "
     "[grid.system]"},
    {"ieee24", "ieee25",
     "4:10: unknown grid \"ieee25\"; did you mean \"ieee24\"? (for your own file, give its path, "
     "ending in .toml)"},
    {"ieee24", "ieee24.toml",
     "4:10: unknown grid \"ieee24.toml\"; grids are: ieee24, ieee24-by-unit, island-60hz "
     "(for your own file, give its path, ending in .toml)"},
    {"\"ieee24\"", "24", "4:10: system is 24; it must be a text in quotes"},
    {"[signal]", "[[grid.block]]\nid = \"a\"\npower_mw = 1\n[signal]",
     "5:1: block is only valid with an inline grid ([grid.system]), but system is \"ieee24\"; omit "
     "one of the two"},
    {"[signal]\nduration_s = 6.0", "",
     "1:1: missing key \"signal\" in a profile; give the signal to play, e.g. [signal] duration_s "
     "= 6.0"},
    {"[signal]\nduration_s = 6.0", "[[signal]]\nduration_s = 6.0",
     "5:1: [signal] must be a table, not an array"},
    {"[[outlet]]", "", "1:1: missing key \"outlet\" in a profile; give at least one [[outlet]]"},
    {"[[outlet]]", "[outlet]", "7:1: outlet is a table; it must be an array of tables"},
    {"[[expect]]\nmeasure = \"event.count\"\nmax = 0", "",
     "1:1: missing key \"expect\" in a profile; give at least one [[expect]], the limits of the "
     "run"},
    {"measure = \"event.count\"", "",
     "8:1: missing key \"measure\" in [[expect]]; give the name of a measure, as listed by "
     "`gsbench measures`"},
    {"max = 0", "max = 0\nunit = \"s\"", "11:8: event.count has no unit; omit unit"},
    {"max = 0", "",
     "8:1: missing key \"min\" in [[expect]]; give min, max or both, the limits of event.count"},
    {"max = 0", "equals = \"0\"",
     "10:10: event.count is a number; give min, max or both in place of equals"},
    {"duration_s", "duration",
     "6:1: unknown key \"duration\" in [signal]; did you mean \"duration_s\"?"},
    {"event.count", "tracker.eror.rms",
     "9:11: unknown measure \"tracker.eror.rms\"; did you mean \"tracker.error.rms\"?"},
    {"duration_s = 6.0", "",
     "5:1: missing key \"duration_s\" in [signal]; give the length of the run in seconds"},
    {"6.0", "\"6 s\"",
     "6:14: duration_s is the text \"6 s\"; it must be a number, without quotes and unit"},
    {"6.0", "6.0\nsample_rate_hz = 11025",
     "7:18: sample_rate_hz is 11025; it must be a multiple of 1000, so that 1 ms and 16 ms are "
     "whole numbers of samples"},
    {"6.0", "6.0\nsample_rate_hz = 12500",
     "7:18: sample_rate_hz is 12500; it must be a multiple of 1000, so that 1 ms and 16 ms are "
     "whole numbers of samples"},
    {"6.0", "6.0\nsample_rate_hz = 8000.0",
     "7:18: sample_rate_hz is 8000.0; it must be a whole number from 1000 to 32000"},
};

const std::vector<Mistake> kOfLosses = {
    // Disturbances.
    {"[28, 1.0, -10.0]", "[28, 1.0]",
     "44:31: an item of harmonics is an array of 2 values; it must be [order, pct, deg]"},
    {"[28, 1.0, -10.0]", "28", "44:31: an item of harmonics is 28; it must be [order, pct, deg]"},
    {"[28,", "[33.7,",
     "44:32: harmonic order 33.7 is at 2022.0000000000002 Hz; it must be below 2000 Hz (half of "
     "sample_rate_hz)"},
    {"[28,", "[1.0,", "44:32: harmonic order is 1, the fundamental; it must be another"},
    {"[28,", "[0.0,", "44:32: order is 0; it must be at least 0.001 and at most 1000"},
    {"[28,", "[26,",
     "44:32: harmonic order 26 is given twice; give each order once, including those of "
     "harmonic_set"},
    {"[28,", "[5,",
     "44:32: harmonic order 5 is given twice; give each order once, including those of "
     "harmonic_set"},
    {"[28,", "[34,",
     "44:32: harmonic order 34 is at 2040 Hz; it must be below 2000 Hz (half of sample_rate_hz)"},
    {"1.0, -10.0", "-1.0, -10.0", "44:36: pct is -1; it must be at least 0 and at most 100"},
    {"-10.0", "-370.0", "44:41: deg is -370; it must be at least -360 and at most 360"},
    {"[[26, 5.0, 90.0], [28, 1.0, -10.0]]", "[]",
     "44:13: harmonics is empty; omit it, or give an array of [order, pct, deg]"},
    // Maxima of sin θ + Σ a sin(kθ + φ) over a period, from an independent calculation.
    {"level_pct = 40.0", "level_pct = 140.0",
     "48:1: the voltage reaches 1.587 p.u. at 5 s, harmonics and offset included; it must be at "
     "most 1.5 p.u."},
    {"at_s = 8.0\nlevel_pct = 0.0",
     "at_s = 6.0\nlevel_pct = 130.0\n[[signal.amplitude_step]]\nat_s = 7.0\nlevel_pct = 110",
     "52:1: the voltage reaches 1.62 p.u. at 7 s, harmonics and offset included; it must be at "
     "most 1.5 p.u."},
    {"5.0, 90.0", "60.0, 90.0",
     "44:13: the voltage reaches 1.682 p.u. at 0 s, harmonics and offset included; it must be at "
     "most 1.5 p.u."},
    {"dc_offset_pct = 0.25", "dc_offset_pct = -90",
     "46:17: the voltage reaches 1.951 p.u. at 0 s, harmonics and offset included; it must be at "
     "most 1.5 p.u."},
    {"at_s = 8.0", "at_s = 10.0",
     "53:8: at_s is 10; it must be at least 0 and at most 9.99975 (the last sample of the run)"},
    {"duration_s = 1.5", "duration_s = 5.5",
     "50:14: the step ends at 10.5 s, after the end of the run at 10 s; omit duration_s for one "
     "that lasts to the end"},
    {"level_pct = 40.0", "",
     "48:1: missing key \"level_pct\" in [[signal.amplitude_step]]; give a number, at least 0 and "
     "at most 150"},
    {"at_s = 3.0", "at_s = 12.0",
     "56:8: at_s is 12; it must be at least 0 and at most 9.99975 (the last sample of the run)"},
    {"at_s = 4.0", "at_s = 40.0",
     "35:8: at_s is 40; it must be at least 0 and at most 9.99975 (the last sample of the run)"},
    {"power_mw = 100.0", "power_mw = 0",
     "39:12: power_mw is 0; it must be above 0 (lost generation) or below 0 (shed load)"},
    {"power_mw = 100.0", "power_mw = 900",
     "39:12: power_mw is 900; it must be at least -800 and at most 800 (the grid's load)"},
    {"power_mw = -50.0", "power_mw = 750.0",
     "34:1: the losses add up to 850 MW at 4 s; their sum must stay within ± 800 MW (the grid's "
     "load)"},
    {"harmonic_set", "frequency = [[0, 60]]\nharmonic_set",
     "45:13: the frequency has more than one source; give only one of [[grid.loss]], frequency and "
     "[signal.trace]"},
    {"[[signal.phase_jump]]",
     "[signal.trace]\nfile = \"r\"\ntime = \"t\"\nfrequency = \"f\"\n[[signal.phase_jump]]",
     "55:1: the frequency has more than one source; give only one of [[grid.loss]], frequency and "
     "[signal.trace]"},
    // Limits.
    {"unit = \"s\"", "unit = \"MW\"",
     "84:8: unit is \"MW\"; for event.delay it must be s or ms or us"},
    {"unit = \"s\"", "unit = \"seconds\"",
     "84:8: unit is \"seconds\"; for event.delay it must be s or ms or us"},
    {"unit = \"s\"", "",
     "82:1: missing key \"unit\" in [[expect]]; give the unit of event.delay: s or ms or us"},
    {"min = 0.03", "min = 0.3", "85:7: min is 0.3; it must be at most 0.16 (max)"},
    {"outlets = [\"early\"]", "outlets = [\"erly\"]",
     "87:12: unknown group \"erly\"; did you mean \"early\"?"},
    {"outlets = [\"early\"]", "outlets = []",
     "87:11: outlets is empty; omit it, or give an array of texts in quotes"},
    {"outlets = [\"early\"]", "outlets = [1]",
     "87:12: an item of outlets is 1; it must be a text in quotes"},
    {"equals = \"open\"", "max = 1",
     "90:7: relay.end is a text, not a number; give equals in place of max"},
    {"equals = \"open\"", "",
     "88:1: missing key \"equals\" in [[expect]]; give the value that relay.end must have"},
    {"equals = \"open\"", "equals = \"opne\"", "90:10: equals is \"opne\"; did you mean \"open\"?"},
    // Outlets and commands.
    {"count = 2", "count = 998", "73:1: 1002 outlets in total; a profile has at most 1000"},
    {"id = \"alone\"", "id = \"shed-2\"",
     "72:6: two outlets have the id \"shed-2\"; give this one another id"},
    {"id = \"alone\"", "id = \"all alone\"",
     "72:6: id is \"all alone\"; it must consist of 1 to 64 letters, digits, '-', '_' and '.'"},
    {"accumulated_mw = 100.0", "accumulated_mw = 801",
     "62:18: accumulated_mw is 801; it must be at least 0 and at most 800 (the grid's load)"},
    {"power_mw = 40.0", "power_mw = 240.0",
     "63:12: power_mw is 240; it must be above 0 and at most 200 (twice accumulated_mw, which "
     "includes half of the outlet's own block)"},
    {"id = \"alone\"", "id = \"alone\"\nrules = \"paper\"\naccumulated_mw = 300.0",
     "71:1: the firmware refuses these settings: switching-off frequency below 80 % of nominal or "
     "above nominal"},
    {"threshold_mw = 200.0", "threshold_mw = 1e-300",
     "64:16: threshold_mw is 1e-300; outlets use single precision, in which it is 0 and out of "
     "range"},
    {"switch_off_hz = 58.5", "switch_off_hz = 60.0000001",
     "65:17: switch_off_hz is 60.0000001; it must be at least 48 and at most 60 (the grid's "
     "nominal_hz)"},
    {"switch_off_hz = 58.5", "switch_off_hz = 47.9",
     "65:17: switch_off_hz is 47.9; it must be at least 48 and at most 60 (the grid's nominal_hz)"},
    {"[[command]]\nat_s = 7.0", "[[command]]\nat_s = 10.5",
     "76:8: at_s is 10.5; it must be at least 0 and at most 9.99975 (the last sample of the run)"},
    {"\"alone\", \"early\"", "\"alone\", \"shed-4\"",
     "77:21: unknown outlet or group \"shed-4\"; did you mean \"shed-1\"?"},
    {"[\"alone\", \"early\"]", "[]",
     "77:11: outlets is empty; omit it, or give an array of texts in quotes"},
    {"switch = \"off\"", "", "79:1: missing key \"switch\" in [[command]]; give \"off\" or \"on\""},
    // The inline grid.
    {"nominal_hz = 60.0", "nominal_hz = 55.0", "5:14: nominal_hz is 55; it must be 50 or 60"},
    {"condition_row_hz = 0.1", "condition_row_hz = 0.02",
     "13:20: condition_row_hz is 0.02, which gives 35 load-shedding conditions; an outlet stores "
     "at most 32: increase condition_row_hz"},
    {"credible_loss_mw = 150.0", "credible_loss_mw = 901.0",
     "14:20: credible_loss_mw is 901; it must be at most 900 (base_mw)"},
    {"threshold_hz = 59.3", "threshold_hz = 60.5",
     "6:16: threshold_hz is 60.5; it must be below 60 (nominal_hz)"},
    {"droop_pu = 0.04", "droop_pu = 0.04\ninverse_droop_pu = 25",
     "24:12: both droop_pu and inverse_droop_pu are given; give only one"},
    {"droop_pu = 0.04", "",
     "20:1: missing key \"droop_pu\" in [[grid.plant]]; give droop_pu or inverse_droop_pu"},
    {"[-0.5, 0.0]", "[-0.5, inf]",
     "32:31: an item of condition_rocof_hz_s is inf; it must be finite, at least -1000 and at most "
     "0"},
};

const std::vector<Mistake> kOfDisturbed = {
    {"at_s = 6.0", "at_s = 9.95",
     "31:8: at_s is 9.95; it must be at least 0 and at most 9.9 (0.1 s before the end of the run, "
     "so that they can be acknowledged)"},
    {"\"shed-1\"", "\"shed-3\"",
     "32:12: unknown outlet or group \"shed-3\"; did you mean \"shed-1\"?"},
    {"accumulated_mw = 120.0", "accumulated_mw = 3000.0",
     "33:18: accumulated_mw is 3000; it must be at least 0 and at most 2745 (the grid's load)"},
    {"power_mw = 50.0", "power_mw = 250.0",
     "34:12: power_mw is 250 and accumulated_mw is 120; power_mw must be at most twice "
     "accumulated_mw, which includes half of the outlet's own block"},
    {"threshold_mw = 250.0", "accumulated_mw = 20.0",
     "55:18: power_mw is 50 and accumulated_mw is 20; power_mw must be at most twice "
     "accumulated_mw, which includes half of the outlet's own block"},
    {"switch_off_hz = 49.2", "switch_off_hz = 50.1",
     "36:17: switch_off_hz is 50.1; it must be at least 40 and at most 50 (the grid's nominal_hz)"},
    {"= 49.85", "= 47.0",
     "5:23: frequency_before_hz is 47; it must be at least 47.852 and at most 52.148 (as far as "
     "the grid's load moves it)"},
    {"[[grid.loss]]\nat_s = 2.0\npower_mw = 500.0\nramp_s = 3.0\n"
     "[[grid.loss]]\nat_s = 4.5\npower_mw = -200.0\n[signal]\n",
     "[signal]\nfrequency = [[0.0, 50.0]]\n",
     "5:23: frequency_before_hz is only valid if the frequency follows from the grid; omit it, or "
     "frequency and [signal.trace]"},
    {"at_s = 1.0", "at_s = 10.0",
     "16:8: at_s is 10; it must be at least 0 and at most 9.999875 (the last sample of the run)"},
    {"duration_s = 8.0", "duration_s = 9.5",
     "17:14: the oscillation ends at 10.5 s, after the end of the run at 10 s; omit duration_s for "
     "one that lasts to the end"},
    {"frequency_hz = 0.4", "frequency_hz = 6",
     "18:16: frequency_hz is 6; it must be at least 0.05 and at most 5"},
    {"amplitude_mhz = 60.0", "amplitude_mhz = 0",
     "19:17: amplitude_mhz is 0; it must be above 0 and at most 1000"},
    {"duration_s = 0.5", "duration_s = 7.6",
     "61:14: the tone ends at 10.1 s, after the end of the run at 10 s; omit duration_s for one "
     "that lasts to the end"},
    {"duration_s = 0.5", "duration_s = 1e-5",
     "61:14: duration_s is 1e-05 s; it must be at least 0.000125 s, one sample"},
    {"frequency_hz = 216.7", "frequency_hz = inf",
     "62:16: frequency_hz is inf; it must be finite, above 0"},
    {"frequency_hz = 216.7", "frequency_hz = 4000",
     "62:16: frequency_hz is 4000; it must be below 4000 (half of sample_rate_hz)"},
    {"amplitude_pct = 9.0", "amplitude_pct = 0",
     "63:17: amplitude_pct is 0; it must be above 0 and at most 100"},
    {"amplitude_pct = 9.0", "amplitude_pct = 48.0",
     "59:1: the voltage reaches 1.535 p.u. at 2.5 s, harmonics, flicker, tones and offset "
     "included; it must be at most 1.5 p.u."},
    {"depth_pct = 2.0", "depth_pct = 95.0",
     "75:1: the voltage reaches 1.612 p.u. at 2.5 s, harmonics, flicker, tones and offset "
     "included; it must be at most 1.5 p.u."},
    {"\"1101 0\"", "\"1101 2\"",
     "68:12: telegram is \"1101 2\"; it must consist of 1, 0 and blanks"},
    {"\"1101 0\"", "\"00\"", "68:12: telegram is \"00\"; it must have a 1"},
    {"bit_s = 0.1", "bit_s = 3.0",
     "68:12: the last pulse ends 12 s after at_s; it must end within 10 s, as the tone or the run "
     "does"},
    {"bit_s = 0.1", "bit_s = 0.00012",
     "69:9: bit_s is 0.00012 s; it must be at least 0.000125 s, one sample"},
    {"bit_s = 0.1", "",
     "65:1: missing key \"bit_s\" in [[signal.tone]]; give the duration of each bit of the "
     "telegram in seconds"},
    {"telegram = \"1101 0\"\n", "",
     "68:9: bit_s is given without a telegram; give one, or omit bit_s"},
    {"[0.75, 1.5]", "[0.4, 1.5]",
     "74:26: from is 0.4; it must be at least 0.5, the end of the previous pulse"},
    {"[0.75, 1.5]", "[0.75, 0.75]",
     "74:32: to is 0.75; it must be above 0.75, the start of the pulse"},
    {"[0.75, 1.5]", "[0.75, 0.75001]",
     "74:32: the pulse is 1e-05 s; it must be at least 0.000125 s, one sample"},
    {"[0.75, 1.5]", "[0.5001, 1.5]",
     "74:26: the gap before the pulse is 0.0001 s; it must be at least 0.000125 s, one sample"},
    {"[0.75, 1.5]", "[0.75, 9.5]",
     "74:12: the last pulse ends 9.5 s after at_s; it must end within 9 s, as the tone or the run "
     "does"},
    {"pulses_s = [[", "telegram = \"1\"\nbit_s = 1.0\npulses_s = [[",
     "76:12: both telegram and pulses_s are given; give only one"},
    {"changes_per_minute = 1056.0", "changes_per_minute = 1056.0\nfrequency_hz = 8.8",
     "80:22: both frequency_hz and changes_per_minute are given; give only one"},
    {"changes_per_minute = 1056.0", "",
     "75:1: missing key \"frequency_hz\" in [[signal.flicker]]; give frequency_hz or "
     "changes_per_minute"},
    {"changes_per_minute = 1056.0", "changes_per_minute = 480000.0",
     "80:22: the frequency of the flicker is 4000 Hz; it must be below 4000 Hz (half of "
     "sample_rate_hz)"},
    {"changes_per_minute = 1056.0", "changes_per_minute = 474000.0",
     "83:16: the fundamental has a side band at 4008.7 Hz at 1 s by the flicker; it must be below "
     "4000 Hz (half of sample_rate_hz)"},
    {"ramp_s = 3.0", "ramp_s = -1", "9:10: ramp_s is -1; it must be at least 0 and at most 3600"},
    {"ramp_s = 3.0", "ramp_s = 0.0001",
     "9:10: ramp_s is 0.0001; it must be at least 0.001, or 0 for a step"},
    {"power_mw = -200.0", "power_mw = 2300.0",
     "6:1: the losses add up to 2800 MW at 5 s; their sum must stay within ± 2745 MW (the grid's "
     "load)"},
};

const std::vector<Mistake> kOfPoints = {
    {"[6.0, 49.8]", "[2.0, 49.8]",
     "7:41: t_s is 2; it must be above 2, the time of the previous point"},
    {"[6.0, 49.8]", "[6.5, 49.8]",
     "7:41: t_s is 6.5; it must be at least 0 and at most 6 (the run's duration)"},
    {"[2.0, 49.5]", "[2.0, 4.95]", "7:33: hz is 4.95; it must be at least 25 and at most 75"},
    {"[2.0, 49.5]", "[2.0, \"49.5\"]",
     "7:33: hz is the text \"49.5\"; it must be a number, without quotes and unit"},
    {"[[outlet]]", "[signal.trace]\nfile = \"r\"\ntime = \"t\"\nfrequency = \"f\"\n[[outlet]]",
     "11:1: the frequency has more than one source; give only one of [[grid.loss]], frequency and "
     "[signal.trace]"},
    {"[[outlet]]",
     "dc_offset_pct = 20.0\n[[signal.amplitude_step]]\nat_s = 1.0\nduration_s = 3.0\n"
     "level_pct = 140.0\n[[outlet]]",
     "12:1: the voltage reaches 1.6 p.u. at 1 s, harmonics and offset included; it must be at most "
     "1.5 p.u."},
};

TEST(Refusal, GivesThePositionAndTheCorrection) {
  expect_refused(kMinimal, kOfMinimal);
  expect_refused(kLossesInPlace, kOfLosses);
  expect_refused(kDisturbed, kOfDisturbed);
  expect_refused(kPoints, kOfPoints);
}

// The last sample of a run of 6 s, at 8000/s, is at 5.999875 s.
TEST(Refusal, OfWhatWouldStartAfterTheLastSample) {
  for (const std::string key : {
           "[[signal.amplitude_step]]\nlevel_pct = 50.0\nat_s = ",
           "[[signal.phase_jump]]\ndegrees = 20.0\nat_s = ",
           "[[signal.oscillation]]\nfrequency_hz = 0.5\namplitude_mhz = 30.0\nat_s = ",
           "[[signal.flicker]]\nfrequency_hz = 8.8\ndepth_pct = 2.0\nat_s = ",
           "[[signal.tone]]\nfrequency_hz = 175.0\namplitude_pct = 5.0\nat_s = ",
           "[[grid.loss]]\npower_mw = 100.0\nat_s = ",
           "[[command]]\nswitch = \"off\"\nat_s = ",
       }) {
    const auto refusal_of = [&](const char* at_s) {
      return refusal(replaced(kMinimal, "[[outlet]]", key + at_s + "\n[[outlet]]"));
    };
    EXPECT_EQ(refusal_of("5.999875"), "") << key;
    EXPECT_THAT(refusal_of("5.9999"),
                testing::HasSubstr(":8: at_s is 5.9999; it must be at least 0 and at most 5.999875 "
                                   "(the last sample of the run)"))
        << key;
  }
  // A run that ends within a sample plays whole ones.
  const std::string longer = replaced(kMinimal, "6.0", "6.00006");
  const auto with_tone = [&](const std::string& pulse) {
    return refusal(replaced(longer, "[[outlet]]",
                            "[[signal.tone]]\nfrequency_hz = 175.0\namplitude_pct = 5.0\n"
                            "pulses_s = [[0.0, 1.0], [" +
                                pulse + "]]\n[[outlet]]"));
  };
  EXPECT_EQ(with_tone("5.999875, 6.0"), "");
  EXPECT_THAT(with_tone("5.99993, 6.00006"), testing::HasSubstr("it must end within 6 s"));
}

TEST(Refusal, OfAnOscillationShorterThanASample) {
  const auto lasting = [](const char* duration_s) {
    return refusal(replaced(kMinimal, "[[outlet]]",
                            std::string("[[signal.oscillation]]\nfrequency_hz = 0.5\n"
                                        "amplitude_mhz = 30.0\nduration_s = ") +
                                duration_s + "\n[[outlet]]"));
  };
  EXPECT_EQ(lasting("0.000125"), "");
  EXPECT_THAT(lasting("0.0001"), testing::HasSubstr(":14: duration_s is 0.0001 s; it must be at "
                                                    "least 0.000125 s, one sample"));
}

TEST(Refusal, OfAGridWithoutPlantsIsAtTheGrid) {
  std::string text = kLossesInPlace;
  const auto first = text.find("[[grid.plant]]");
  text.erase(first, text.find("[[grid.block]]") - first);
  EXPECT_EQ(refusal(text),
            "test.toml:4:1: the grid has no plant; it must have at least one in operation");
}

TEST(Refusal, IsNotSlowForAVeryLongName) {
  EXPECT_THAT(refusal(replaced(kMinimal, "event.count", std::string(1000000, 'x'))),
              testing::HasSubstr("measures are: tracker.delay, "));
}

TEST(Nesting, BeyondTheMaximumIsRefusedBeforeItOverflowsTheStack) {
  const auto repeated = [](const std::string& piece, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) {
      text += piece;
    }
    return text;
  };
  const std::string message = "nested 65 levels deep; the maximum is 64";
  EXPECT_EQ(refusal(repeated("a.", 50000) + "b = 1\n"), "test.toml:1:130: " + message);
  EXPECT_EQ(refusal("[" + repeated("a.", 50000) + "b]\n"), "test.toml:1:129: " + message);
  EXPECT_EQ(refusal("x = " + repeated("[", 50000)), "test.toml:1:69: " + message);
  EXPECT_EQ(refusal("x = " + repeated("{a = ", 50000)), "test.toml:1:325: " + message);
  EXPECT_EQ(refusal("x = 1\ny = " + repeated("{a.b.c = ", 50000)), "test.toml:2:196: " + message);
  // A text in three quotes that itself ends in a quote.
  EXPECT_EQ(refusal(R"(x = ["""q"""", )" + repeated("[", 50000)), "test.toml:1:79: " + message);
}

TEST(Nesting, IgnoresDotsAndBracketsInTextsCommentsAndNumbers) {
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
