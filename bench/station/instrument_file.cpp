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

using keys::Key;
using keys::Table;

template <class Enum>
struct Named {
  const char* name;
  Enum value;
  const char* meaning;
};

// The texts of each closed set of values, in one place.
constexpr Named<scpi::RateAs> kRateAs[] = {
    {"sample rate", scpi::RateAs::kSampleRate, "points a second"},
    {"frequency", scpi::RateAs::kFrequency, "repetitions of the whole memory a second"}};
constexpr Named<scpi::Interpolation> kInterpolations[] = {
    {"hold", scpi::Interpolation::kHold, "a point is held until the next"},
    {"linear", scpi::Interpolation::kLinear, "points are joined by straight lines"}};
constexpr Named<scpi::Codes> kCodes[] = {
    {"signed", scpi::Codes::kSigned, "16 bits, −32 767 … 32 767 whatever `bits` is"},
    {"unsigned", scpi::Codes::kUnsigned, "0 … 2^bits − 1"}};
constexpr Named<scpi::ByteOrder> kByteOrders[] = {
    {"little", scpi::ByteOrder::kLittle, "low byte first"},
    {"big", scpi::ByteOrder::kBig, "high byte first"}};
constexpr Named<scpi::Block> kBlocks[] = {
    {"raw", scpi::Block::kRaw, "the bytes follow the header"},
    {"block", scpi::Block::kBlock, "IEEE 488.2, `#<digits><bytes>`"},
    {"packets", scpi::Block::kPackets, "several such blocks of `packet_points`"}};
constexpr Named<scpi::Verification> kVerifications[] = {
    {"read back", scpi::Verification::kReadBack, "the waveform is read and compared byte for byte"},
    {"error queue", scpi::Verification::kErrorQueue, "the error queue must be empty"},
    {"none", scpi::Verification::kNone, "the instrument has no means"}};
constexpr Named<scpi::Quirk> kQuirks[] = {
    {"avoid newline", scpi::Quirk::kAvoidNewline,
     "a byte 0x0A in the waveform ends the message; codes are moved off it"},
    {"fixed length", scpi::Quirk::kFixedLength, "a waveform always fills the memory"},
    {"upload switches on", scpi::Quirk::kUploadSwitchesOn,
     "an upload may switch the output on; it is switched off again"},
    {"silent if unknown", scpi::Quirk::kSilentIfUnknown,
     "unknown queries are not answered; the next one is"}};
constexpr Named<scpi::When> kWhen[] = {
    {"before upload", scpi::When::kBeforeUpload, "before the waveform is loaded"},
    {"after upload", scpi::When::kAfterUpload, "after it"}};
constexpr Named<scpi::Compare> kCompares[] = {
    {"text", scpi::Compare::kText, "in any case"},
    {"number", scpi::Compare::kNumber, "within the tolerance"}};
constexpr Named<bool> kMissing[] = {{"refuse", false, "an error"},
                                    {"accept", true, "not compared"}};
constexpr Named<bool> kWatched[] = {{"yes", true, "also while the waveform plays"},
                                    {"no", false, "only before"}};

template <class Enum, std::size_t Count>
Key one_of(const char* key, const Named<Enum> (&ones)[Count], const std::string& meaning) {
  std::vector<std::string> names;
  std::string text = meaning;
  for (const Named<Enum>& one : ones) {
    names.emplace_back(one.name);
    text += fmt::format("; `{}`: {}", one.name, one.meaning);
  }
  return keys::choice(key, names, text);
}

template <class Enum, std::size_t Count>
Enum value_of(const std::string& name, const Named<Enum> (&ones)[Count]) {
  return std::find_if(std::begin(ones), std::end(ones),
                      [&](const Named<Enum>& one) { return name == one.name; })
      ->value;
}

Key command(const char* name, const char* meaning) {
  return keys::text(name, meaning);
}

Key seconds(const char* name, const char* meaning) {
  return keys::number(name, "s", keys::between(0.0, 60.0), meaning);
}

