// The sections of a profile. Each section has one source file, which declares its keys and reads
// it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <grid/grid.hpp>
#include <keys/table.hpp>
#include <profile/files.hpp>
#include <profile/load.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

// The records of a run are kept in memory: 130 MB per outlet for this duration. Longer times are
// studied with several seeds.
constexpr double kLongestRun_s = 1.0e5;
// An outlet must acknowledge its settings within 96 ms; a run must last longer than that.
constexpr double kShortestRun_s = 0.1;

// The time in which a profile places what it plays.
struct RunTime {
  double duration_s;
  std::int64_t sample_rate_hz;

  double sample_s() const { return 1.0 / static_cast<double>(sample_rate_hz); }
  double end_s() const;        // of the last whole sample
  keys::Range starts() const;  // what starts in it is played for at least one sample
};

// The key at_s: a time within the run.
keys::Key time_in_run(const char* meaning);

// The keys at_s, by default 0, and duration_s, by default to the end of the run.
keys::Key start_key();
keys::Key duration_key();

struct Span {
  double at_s;
  double duration_s;  // infinity: to the end of the run
};
// The values of both. Refuses less than a sample, and an end after the end of the run. `what` names
// it in the message.
Span read_span(const keys::Table& table, const RunTime& run, const char* what);

// What is shorter than a sample might fall between two and not be played. Refuses `value_s`, given
// at a position, below the sample period.
void check_at_least_a_sample(const keys::Table& table, keys::Position at, const std::string& name,
                             double value_s, double sample_s);

// [grid]: from a file, or inline.
keys::Key grid_section_keys();
grid::Grid read_grid_text(const NamedFile& file, const std::string& text);
// `title` and `source`: those of the profile, used for an inline grid. Sets `text` to the content
// of the grid file; if `copy` is given, it is this.
grid::Grid read_grid_section(const keys::Table& section, const std::string& title,
                             const std::string& source, const std::optional<std::string>& copy,
                             std::string& text);
// Refuses a grid with more load-shedding conditions than an outlet stores. Such a grid is valid in
// a grid file, but not in a profile.
void check_conditions(const keys::Table& section, const grid::Grid& grid);

// [[grid.loss]]: changes of the power balance, ascending in time.
keys::Key loss_keys();
std::vector<grid::PowerChange> read_losses(const keys::Table& grid_section, const grid::Grid& grid,
                                           const RunTime& run);

// [grid] frequency_before_hz. read_initial_deviation returns it less nominal, in Hz; 0 without it.
keys::Key frequency_before_key();
double read_initial_deviation_hz(const keys::Table& grid_section, const grid::Grid& grid);

// [[signal.oscillation]], in the order of the profile.
keys::Key oscillation_keys();
std::vector<waveform::Oscillation> read_oscillations(const keys::Table& signal, const RunTime& run);

// [signal] harmonics and harmonic_set. Refuses an order that is given twice, or 1.
keys::Key harmonics_key();
keys::Key harmonic_set_key();
std::vector<waveform::Harmonic> read_harmonics(const keys::Table& signal, double nominal_hz,
                                               double rate_hz);
// Refuses a harmonic that reaches half of the sample rate when the frequency is high, and flicker
// whose side bands do.
void check_spectrum(const keys::Table& signal, const Stimulus& stimulus,
                    const waveform::ReferenceSignal& reference);

// [[signal.flicker]], in the order of the profile.
keys::Key flicker_keys();
std::vector<waveform::Flicker> read_flickers(const keys::Table& signal, const RunTime& run);

// [[signal.tone]], in the order of the profile.
keys::Key tone_keys();
std::vector<waveform::Tone> read_tones(const keys::Table& signal, const RunTime& run);

// [signal] and the disturbances of [grid]. `skip_recording`: the file of [signal.trace] is not read
// and need not exist, because another recording replaces it. `copies`: of its recording.
keys::Key signal_keys();
Stimulus read_stimulus(const keys::Table& signal, const keys::Table& grid_section,
                       const grid::Grid& grid, bool skip_recording, const Copies& copies);

// [signal.trace]: sets the stimulus's points, recording and duration.
keys::Key trace_keys();
recording::TraceFormat read_trace_format(const keys::Table& trace);
void read_trace_section(const keys::Table& signal, double nominal_hz, const Copies& copies,
                        Stimulus& stimulus);
// Makes the stimulus play the recording of the overrides. It replaces the profile's frequency
// source (losses, points or recording), its oscillations, tones, flicker, amplitude and phase
// steps. Noise, harmonics and DC offset stay.
void replace_by_recording(const Overrides& overrides, double nominal_hz, const Copies& copies,
                          Stimulus& stimulus);

// Full scale of every source, per unit of the nominal peak amplitude.
constexpr double kFullScale_pu = 1.5;
// Refuses a signal beyond full scale. Noise is not counted, because an outlet's input clips it.
void check_full_scale(const keys::Table& signal, const Stimulus& stimulus,
                      const waveform::ReferenceSignal& reference);

// [[outlet]]: the outlets and their settings.
keys::Key outlet_keys();
std::vector<Outlet> read_outlets(const keys::Table& top, const grid::Grid& grid);

// The settings of outlets that profiles may set, with the firmware's names.
std::vector<keys::Key> setting_keys();
// Adds those that `table` has. Refuses a value that is out of range in single precision.
void read_settings(const keys::Table& table, double nominal_hz,
                   std::map<std::string, double>& settings);

// The key `outlets`: ids of the outlets that it names by id or by group, each once, in the order of
// `outlets`; empty without the key. Refuses an unknown name.
std::vector<std::string> named_outlets(const keys::Table& table,
                                       const std::vector<Outlet>& outlets);

// [[settings]]: settings that are sent again during the run.
keys::Key settings_update_keys();
std::vector<SettingsUpdate> read_settings_updates(const keys::Table& top, const grid::Grid& grid,
                                                  const std::vector<Outlet>& outlets,
                                                  double duration_s);

// [[command]]: commands of the control centre during the run.
keys::Key command_keys();
std::vector<Command> read_commands(const keys::Table& top, const std::vector<Outlet>& outlets,
                                   const RunTime& run);

// [[expect]]: the limits of the run.
keys::Key expect_keys();
std::vector<Expectation> read_expectations(const keys::Table& top,
                                           const std::vector<Outlet>& outlets);

}  // namespace gsbench::profile
