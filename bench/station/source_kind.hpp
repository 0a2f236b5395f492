// The kinds of sources that a station file can name in [source]. A new kind has a file of its own
// and one row in source_kind.cpp. A physical station makes the driver with the port of an
// instrument. An emulated station makes the same driver with the port of its emulator.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <keys/table.hpp>
#include <profile/plan.hpp>
#include <relay/relay_sense.hpp>
#include <source/source.hpp>

namespace gsbench::station {

// What a driver needs apart from the keys of its own kind.
struct SourceSettings {
  double nominal_v = 230.0;      // RMS, at the outlets
  double gain = 1.0;             // volts at the outlets for one volt at the source's output
  double voltage_limit_v = 0.0;  // RMS at the outlets; √2 times this is the largest peak
  double boot_s = 30.0;          // nominal voltage before the stimulus: outlets boot and join
  profile::Tolerances tolerances;
  double make_safe_s = 10.0;  // how long make_safe() tries again; 0: one attempt
};

// A source, and the relay sense on the same connection if there is one (else null). Aliases of one
// object are permitted.
struct BuiltSource {
  std::shared_ptr<source::Source> source;
  std::shared_ptr<relay::RelaySense> relay_sense;
  std::int64_t sample_rate_hz = 8000;  // of the stimulus, for relay senses of other kinds
};

// Makes the driver. Opens no port: the driver connects in prepare(), or in make_safe() if it is not
// connected. `port`: for transport::make_transport(). Throws std::runtime_error if an instrument
// file cannot be read.
using SourceFactory =
    std::function<BuiltSource(const std::string& port, const SourceSettings& settings)>;

struct SourceKind {
  std::string name;             // value of `kind` in [source]
  std::string meaning;          // for the documentation
  std::vector<keys::Key> keys;  // of [source], for this kind only; they may not be `required`
  // Reads and checks the keys of this kind. Relative paths are relative to `file_path`. Throws
  // keys::ConfigurationError.
  SourceFactory (*read)(const keys::Table& source, const std::string& file_path);
};

const std::vector<SourceKind>& source_kinds();

// Each is defined in its own source file.
SourceKind scpi_source_kind();
SourceKind head_source_kind();

// Keys of [source]: `kind`, those that all kinds share, and those of each kind. Without `port`.
std::vector<keys::Key> source_keys();
// Reads them. The tolerances are those of a profile by default. Refuses keys of other kinds.
SourceSettings read_source_settings(const keys::Table& source);
SourceFactory read_source_factory(const keys::Table& source, const std::string& file_path);

}  // namespace gsbench::station