std::vector<Key> range_keys() {
  return {
      keys::table("amplitude", "at the open output, peak to peak",
                  {keys::number("lowest_vpp", "V", keys::above(0.0), "lowest").require(),
                   keys::number("highest_vpp", "V", keys::above(0.0), "highest").require(),
                   keys::number("resolution_vpp", "V", keys::above(0.0), "step").require()})
          .require(),
      keys::table(
          "rate", "how fast points are played",
          {one_of("set_as", kRateAs, "what is set").require(),
           keys::number("lowest_hz", "Hz", keys::above(0.0), "fewest points a second").require(),
           keys::number("highest_hz", "Hz", keys::above(0.0), "most points a second").require(),
           keys::number("resolution_hz", "Hz", keys::above(0.0), "step of what is set").require(),
           one_of("interpolation", kInterpolations, "the output between two points").require()})
          .require(),
      keys::table(
          "memory", "for one waveform",
          {keys::whole("points", "", 2, 1e9, "longest waveform").require(),
           keys::whole("fewest_points", "", 2, 1e9, "shortest waveform").require(),
           keys::whole("packet_points", "", 2, 1e9, "largest packet").or_else("no packets")})
          .require(),
      keys::table("format", "of a waveform's points, two bytes each",
                  {keys::whole("bits", "", 8, 16, "resolution of the DAC").require(),
                   one_of("codes", kCodes, "how a level is coded").require(),
                   one_of("byte_order", kByteOrders, "of each point").require(),
                   one_of("block", kBlocks, "how an upload is sent").require()})
          .require(),
      keys::table(
          "accuracy", "from the maker's table; nothing is calibrated",
          {keys::number("clock_ppm", "ppm", keys::at_least(0.0), "error of the time base, ±")
               .require(),
           keys::number("amplitude_pct", "%", keys::at_least(0.0), "error of the amplitude, ±")
               .require(),
           seconds("trigger_latency_s", "from sending the trigger to the first point").require(),
           seconds("trigger_uncertainty_s", "of that, ±").require()})
          .require(),
      keys::table("timing", "pauses that the instrument needs",
                  {seconds("command_s", "after a command").by_default(0.0),
                   seconds("packet_s", "after a packet").by_default(0.0),
                   seconds("reset_s", "after the reset").by_default(0.0),
                   seconds("upload_s", "after the upload").by_default(0.0),
                   seconds("answer_s", "longest wait for an answer").by_default(2.0)})};
}

Key dialect_keys() {
  return keys::table(
             "dialect",
             "commands, with the placeholders `{channel}`, `{name}` of the waveform, `{points}`, "
             "`{bytes}`, `{rate_hz}`, `{frequency_hz}` of the whole memory, `{amplitude_vpp}`, "
             "`{offset_v}`, `{part}` of a packet",
             {keys::array("reset", command("", ""), "after the output was switched off")
                  .or_else("none"),
              command("clear", "frees the memory before an upload").or_else("not needed"),
              command("upload", "header of the upload, or of a packet, up to the block").require(),
              command("more_part", "`{part}` of a packet that is not the last")
                  .or_else("no packets"),
              command("last_part", "`{part}` of the last packet").or_else("no packets"),
              command("read_back",
                      "query of the waveform; the answer has `LENGTH,<bytes>B` and "
                      "`WAVEDATA,<bytes>`")
                  .or_else("cannot be read"),
              command("trigger", "plays the waveform once").require(),
              command("output_on", "switches the output on").require(),
              command("output_off", "switches the output off").require(),
              command("output_query", "asks for the state of the output").require(),
              command("output_field",
                      "the item of a comma list, by its number, or the name before "
                      "it")
                  .or_else("the whole answer"),
              command("is_on", "answers that mean on, separated by `|`").require(),
              command("is_off", "answers that mean off, separated by `|`").require(),
              command("next_error", "query of the error queue; 0 means no error")
                  .or_else("there is none")})
      .require();
}

