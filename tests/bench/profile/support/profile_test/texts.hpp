// Profiles for tests, and functions to introduce mistakes into them.
#pragma once

#include <test_support/refusal.hpp>

#include <string>

#include <profile/load.hpp>

namespace gsbench::profile::test {

// The smallest valid profile.
inline constexpr const char* kMinimal = R"(title = "A test"
source = "None"
[grid]
system = "ieee24"
[signal]
duration_s = 6.0
[[outlet]]
[[expect]]
measure = "event.count"
max = 0
)";

// The following four use every key, each with a value other than its default.
inline constexpr const char* kLossesInPlace = R"(title = "Losses in a grid in place"
source = "Somewhere"
seed = 7
[grid.system]
nominal_hz = 60.0
threshold_hz = 59.3
base_mw = 900.0
load_mw = 800.0
damping_pu = 1.5
gain_km = 0.9
reheat_fraction = 0.25
reheat_s = 7.0
condition_row_hz = 0.1
credible_loss_mw = 150.0
[[grid.plant]]
id = "one"
rating_mw = 500.0
inertia_s = 4.0
inverse_droop_pu = 20.0
[[grid.plant]]
id = "two"
rating_mw = 400.0
inertia_s = 5.0
droop_pu = 0.04
[[grid.block]]
id = "least"
power_mw = 30.0
[grid.reference]
source = "A paper"
t_nadir_s = 2.5
threshold_mw = 90.0
condition_rocof_hz_s = [-0.5, 0.0]
note = "Why they differ"
[[grid.loss]]
at_s = 4.0
power_mw = -50.0
[[grid.loss]]
at_s = 2.0
power_mw = 100.0
[signal]
duration_s = 10.0
sample_rate_hz = 4000
noise_pct = 0.5
harmonics = [[26, 5.0, 90.0], [28, 1.0, -10.0]]
harmonic_set = "en50160"
dc_offset_pct = 0.25
initial_phase_deg = 30.0
[[signal.amplitude_step]]
at_s = 5.0
duration_s = 1.5
level_pct = 40.0
[[signal.amplitude_step]]
at_s = 8.0
level_pct = 0.0
[[signal.phase_jump]]
at_s = 3.0
degrees = -20.0
[[outlet]]
count = 3
id = "shed"
group = "early"
accumulated_mw = 100.0
power_mw = 40.0
threshold_mw = 200.0
switch_off_hz = 58.5
event_drop_hz = 0.03
event_departure_hz = 0.04
condition_hits = 12
lse_samples = 8
ekf_samples = 30
[[outlet]]
id = "alone"
[[outlet]]
count = 2
[[command]]
at_s = 7.0
outlets = ["alone", "early"]
switch = "on"
[[command]]
at_s = 6.0
switch = "off"
[[expect]]
measure = "event.delay"
unit = "s"
min = 0.03
max = 0.16
outlets = ["early"]
[[expect]]
measure = "relay.end"
equals = "open"
)";

