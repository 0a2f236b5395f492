#include "relay_kind.hpp"

#include <algorithm>

namespace gsbench::station {

const std::vector<RelayKind>& relay_kinds() {
  static const std::vector<RelayKind> kinds = {head_relay_kind(), modem_line_relay_kind()};
  return kinds;
}

std::vector<keys::Key> relay_keys() {
  std::vector<std::string> names;
  std::string meaning;
  for (const RelayKind& kind : relay_kinds()) {
    names.push_back(kind.name);
    meaning += (meaning.empty() ? "`" : "; `") + kind.name + "`: " + kind.meaning;
  }
  return {keys::choice("kind", names, meaning).require("the kind of relay sense, kind = …")};
}

const RelayKind& read_relay_kind(const keys::Table& relay) {
  const std::string name = relay.text("kind");
  return *std::find_if(relay_kinds().begin(), relay_kinds().end(),
                       [&](const RelayKind& kind) { return kind.name == name; });
}

}  // namespace gsbench::station
