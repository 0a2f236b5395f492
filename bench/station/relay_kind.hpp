// The kinds of relay senses that a station file can name in [relay]. A new kind has one row in
// relay_kind.cpp.
#pragma once

#include "source_kind.hpp"

#include <memory>
#include <string>
#include <vector>

#include <relay/relay_sense.hpp>

namespace gsbench::station {

struct RelayKind {
  std::string name;        // value of `kind` in [relay]
  std::string meaning;     // for the documentation
  std::string channel;     // form of an outlet's `relay`, for messages and the documentation
  std::string aligned_by;  // how its clock is aligned with the source's, for reports
  bool (*is_channel)(const std::string& channel);
  // The same for two names of one channel.
  std::string (*identity)(const std::string& channel);
  // Kind of source that it is part of; empty: it is independent of the source.
  std::string of_source;
  // The port that it opens for a channel; empty: none but that of the source.
  std::string (*port_of)(const std::string& channel);
  // Channel i of `channels` (each once) has this number in Slot::relay_channel.
  std::size_t (*number_of)(const std::vector<std::string>& channels, std::size_t i);
  // Opens no port. `source` outlives the relay sense.
  std::shared_ptr<relay::RelaySense> (*make)(const std::vector<std::string>& channels,
                                             const BuiltSource& source);
};

const std::vector<RelayKind>& relay_kinds();

// Each is defined in its own source file.
RelayKind head_relay_kind();
RelayKind modem_line_relay_kind();

// Keys of [relay].
std::vector<keys::Key> relay_keys();
const RelayKind& read_relay_kind(const keys::Table& relay);

}  // namespace gsbench::station