inline constexpr const char* kDisturbed = R"(title = "A disturbed grid"
source = "Somewhere"
[grid]
system = "ieee24"
frequency_before_hz = 49.85
[[grid.loss]]
at_s = 2.0
power_mw = 500.0
ramp_s = 3.0
[[grid.loss]]
at_s = 4.5
power_mw = -200.0
[signal]
duration_s = 10.0
[[signal.oscillation]]
at_s = 1.0
duration_s = 8.0
frequency_hz = 0.4
amplitude_mhz = 60.0
phase_deg = 90.0
[[signal.oscillation]]
frequency_hz = 0.7
amplitude_mhz = 10.0
[[outlet]]
count = 2
id = "shed"
accumulated_mw = 100.0
[[outlet]]
id = "alone"
[[settings]]
at_s = 6.0
outlets = ["shed-1", "alone"]
accumulated_mw = 120.0
power_mw = 50.0
threshold_mw = 300.0
switch_off_hz = 49.2
event_drop_hz = 0.03
event_departure_hz = 0.04
condition_hits = 12
lse_samples = 8
ekf_samples = 30
method = 0
threshold_hz = 49.4
nadir_margin_hz = 0.01
decision_reports = 50
delay_s = 0.5
restore_hz = 49.9
restore_dwell_s = 30.0
restore_spread_s = 100.0
[[settings]]
at_s = 3.0
[[settings]]
at_s = 7.0
outlets = ["shed"]
threshold_mw = 250.0
[[expect]]
measure = "event.count"
max = 1
[[signal.tone]]
at_s = 2.5
duration_s = 0.5
frequency_hz = 216.7
amplitude_pct = 9.0
phase_deg = -30.0
[[signal.tone]]
frequency_hz = 1042.0
amplitude_pct = 3.0
telegram = "1101 0"
bit_s = 0.1
[[signal.tone]]
at_s = 1.0
frequency_hz = 175.0
amplitude_pct = 1.0
pulses_s = [[0.0, 0.5], [0.75, 1.5]]
[[signal.flicker]]
at_s = 1.0
duration_s = 2.5
shape = "rectangle"
depth_pct = 2.0
changes_per_minute = 1056.0
[[signal.flicker]]
depth_pct = 1.0
frequency_hz = 8.8
)";

inline constexpr const char* kPoints = R"(title = "Points"
source = "Somewhere"
[grid]
system = "ieee24"
[signal]
duration_s = 6.0
frequency = [[0.0, 50.0], [2.0, 49.5], [6.0, 49.8]]
frequency_tolerance_mhz = 0.2
voltage_tolerance_pct = 0.5
time_tolerance_ms = 0.1
[[outlet]]
rules = "paper"
method = 0
threshold_hz = 49.4
nadir_margin_hz = 0.01
decision_reports = 50
delay_s = 0.5
restore_hz = 49.9
restore_dwell_s = 30.0
restore_spread_s = 100.0
[[expect]]
measure = "event.count"
max = 0
)";

inline constexpr const char* kRecording = R"(title = "A recording"
source = "Somewhere"
[grid]
system = "ieee24"
[signal]
duration_s = 2.0
[signal.trace]
file = "recording.csv"
time = "t"
frequency = "f"
voltage = "u"
nominal_voltage = 230.0
from_s = 1.0
until_s = 4.0
[[outlet]]
[[expect]]
measure = "event.count"
max = 0
)";

// With every option that kRecording does not have.
inline constexpr const char* kForeignRecording = R"(title = "A recording in another format"
source = "Somewhere"
[grid]
system = "ieee24"
[signal]
[signal.trace]
file = "foreign.csv"
time = 1
frequency = 2
from_s = "28.04.25 11:00:01"
until_s = 2025-04-28 11:00:03.5
delimiter = ";"
decimal = ","
skip_rows = 2
header_rows = 0
time_unit = "s"
time_format = "%d.%m.%y %H:%M:%S"
frequency_unit = "mHz"
frequency_offset_hz = 50.0
gaps = ["-999", "bad"]
[[outlet]]
[[expect]]
measure = "event.count"
max = 0
)";

inline constexpr const char* kForeignCsv =
    "recorder 7\n\"unbalanced\n28.04.25 11:00:00;0\n28.04.25 11:00:01;-10,5\n"
    "28.04.25 11:00:02;-999,0\n28.04.25 11:00:02,5;bad\n28.04.25 11:00:03;+1E1\n28.04.25 "
    "11:00:04;-\n";

// `text` with the first occurrence of `what` replaced; throws std::out_of_range without one.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

inline Plan parse(const std::string& text) {
  return parse_profile(text, "test.toml");
}

// The message of the refusal; empty if the profile is accepted.
inline std::string refusal(const std::string& text, const std::string& path = "test.toml",
                           const Overrides& overrides = {}) {
  return gsbench::test::refusal_of<ConfigurationError>(
      [&] { (void)parse_profile(text, path, overrides); });
}

}  // namespace gsbench::profile::test
