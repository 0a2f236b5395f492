// [source] and [relay] of an emulated station.
#include "emulated_instrument.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <emulation/head_emulator.hpp>

namespace gsbench::station {
namespace {

constexpr double kMostInstrument_ppm = 1000.0;

struct EmulatedModel {
  const char* name;
  const char* instrument;  // of drivers/source/scpi/instruments
  emulation::GeneratorModel model;
};
constexpr EmulatedModel kEmulatedModels[] = {
    {"sdg1032x", "siglent-sdg1000x", emulation::GeneratorModel::kSdg1032x},
    {"sdg2042x", "siglent-sdg2000x", emulation::GeneratorModel::kSdg2042x},
    {"dg1062z", "rigol-dg1000z", emulation::GeneratorModel::kDg1062z},
    {"33522b", "keysight-33500b", emulation::GeneratorModel::k33522b}};

struct SenseKind {
  const char* name;
  const char* meaning;
  EmulatedSense sense;
};
constexpr SenseKind kSenseKinds[] = {
    {"terminals", "at the outlets' terminals, in true time", EmulatedSense::kTerminals},
    {"head", "the inputs of the emulated DAC head", EmulatedSense::kHead},
    {"modem", "modem lines of emulated serial adapters", EmulatedSense::kModemLine}};

template <class Row, std::size_t kRows>
std::vector<std::string> names_of(const Row (&rows)[kRows]) {
  std::vector<std::string> names;
  for (const Row& row : rows) {
    names.emplace_back(row.name);
  }
  return names;
}

emulation::GeneratorModel read_model(const keys::Table& source) {
  const auto model = source.find_text("emulates");
  const std::string instrument = source.find_text("instrument").value_or("");
  for (const EmulatedModel& row : kEmulatedModels) {
    if (model ? *model == row.name : instrument == row.instrument) {
      return row.model;
    }
  }
  source.refuse_missing("emulates",
                        fmt::format("the model to emulate for the instrument \"{}\": emulates = "
                                    "\"sdg2042x\", …",
                                    instrument));
}

EmulatedSense read_sense(const keys::Table& top, bool is_head, std::size_t outlets) {
  if (!top.has("relay")) {
    return is_head ? EmulatedSense::kHead : EmulatedSense::kTerminals;
  }
  const keys::Table relay = top.table("relay");
  const std::string name = relay.text("kind");
  const auto* kind = std::find_if(std::begin(kSenseKinds), std::end(kSenseKinds),
                                  [&](const SenseKind& known) { return known.name == name; });
  if (kind->sense == EmulatedSense::kHead && !is_head) {
    relay.refuse("kind", "kind is \"head\", which needs a source of kind \"head\"");
  }
  if (kind->sense == EmulatedSense::kHead && outlets > emulation::HeadEmulator::kContacts) {
    relay.refuse("kind", fmt::format("kind is \"head\"; a head has {} inputs, the station {} "
                                     "outlets",
                                     emulation::HeadEmulator::kContacts, outlets));
  }
  return kind->sense;
}

}  // namespace

std::vector<keys::Key> instrument_station_keys() {
  std::vector<keys::Key> source = source_keys();
  source.push_back(
      keys::choice("emulates", names_of(kEmulatedModels), "model of generator that is emulated")
          .or_else("that of `instrument`"));
  source.push_back(keys::number("clock_error_ppm", "ppm",
                                keys::between(-kMostInstrument_ppm, kMostInstrument_ppm),
                                "true error of the emulated instrument's clock; positive: fast")
                       .by_default(0.0));
  std::string meaning;
  for (const SenseKind& kind : kSenseKinds) {
    meaning += fmt::format("{}`{}`: {}", meaning.empty() ? "" : "; ", kind.name, kind.meaning);
  }
  return {
      keys::table("source",
                  "An emulated instrument, which the driver of physical ones plays on. Without "
                  "`[source]`, the voltage is fed to the outlets directly.",
                  source),
      keys::table("relay",
                  "The relay sense of an instrument. By default `head` if that is the source, else "
                  "`terminals`.",
                  {keys::choice("kind", names_of(kSenseKinds), meaning)
                       .require("the kind of relay sense, kind = …")})};
}

std::optional<InstrumentOptions> read_instrument_options(
    const keys::Table& top, const std::string& file_path,
    const std::vector<emulation::HardwareOutlet>& outlets) {
  if (!top.has("source")) {
    if (top.has("relay")) {
      top.refuse("relay", "[relay] is given without [source]");
    }
    return std::nullopt;
  }
  const keys::Table source = top.table("source");
  InstrumentOptions options;
  options.settings = read_source_settings(source);
  options.make_source = read_source_factory(source, file_path);
  options.clock_ppm = source.number("clock_error_ppm");
  const bool is_head = source.text("kind") == "head";
  if (!is_head) {
    options.generator = read_model(source);
  } else if (source.has("emulates")) {
    source.refuse("emulates", "emulates is not a key of a source of kind \"head\"");
  }
  options.sense = read_sense(top, is_head, outlets.size());
  return options;
}

}  // namespace gsbench::station
