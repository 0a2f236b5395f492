#include "instrument_names.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <installation/installation.hpp>
#include <keys/table.hpp>
#include <station/instrument_file.hpp>

namespace gsbench::station {
namespace {

namespace fs = std::filesystem;

using keys::Table;

std::vector<std::string> texts_of(const Table& table, const char* key) {
  std::vector<std::string> texts;
  for (const keys::PlacedText& text : table.texts(key)) {
    texts.push_back(text.text);
  }
  return texts;
}

std::string text_or_none(const Table& table, const char* key) {
  return table.find_text(key).value_or("");
}

void read_ranges(const Table& top, scpi::Instrument& instrument) {
  const Table amplitude = top.table("amplitude");
  instrument.amplitude = {amplitude.number("lowest_vpp"), amplitude.number("highest_vpp"),
                          amplitude.number("resolution_vpp")};
  const Table rate = top.table("rate");
  instrument.rate = {names::value_of(rate.text("set_as"), names::kRateAs), rate.number("lowest_hz"),
                     rate.number("highest_hz"), rate.number("resolution_hz"),
                     names::value_of(rate.text("interpolation"), names::kInterpolations)};
  const Table memory = top.table("memory");
  instrument.memory = {memory.whole("points"), memory.whole("fewest_points"),
                       memory.find_whole("packet_points").value_or(0)};
  const Table format = top.table("format");
  instrument.format = {static_cast<int>(format.whole("bits")),
                       names::value_of(format.text("codes"), names::kCodes),
                       names::value_of(format.text("byte_order"), names::kByteOrders),
                       names::value_of(format.text("block"), names::kBlocks)};
  const Table accuracy = top.table("accuracy");
  instrument.accuracy = {accuracy.number("clock_ppm"), accuracy.number("amplitude_pct"),
                         accuracy.number("trigger_latency_s"),
                         accuracy.number("trigger_uncertainty_s")};
  if (top.has("timing")) {
    const Table timing = top.table("timing");
    instrument.timing = {timing.number("command_s"), timing.number("packet_s"),
                         timing.number("reset_s"),   timing.number("upload_s"),
                         timing.number("answer_s"),  timing.number("upload_bytes_s")};
  }
}

scpi::Dialect read_dialect(const Table& dialect) {
  return {texts_of(dialect, "reset"),
          text_or_none(dialect, "clear"),
          dialect.text("upload"),
          text_or_none(dialect, "more_part"),
          text_or_none(dialect, "last_part"),
          text_or_none(dialect, "read_back"),
          dialect.text("trigger"),
          dialect.text("output_on"),
          dialect.text("output_off"),
          {dialect.text("output_query"), text_or_none(dialect, "output_field")},
          dialect.text("is_on"),
          dialect.text("is_off"),
          text_or_none(dialect, "next_error")};
}

scpi::Setting read_setting(const Table& setting) {
  return {setting.text("name"),
          names::value_of(setting.text("when"), names::kWhen),
          texts_of(setting, "commands"),
          {setting.text("query"), text_or_none(setting, "field")},
          setting.text("expected"),
          names::value_of(setting.text("compare"), names::kCompares),
          setting.number("tolerance"),
          setting.number("tolerance_ppm"),
          text_or_none(setting, "unit"),
          names::value_of(setting.text("if_missing"), names::kMissing),
          names::value_of(setting.text("watched"), names::kWatched)};
}

void refuse_bad(const Table& table, const std::string& key, const keys::PlacedText& text) {
  const bool is_field = key == "field" || key == "output_field";
  const drivers::Status checked =
      is_field ? scpi::check_field(text.text) : scpi::check_text(text.text);
  if (!checked.ok()) {
    table.refuse(text.at, fmt::format("{}: {}", key, checked.error()));
  }
}

// Refuses commands, queries and answers that the driver could not use.
void check_texts(const Table& table, const keys::Key& declared) {
  for (const keys::Key& key : declared.inner) {
    if (key.type == keys::Type::kText && table.has(key.name)) {
      refuse_bad(table, key.name, {table.text(key.name), table.at(key.name)});
    } else if (key.type == keys::Type::kArray) {
      for (const keys::PlacedText& text : table.texts(key.name)) {
        refuse_bad(table, key.name, text);
      }
    }
  }
}

void check_texts(const Table& top) {
  for (const keys::Key& key : instrument_keys().inner) {
    if (key.name == "dialect") {
      check_texts(top.table(key.name), key);
    } else if (key.type == keys::Type::kTables) {
      for (const Table& table : top.tables(key.name)) {
        check_texts(table, key);
      }
    }
  }
}

scpi::Instrument read_instrument(const profile::NamedFile& file) {
  const keys::Document document = keys::parse_toml(profile::read_file(file.path), file.path);
  const Table top(document, instrument_keys());
  check_texts(top);
  scpi::Instrument instrument;
  instrument.name = file.name;
  instrument.title = top.text("title");
  instrument.identity = texts_of(top, "identity");
  instrument.verification = names::value_of(top.text("verification"), names::kVerifications);
  for (const std::string& quirk : texts_of(top, "quirks")) {
    instrument.quirks.push_back(names::value_of(quirk, names::kQuirks));
  }
  read_ranges(top, instrument);
  instrument.dialect = read_dialect(top.table("dialect"));
  for (const Table& setting : top.tables("setting")) {
    instrument.settings.push_back(read_setting(setting));
  }
  if (const drivers::Status checked = scpi::check(instrument); !checked.ok()) {
    throw keys::ConfigurationError(fmt::format("{}: {}", file.path, checked.error()));
  }
  return instrument;
}

}  // namespace

std::vector<profile::NamedFile> all_instruments() {
  std::vector<profile::NamedFile> found;
  for (const fs::path& folder :
       {installation::shipped("instruments"), installation::user_data("instruments")}) {
    std::error_code ignored;  // the user's folder need not exist
    for (fs::directory_iterator at(folder, ignored), end; at != end; at.increment(ignored)) {
      if (at->path().extension() == ".toml") {
        found.push_back({at->path().stem().string(), at->path().string()});
      }
    }
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return found;
}

scpi::Instrument load_instrument(const std::string& name_or_path, const std::string& beside) {
  if (fs::path(name_or_path).extension() == ".toml") {
    const std::string path = profile::resolve(name_or_path, beside);
    if (!profile::is_regular_file(path)) {
      throw NoSuchInstrument(
          fmt::format("instrument is \"{}\", which is not an existing file", name_or_path));
    }
    return read_instrument({fs::path(path).stem().string(), path});
  }
  const std::vector<profile::NamedFile> known = all_instruments();
  const auto named = [&](const profile::NamedFile& file) { return file.name == name_or_path; };
  const auto found = std::find_if(known.begin(), known.end(), named);
  if (found == known.end()) {
    throw NoSuchInstrument(fmt::format(
        "unknown instrument \"{}\"{} (for your own file, give its path, ending in .toml)",
        name_or_path, keys::suggestion(name_or_path, profile::names_of(known), "instruments")));
  }
  if (const auto twin = std::find_if(found + 1, known.end(), named); twin != known.end()) {
    throw NoSuchInstrument(
        fmt::format("{} and {} have the same name; rename one, or give "
                    "a path",
                    found->path, twin->path));
  }
  return read_instrument(*found);
}

}  // namespace gsbench::station
