#include "source_kind.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace gsbench::station {
namespace {

constexpr double kHighest_v = 1000.0;  // low voltage ends here
constexpr double kLongestBoot_s = 600.0;

const SourceKind& kind_of(const keys::Table& source) {
  const std::string name = source.text("kind");
  return *std::find_if(source_kinds().begin(), source_kinds().end(),
                       [&](const SourceKind& kind) { return kind.name == name; });
}

}  // namespace

const std::vector<SourceKind>& source_kinds() {
  static const std::vector<SourceKind> kinds = {scpi_source_kind(), head_source_kind()};
  return kinds;
}

std::vector<keys::Key> source_keys() {
  std::vector<std::string> names;
  std::string meaning;
  std::vector<keys::Key> own;
  for (const SourceKind& kind : source_kinds()) {
    names.push_back(kind.name);
    meaning += (meaning.empty() ? "`" : "; `") + kind.name + "`: " + kind.meaning;
    own.insert(own.end(), kind.keys.begin(), kind.keys.end());
  }
  const SourceSettings usual;
  std::vector<keys::Key> all = {
      keys::choice("kind", names, meaning).require("the kind of source, kind = …"),
      keys::number("nominal_v", "V", {0.0, kHighest_v, true}, "nominal voltage at the outlets, RMS")
          .by_default(usual.nominal_v),
      keys::number("gain", "V/V", keys::above(0.0),
                   "volts at the outlets for one volt at the source's output: gain of the "
                   "amplifier, times the ratio of the transformer")
          .require("volts at the outlets for one volt at the source's output, gain = …"),
      keys::number("voltage_limit_v", "V", {0.0, kHighest_v, true},
                   "interlock, RMS at the outlets: a peak above √2 times this value is never "
                   "commanded; a profile that needs more is refused")
          .require("the interlock, RMS at the outlets, e.g. voltage_limit_v = 265.0"),
      keys::number("boot_s", "s", keys::between(0.0, kLongestBoot_s),
                   "longest wait at nominal voltage for the outlets to boot and join; Wi-Fi takes "
                   "10 to 30 s. An outlet that joins later is faulty")
          .by_default(usual.boot_s)};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

SourceSettings read_source_settings(const keys::Table& source) {
  SourceSettings settings;
  settings.nominal_v = source.number("nominal_v");
  settings.gain = source.number("gain");
  settings.voltage_limit_v = source.number(
      "voltage_limit_v",
      {settings.nominal_v, kHighest_v, false, false, "nominal_v, which outlets need to boot"});
  settings.boot_s = source.number("boot_s");
  return settings;
}

SourceFactory read_source_factory(const keys::Table& source, const std::string& file_path) {
  const SourceKind& own = kind_of(source);
  for (const SourceKind& kind : source_kinds()) {
    for (const keys::Key& key : kind.keys) {
      const bool shared = std::any_of(own.keys.begin(), own.keys.end(),
                                      [&](const keys::Key& mine) { return mine.name == key.name; });
      if (!shared && source.has(key.name)) {
        source.refuse(key.name, fmt::format("{} is not a key of a source of kind \"{}\"", key.name,
                                            own.name));
      }
    }
  }
  return own.read(source, file_path);
}

}  // namespace gsbench::station
