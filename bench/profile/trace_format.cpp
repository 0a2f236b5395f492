#include "sections.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <profile/load.hpp>

namespace gsbench::profile {
namespace {

using keys::Key;
using keys::Table;

template <std::size_t count>
std::vector<std::string> texts_of(const char* const (&texts)[count]) {
  return {std::begin(texts), std::end(texts)};
}

// "`%Y`, `%y`, …"
std::string directives() {
  std::string text = recording::kTimeDirectives;
  constexpr const char* kBetween = "`, `";
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 4)) {
    text.replace(at, 1, kBetween);
  }
  return '`' + text + '`';
}

Key column(const char* name, const char* of) {
  constexpr double kMostColumns = 1e6;
  return keys::text_or_whole(name, 1.0, kMostColumns,
                             fmt::format("name of the column of {}, or its number from 1", of));
}

// The options of recording::TraceFormat, with the names of its visit_fields().
std::vector<Key> format_keys() {
  constexpr double kMostRows = 1e6;
  return {
      column("time", "times: numbers, or date and time of day").require(),
      column("frequency", "frequencies").require(),
      column("voltage", "RMS voltages").or_else("none: nominal voltage"),
      keys::number("nominal_voltage", "as the column", keys::above(0.0), "voltage of 1 p.u.")
          .or_else("median of the played part"),
      keys::instant("from_s", keys::at_least(0.0),
                    "start of the part to play: seconds after the first time, or date and "
                    "time as in the recording, also without seconds, or a date, of which it is "
                    "midnight; the first row in it becomes time 0")
          .by_default(0.0),
      keys::instant("until_s", keys::above(0.0), "end of the part to play, as `from_s`")
          .permits("after `from_s`, or date and time")
          .or_else("to the end"),
      keys::text("delimiter",
                 "character between cells; `tab` or `\\t`; `space`: any number of blanks")
          .permits("one character that is no letter, digit, point, sign or quote; `tab`, `space`")
          .or_else("`,`; `;` if `decimal` is `,`"),
      keys::choice("decimal", {".", ","}, "decimal sign").by_default("."),
      keys::whole("skip_rows", "", 0, kMostRows, "lines above the header to skip").by_default(0.0),
      keys::whole("header_rows", "", 0, kMostRows,
                  "rows above the data; the first one has the names of the columns. 0: no header, "
                  "columns are given by number")
          .by_default(1.0),
      keys::choice("time_unit", texts_of(recording::kTimeUnits), "unit of times that are numbers")
          .by_default("s"),
      keys::text("time_format",
                 fmt::format("format of dates and times as for `strptime`, for example `%d.%m.%Y "
                             "%H:%M:%S`; may have {}; `%S` includes decimals",
                             directives()))
          .or_else("`2025-04-28 11:00:02.5`, `2025-04-28T11:00:02Z`, `28-Apr-2025 11:00:02`"),
      keys::choice("frequency_unit", texts_of(recording::kFrequencyUnits),
                   "unit of the frequencies; `pu`: of nominal")
          .by_default("Hz"),
      keys::number("frequency_offset_hz", "Hz", keys::between(-1e3, 1e3),
                   "is added to the frequencies: 50 for deviations from 50 Hz")
          .by_default(0.0),
      keys::array("gaps", keys::text("", ""),
                  "further words for a missing value, for example `[\"-999\", \"bad\"]`")};
}

struct ReadField {
  const Table& table;

  void operator()(const char* key, std::string& value) const {
    if (!table.has(key)) {
      return;
    }
    value = table.text(key);
    // A number is that of a column, also if a column has this name.
    const std::string name = key;
    if (table.holds_number(key) && (name == "time" || name == "frequency" || name == "voltage")) {
      value = '#' + value;
    }
  }
  void operator()(const char* key, double& value) const {
    value = table.find_number(key).value_or(value);
  }
  void operator()(const char* key, std::optional<double>& value) const {
    value = table.find_number(key);
  }
  void operator()(const char* key, std::vector<std::string>& value) const {
    for (const keys::PlacedText& item : table.texts(key)) {
      value.push_back(item.text);
    }
  }
};

struct WriteField {
  std::vector<std::string>& lines;