Key setting_keys() {
  return keys::tables(
             "setting", "a setting and how it is asked back, in the order in which they are sent",
             {command("name", "for messages").require(),
              one_of("when", kWhen, "when it is sent").by_default("after upload"),
              keys::array("commands", command("", ""), "sent in this order").or_else("only asked"),
              command("query", "asks it back").require(),
              command("field", "the item of a comma list, by its number, or the name before it")
                  .or_else("the whole answer"),
              command("expected", "the answer; texts may be alternatives, separated by `|`")
                  .require(),
              one_of("compare", kCompares, "how").by_default("text"),
              command("unit", "that may follow a number").or_else("none"),
              keys::number("tolerance", "", keys::at_least(0.0), "of a number, in its unit")
                  .by_default(0.0),
              keys::number("tolerance_ppm", "ppm", keys::at_least(0.0),
                           "of a number; the larger of both counts")
                  .by_default(0.0),
              one_of("if_missing", kMissing, "an answer without the item").by_default("refuse"),
              one_of("watched", kWatched, "when it is asked").by_default("yes")})
      .require();
}

std::vector<std::string> names_of_quirks() {
  std::vector<std::string> names;
  for (const auto& quirk : kQuirks) {
    names.emplace_back(quirk.name);
  }
  return names;
}

std::string meaning_of_quirks() {
  std::string text;
  for (const auto& quirk : kQuirks) {
    text += fmt::format("{}`{}`: {}", text.empty() ? "" : "; ", quirk.name, quirk.meaning);
  }
  return text;
}

Key declared_instrument() {
  std::vector<Key> all = {
      keys::text("title", "maker and model").require(),
      keys::array("identity", keys::text("", ""),
                  "how an answer to `*IDN?` begins; `?` stands for any character")
          .require(),
      one_of("verification", kVerifications, "how an upload is verified").require(),
      keys::array("quirks", keys::choice("", names_of_quirks(), ""), meaning_of_quirks())
          .permits("array of these names")
          .or_else("none")};
  const std::vector<Key> ranges = range_keys();
  all.insert(all.end(), ranges.begin(), ranges.end());
  all.push_back(dialect_keys());
  all.push_back(setting_keys());
  return keys::table("an instrument", "", std::move(all));
}

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
  instrument.rate = {value_of(rate.text("set_as"), kRateAs), rate.number("lowest_hz"),
                     rate.number("highest_hz"), rate.number("resolution_hz"),
                     value_of(rate.text("interpolation"), kInterpolations)};
  const Table memory = top.table("memory");
  instrument.memory = {memory.whole("points"), memory.whole("fewest_points"),
                       memory.find_whole("packet_points").value_or(0)};
  const Table format = top.table("format");
  instrument.format = {
      static_cast<int>(format.whole("bits")), value_of(format.text("codes"), kCodes),
      value_of(format.text("byte_order"), kByteOrders), value_of(format.text("block"), kBlocks)};
  const Table accuracy = top.table("accuracy");
  instrument.accuracy = {accuracy.number("clock_ppm"), accuracy.number("amplitude_pct"),
                         accuracy.number("trigger_latency_s"),
                         accuracy.number("trigger_uncertainty_s")};
  if (top.has("timing")) {
    const Table timing = top.table("timing");
    instrument.timing = {timing.number("command_s"), timing.number("packet_s"),
                         timing.number("reset_s"), timing.number("upload_s"),
                         timing.number("answer_s")};
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
          value_of(setting.text("when"), kWhen),
          texts_of(setting, "commands"),
          {setting.text("query"), text_or_none(setting, "field")},
          setting.text("expected"),
          value_of(setting.text("compare"), kCompares),
          setting.number("tolerance"),
          setting.number("tolerance_ppm"),
          text_or_none(setting, "unit"),
          value_of(setting.text("if_missing"), kMissing),
          value_of(setting.text("watched"), kWatched)};
}

scpi::Instrument read_instrument(const profile::NamedFile& file) {
  const keys::Document document = keys::parse_toml(profile::read_file(file.path), file.path);
  const Table top(document, instrument_keys());
  scpi::Instrument instrument;
  instrument.name = file.name;
  instrument.title = top.text("title");
  instrument.identity = texts_of(top, "identity");
  instrument.verification = value_of(top.text("verification"), kVerifications);
  for (const std::string& quirk : texts_of(top, "quirks")) {
    instrument.quirks.push_back(value_of(quirk, kQuirks));
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

const Key& instrument_keys() {
  static const Key keys = declared_instrument();
  return keys;
}

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
