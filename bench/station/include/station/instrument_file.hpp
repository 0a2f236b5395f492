// Instrument files describe models of waveform generators (source_scpi/instrument.hpp). The shipped
// ones are in share/gsbench/instruments, the user's own in $XDG_DATA_HOME/gsbench/instruments.
// drivers/README.md documents every key.
#pragma once

#include <source_scpi/instrument.hpp>

#include <string>
#include <vector>

#include <keys/document.hpp>
#include <keys/key.hpp>
#include <profile/files.hpp>

namespace gsbench::station {

const keys::Key& instrument_keys();

// A name or path that leads to no instrument file, or to two. what() has no place in a file: the
// caller knows where the name stands.
class NoSuchInstrument : public keys::ConfigurationError {
 public:
  using keys::ConfigurationError::ConfigurationError;
};

// `name_or_path`: the name of a shipped or own instrument ("siglent-sdg2000x"), or the path of a
// .toml file; a relative one is relative to the folder of the file `beside`. Throws
// NoSuchInstrument, and keys::ConfigurationError with file and line for an error in the file.
scpi::Instrument load_instrument(const std::string& name_or_path, const std::string& beside = "");

// Shipped and own, sorted by name.
std::vector<profile::NamedFile> all_instruments();

}  // namespace gsbench::station
