// The sections of a profile, a file each: what it may say, and how it is read.
#pragma once

#include <string>
#include <vector>

#include <grid/grid.hpp>
#include <keys/table.hpp>
#include <profile/files.hpp>
#include <profile/plan.hpp>

namespace gsbench::profile {

// A run's records are held in memory, 130 MB an outlet for this long; longer times are studied over
// many seeds.
constexpr double kLongestRun_s = 1.0e5;
// An outlet has 96 ms to answer to its settings.
constexpr double kShortestRun_s = 0.1;

// at_s: an instant before the end of the run.
keys::Key time_in_run(const char* meaning);
keys::Range within_run(double duration_s);

// [grid]: from a file of its own, or in place.
keys::Key grid_section_keys();
grid::Grid read_grid_file(const NamedFile& file);
// `title` and `source` are the profile's, for a grid that it holds.
grid::Grid read_grid_section(const keys::Table& section, const std::string& title,
                             const std::string& source);
// Refuses a grid that asks for more load-shedding conditions than outlets keep; on its own such a
// grid is fine.
void check_conditions(const keys::Table& section, const grid::Grid& grid);

// [signal] and [[grid.loss]]: what is played. `skip_recording`: another recording is going to take
// the place of [signal.trace], whose file need not be there then.
keys::Key signal_keys();
Stimulus read_stimulus(const keys::Table& signal, const keys::Table& grid_section,
                       const grid::Grid& grid, bool skip_recording);
std::vector<waveform::Harmonic> en50160_harmonics();

// [signal.trace]: sets the stimulus's points, recording and duration.
keys::Key trace_keys();
void read_trace_section(const keys::Table& signal, double nominal_hz, Stimulus& stimulus);
// The whole recording in place of whatever happens in the stimulus so far; what the signal is made
// of (noise, harmonics, DC offset) stays.
void replace_by_recording(const std::string& path, const recording::TraceColumns& columns,
                          double nominal_hz, Stimulus& stimulus);

// What every source can play, per unit of the nominal amplitude (peak).
constexpr double kFullScale_pu = 1.5;
// Refuses what a source could not play. Noise is not counted: an outlet's input clips it.
void check_full_scale(const keys::Table& signal, const Stimulus& stimulus,
                      const waveform::ReferenceSignal& reference);

// [[outlet]]: who listens, and with which settings.
keys::Key outlet_keys();
std::vector<Outlet> read_outlets(const keys::Table& top, const grid::Grid& grid);

// [[command]]: what the control centre orders during the run.
keys::Key command_keys();
std::vector<Command> read_commands(const keys::Table& top, const std::vector<Outlet>& outlets,
                                   double duration_s);

// [[expect]]: the limits that the run is judged by.
keys::Key expect_keys();
std::vector<Expectation> read_expectations(const keys::Table& top,
                                           const std::vector<Outlet>& outlets);

}  // namespace gsbench::profile
