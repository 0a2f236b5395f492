// The keys of an instrument file. Reading it, its JSON Schema and drivers/README.md follow them.
#include "instrument_names.hpp"

#include <utility>

#include <fmt/format.h>

#include <station/instrument_file.hpp>

namespace gsbench::station {
namespace {

using keys::Key;

template <class Enum, std::size_t Count>
Key one_of(const char* key, const names::Named<Enum> (&ones)[Count], const std::string& meaning) {
  std::vector<std::string> choices;
  std::string text = meaning;
  for (const names::Named<Enum>& one : ones) {
    choices.emplace_back(one.name);
    text += fmt::format("; `{}`: {}", one.name, one.meaning);
  }
  return keys::choice(key, choices, text);
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
          {one_of("set_as", names::kRateAs, "what is set").require(),
           keys::number("lowest_hz", "Hz", keys::above(0.0), "fewest points a second").require(),
           keys::number("highest_hz", "Hz", keys::above(0.0), "most points a second").require(),
           keys::number("resolution_hz", "Hz", keys::above(0.0), "step of what is set").require(),
           one_of("interpolation", names::kInterpolations, "the output between two points")
               .require()})
          .require(),
      keys::table(
          "memory", "for one waveform",
          {keys::whole("points", "", 2, 1e9, "longest waveform").require(),
           keys::whole("fewest_points", "", 2, 1e9, "shortest waveform").require(),
           keys::whole("packet_points", "", 2, 1e9, "largest packet").or_else("no packets")})
          .require(),
      keys::table("format", "of a waveform's points, two bytes each",
                  {keys::whole("bits", "", 8, 16, "resolution of the DAC").require(),
                   one_of("codes", names::kCodes, "how a level is coded").require(),
                   one_of("byte_order", names::kByteOrders, "of each point").require(),
                   one_of("block", names::kBlocks, "how an upload is sent").require()})
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
                   seconds("answer_s", "longest wait for an answer").by_default(2.0),
                   keys::number("upload_bytes_s", "byte/s", keys::above(0.0),
                                "slowest rate at which it takes a waveform; an answer may be "
                                "later by so much")
                       .by_default(1e5)})};
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
              command("is_on", "answers that mean on, separated by vertical bars").require(),
              command("is_off", "answers that mean off, separated by vertical bars").require(),
              command("next_error", "query of the error queue; 0 means no error")
                  .or_else("there is none")})
      .require();
}

Key setting_keys() {
  return keys::tables(
             "setting", "a setting and how it is asked back, in the order in which they are sent",
             {command("name", "for messages").require(),
              one_of("when", names::kWhen, "when it is sent").by_default("after upload"),
              keys::array("commands", command("", ""), "sent in this order").or_else("only asked"),
              command("query", "asks it back").require(),
              command("field", "the item of a comma list, by its number, or the name before it")
                  .or_else("the whole answer"),
              command("expected",
                      "the answer; texts may be alternatives, separated by vertical bars")
                  .require(),
              one_of("compare", names::kCompares, "how").by_default("text"),
              command("unit", "that may follow a number").or_else("none"),
              keys::number("tolerance", "", keys::at_least(0.0), "of a number, in its unit")
                  .by_default(0.0),
              keys::number("tolerance_ppm", "ppm", keys::at_least(0.0),
                           "of a number; the larger of both counts")
                  .by_default(0.0),
              one_of("if_missing", names::kMissing, "an answer without the item")
                  .by_default("refuse"),
              one_of("watched", names::kWatched, "when it is asked").by_default("yes")})
      .require();
}

std::vector<std::string> names_of_quirks() {
  std::vector<std::string> choices;
  for (const auto& quirk : names::kQuirks) {
    choices.emplace_back(quirk.name);
  }
  return choices;
}

std::string meaning_of_quirks() {
  std::string text;
  for (const auto& quirk : names::kQuirks) {
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
      one_of("verification", names::kVerifications, "how an upload is verified").require(),
      keys::array("quirks", keys::choice("", names_of_quirks(), ""), meaning_of_quirks())
          .permits("array of these names")
          .or_else("none")};
  const std::vector<Key> ranges = range_keys();
  all.insert(all.end(), ranges.begin(), ranges.end());
  all.push_back(dialect_keys());
  all.push_back(setting_keys());
  return keys::table("an instrument", "", std::move(all));
}

}  // namespace

const Key& instrument_keys() {
  static const Key keys = declared_instrument();
  return keys;
}

}  // namespace gsbench::station