  void operator()(const char* key, const std::string& value) const {
    lines.push_back(fmt::format("{} = {}\n", key, keys::quoted(value)));
  }
  void operator()(const char* key, double value) const {
    lines.push_back(fmt::format("{} = {}\n", key, value));
  }
  void operator()(const char* key, const std::optional<double>& value) const {
    lines.push_back(value ? fmt::format("{} = {}\n", key, *value) : "");
  }
  void operator()(const char* key, const std::vector<std::string>& value) const {
    std::string items;
    for (const std::string& item : value) {
      items += (items.empty() ? "" : ", ") + keys::quoted(item);
    }
    lines.push_back(fmt::format("{} = [{}]\n", key, items));
  }
};

// The first line of options with texts that are not UTF-8, which TOML cannot hold: each of their
// bytes is the character of this number.
constexpr const char* kBytesAsCharacters = "# ISO 8859-1\n";

template <class Change>
void change_texts(recording::TraceFormat& format, Change change) {
  struct Visitor {
    const Change& change;
    void operator()(const char*, std::string& value) const { value = change(value); }
    void operator()(const char*, std::vector<std::string>& values) const {
      std::transform(values.begin(), values.end(), values.begin(), change);
    }
    void operator()(const char*, double&) const {}
    void operator()(const char*, std::optional<double>&) const {}
  };
  recording::visit_fields(format, Visitor{change});
}

std::string characters_of(const std::string& bytes) {
  std::string text;
  for (const char byte : bytes) {
    const auto code = static_cast<unsigned char>(byte);
    if (code < 0x80U) {
      text += byte;
    } else {
      text += static_cast<char>(0xc0U | (code >> 6U));
      text += static_cast<char>(0x80U | (code & 0x3fU));
    }
  }
  return text;
}

// The inverse of characters_of().
std::string bytes_of(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    if (first >= 0x80U && i + 1 < text.size()) {
      ++i;
      const auto second = static_cast<unsigned char>(text[i]);
      bytes += static_cast<char>(((first & 0x03U) << 6U) | (second & 0x3fU));
    } else {
      bytes += text[i];
    }
  }
  return bytes;
}

std::vector<std::string> lines_of(const recording::TraceFormat& format) {
  std::vector<std::string> lines;
  recording::visit_fields(format, WriteField{lines});
  return lines;
}

}  // namespace

Key trace_keys() {
  std::vector<Key> all = {
      keys::text("file", "path of the CSV file, relative to the profile").require()};
  for (Key& key : format_keys()) {
    all.push_back(std::move(key));
  }
  return keys::table(
      "trace",
      "A recording as CSV. The played part must be 0.1 … 10⁵ s long and stay within 0.5 … 1.5 of "
      "nominal. Rows outside `from_s` … `until_s`, and after `duration_s`, may have any content. A "
      "row in which a used column is empty, `NaN`, `-NaN`, `NA`, `N/A` or `null`, or has a word of "
      "`gaps`, is a gap, and the curve is interpolated across it. Columns are given by name, or by "
      "number from 1; with `--trace`, a name has precedence, and `#2` is always a number. Run "
      "records and reports contain the file name, how it was read and the SHA-256 of the content; "
      "records also the played part. `--trace` on the command line, with an "
      "option for each of these keys (`--trace-from` for `from_s`), plays another recording, in "
      "place of the profile's losses, frequency points or recording, oscillations, tones, flicker, "
      "amplitude steps and phase steps; noise, harmonics and DC offset stay. It is played to its "
      "end, or to `--trace-until`, also if this is beyond the profile's `duration_s`.",
      std::move(all));
}

recording::TraceFormat read_trace_format(const Table& table) {
  recording::TraceFormat format;
  recording::visit_fields(format, ReadField{table});
  return format;
}

std::string trace_options(const recording::TraceFormat& format) {
  recording::TraceFormat written = format;
  std::string text;
  bool is_utf8 = true;
  change_texts(written, [&](const std::string& value) {
    is_utf8 = is_utf8 && recording::is_utf8(value);
    return value;
  });
  if (!is_utf8) {
    text = kBytesAsCharacters;
    change_texts(written, characters_of);
  }
  const std::vector<std::string> defaults = lines_of({});
  const std::vector<std::string> lines = lines_of(written);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += lines[i] == defaults[i] ? "" : lines[i];
  }
  return text;
}

recording::TraceFormat trace_format(const std::string& options) {
  static const Key keys = keys::table("the options of a recording", "", format_keys());
  const keys::Document document = keys::parse_toml(options, "options");
  recording::TraceFormat format = read_trace_format(Table(document, keys));
  if (options.rfind(kBytesAsCharacters, 0) == 0) {
    change_texts(format, bytes_of);
  }
  return format;
}

}  // namespace gsbench::profile
