// A checked profile: everything a run needs. load_profile() creates it from a valid profile only,
// and nothing changes it afterwards.
#pragma once

#include <control_centre/outlet_settings.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <grid/grid.hpp>
#include <waveform/reference_signal.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::profile {

// A CSV recording to play.
struct Recording {
  std::string file;    // as given in the profile or on the command line
  std::string path;    // as opened
  std::string sha256;  // of the whole file, hexadecimal; empty if a copy was read in its place
  recording::TraceFormat format;
  bool replaces_profile = false;  // given on the command line (Overrides)
  // The played part, from which Copies make the same plan. Bytes of the file: not always UTF-8.
  std::string played_text;
  std::vector<recording::Place> voltage_at;  // Trace::voltage_at
  std::size_t rows = 0;                      // of the played part, with gaps
  std::size_t gaps = 0;                      // rows without a value
};

// Largest accepted deviations of the played voltage from the signal. A source that cannot keep them
// is refused before it is energised.
struct Tolerances {
  double frequency_mhz = 2.0;  // over windows of 200 ms; a crystal of 30 ppm takes 1.5
  double voltage_pct = 2.0;    // of the nominal peak amplitude; generators are within 1
  double time_ms = 1.0;
};

struct Stimulus {
  // Source of the frequency: at most one of losses and points is not empty.
  std::vector<grid::PowerChange> losses;      // [[grid.loss]]
  std::vector<recording::TracePoint> points;  // [signal] frequency or [signal.trace]
  Recording recording;                        // the origin of the points, if it is a recording
  double initial_deviation_hz = 0.0;          // frequency_before_hz less nominal; 0 with points
  std::vector<waveform::Oscillation> oscillations;  // laid over any of these sources
  waveform::SignalSpec signal;
  double duration_s = 0.0;             // > 0
  std::int64_t sample_rate_hz = 8000;  // whole multiple of 1000
  double noise_pct = 0.0;              // white, RMS, % of the nominal peak amplitude
  Tolerances tolerances;

  float noise_rms_pu() const { return static_cast<float>(noise_pct / 100.0); }
};

struct Outlet {
  std::string id;     // unique in the plan
  std::string group;  // of its [[outlet]] table
  control_centre::RequestedSettings settings;
};

// The groups of these outlets, each once, in the order of the profile.
std::vector<std::string> groups_of(const std::vector<Outlet>& outlets);

// Settings that the control centre sends again during the run.
struct SettingsUpdate {
  double at_s = 0.0;
  // All settings of each recipient, by its id, with the changes so far.
  std::map<std::string, control_centre::RequestedSettings> outlets;
  std::string changes;  // "accumulated_mw = 120, threshold_mw = 300"; empty: none
};

// A command of the control centre, which switches outlets by criterion (3) of §5.5.
struct Command {
  double at_s = 0.0;
  std::vector<std::string> outlets;  // ids; empty: all
  bool switch_on = false;            // false: off
};

// A limit of a measured value: [[expect]].
struct Expectation {
  std::string measure;        // a name of the catalogue of measures
  std::string unit;           // unit of the measure, or one that converts to it
  std::optional<double> min;  // in `unit`, inclusive
  std::optional<double> max;
  std::optional<std::string> equals;  // for measures that are texts: "open"
  std::vector<std::string> groups;    // outlets of these groups; empty: all
  int line = 0;                       // in the profile, for messages
};

struct Plan {
  std::string name;  // "paper/loss-500mw"
  std::string title;
  std::string source;  // origin of the test case
  std::string path;    // of the profile file, as opened
  std::string text;    // content of the profile file
  std::string sha256;  // of text, hexadecimal
  grid::Grid grid;
  std::string grid_text;  // content of the grid file; empty if the grid is part of the profile
  Stimulus stimulus;
  std::vector<Outlet> outlets;            // at least one
  std::vector<SettingsUpdate> settings;   // ascending in time
  std::vector<Command> commands;          // ascending in time
  std::vector<Expectation> expectations;  // at least one
  std::uint64_t seed = 1;

  std::int64_t duration_ticks() const;
  // The frequency that the outlets see.
  std::shared_ptr<const waveform::ReferenceSignal> reference() const;
  // The same without oscillations: the frequency of the grid model, for its nadir.
  std::unique_ptr<waveform::ReferenceSignal> grid_reference() const;
  waveform::Synthesizer synthesizer() const;
};

}  // namespace gsbench::profile
