// A checked profile: everything a run needs, in SI units, immutable from here on. A profile that
// does not make sense never becomes a Plan (see load_profile).
#pragma once

#include <control_centre/outlet_settings.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <grid/grid.hpp>
#include <waveform/reference_signal.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::profile {

// A CSV recording that is played.
struct Recording {
  std::string file;    // as the profile or the command line names it
  std::string path;    // as opened
  std::string sha256;  // of its content, hexadecimal
  recording::TraceColumns columns;
  bool replaces_profile = false;  // the command line gave it in place of the profile's own signal
};

struct Stimulus {
  // Where the frequency comes from: one of the two at most.
  std::vector<grid::PowerChange> losses;  // [[grid.loss]]
  // Of [signal] frequency = [[t, hz], …], or of [signal.trace], already read.
  std::vector<recording::TracePoint> points;
  Recording recording;  // that the points are from
  waveform::SignalSpec signal;
  double duration_s = 0.0;             // > 0
  std::int64_t sample_rate_hz = 8000;  // whole multiple of 1000
  double noise_pct = 0.0;              // white, RMS, of the nominal amplitude (peak)

  float noise_rms_pu() const { return static_cast<float>(noise_pct / 100.0); }
};

struct Outlet {
  std::string id;     // unique in the plan
  std::string group;  // the [[outlet]] table it came from
  control_centre::Wishes settings;
};

// Groups of these outlets, each once, in the order of the profile.
std::vector<std::string> groups_of(const std::vector<Outlet>& outlets);

// A command of the control centre, criterion (3) of §5.5.
struct Command {
  double at_s = 0.0;
  std::vector<std::string> outlets;  // ids; empty: all
  bool switch_on = false;            // false: off
};

// A limit, declared before the run: [[expect]].
struct Expectation {
  std::string measure;        // a name of the judge's catalogue
  std::string unit;           // as the catalogue has it, or one it converts
  std::optional<double> min;  // in `unit`, inclusive
  std::optional<double> max;
  std::optional<std::string> equals;  // for measurements that are words: "open"
  std::vector<std::string> groups;    // outlets of these groups; empty: all
  int line = 0;                       // in the profile, for messages
};

struct Plan {
  std::string name;  // "paper/loss-500mw"
  std::string title;
  std::string source;  // where the case comes from
  std::string path;    // of the profile file, as opened
  std::string text;    // of the profile file, whole
  std::string sha256;  // of text, hexadecimal
  grid::Grid grid;
  Stimulus stimulus;
  std::vector<Outlet> outlets;            // at least one
  std::vector<Command> commands;          // ascending in time
  std::vector<Expectation> expectations;  // at least one
  std::uint64_t seed = 1;

  std::int64_t duration_ticks() const;
  std::shared_ptr<const waveform::ReferenceSignal> reference() const;
  waveform::Synthesizer synthesizer() const;
};

}  // namespace gsbench::profile
