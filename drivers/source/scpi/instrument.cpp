#include "text.hpp"
#include <source_scpi/instrument.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

const std::vector<std::string>& known_placeholders() {
  static const std::vector<std::string> names = {"channel",       "name",     "points",
                                                 "bytes",         "rate_hz",  "frequency_hz",
                                                 "amplitude_vpp", "offset_v", "part"};
  return names;
}

bool begins_with(const std::string& text, const std::string& pattern) {
  return text.size() >= pattern.size() &&
         std::equal(pattern.begin(), pattern.end(), text.begin(),
                    [](char wanted, char found) { return wanted == '?' || wanted == found; });
}

std::vector<std::string> templates_of(const Instrument& instrument) {
  const Dialect& dialect = instrument.dialect;
  std::vector<std::string> all = {dialect.clear,     dialect.upload,    dialect.read_back,
                                  dialect.trigger,   dialect.output_on, dialect.output_off,
                                  dialect.is_on,     dialect.is_off,    dialect.output.query,
                                  dialect.next_error};
  all.insert(all.end(), dialect.reset.begin(), dialect.reset.end());
  for (const Setting& setting : instrument.settings) {
    all.insert(all.end(), setting.commands.begin(), setting.commands.end());
    all.push_back(setting.asked.query);
    all.push_back(setting.expected);
  }
  return all;
}

// The first of these that does not hold.
struct Rule {
  bool holds;
  const char* text;
};

}  // namespace

bool Instrument::has(Quirk quirk) const {
  return std::find(quirks.begin(), quirks.end(), quirk) != quirks.end();
}

bool Instrument::is(const std::string& identification) const {
  return std::any_of(identity.begin(), identity.end(), [&](const std::string& pattern) {
    return begins_with(identification, pattern);
  });
}

double Instrument::middle_code() const {
  return format.codes == Codes::kSigned ? 0.0 : 0.5 * ((1 << format.bits) - 1);
}

double Instrument::full_scale_code() const {
  return format.codes == Codes::kSigned ? 32767.0 : 0.5 * ((1 << format.bits) - 1);
}

int Instrument::code_step() const {
  return format.codes == Codes::kSigned ? 1 << (16 - format.bits) : 1;
}

Status check_text(const std::string& text) {
  if (std::any_of(text.begin(), text.end(),
                  [](unsigned char c) { return c < 0x20U || c == 0x7FU; })) {
    return Error{
        fmt::format("\"{}\" contains a line end or another control character; it must be "
                    "one line of text",
                    printable(text))};
  }
  const auto& known = known_placeholders();
  for (const std::string& name : placeholders(text)) {
    if (text.find('{' + name + '}') == std::string::npos) {
      return Error{fmt::format("\"{}\" has a placeholder without its closing brace", text)};
    }
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      return Error{fmt::format("unknown placeholder {{{}}} in \"{}\"; known: {{{}}}", name, text,
                               fmt::join(known, "}, {"))};
    }
  }
  return Done{};
}

Status check_field(const std::string& field) {
  const bool counted =
      std::all_of(field.begin(), field.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  constexpr std::size_t kMostDigits = 3;
  if (counted && !field.empty() && (field.size() > kMostDigits || std::stoul(field) == 0)) {
    return Error{fmt::format("\"{}\" is no item of an answer; items are counted from 1 to 999",
                             printable(field))};
  }
  return Done{};
}

Status check(const Instrument& instrument) {
  const Dialect& dialect = instrument.dialect;
  const bool packets = instrument.format.block == Block::kPackets;
  const Rule rules[] = {
      {!instrument.identity.empty(), "no identity"},
      {instrument.amplitude.lowest_vpp > 0.0 &&
           instrument.amplitude.lowest_vpp < instrument.amplitude.highest_vpp,
       "the lowest amplitude must be above 0 and below the highest"},
      {instrument.amplitude.resolution_vpp > 0.0,
       "the resolution of the amplitude must be above 0"},
      {instrument.rate.lowest_hz > 0.0 && instrument.rate.lowest_hz < instrument.rate.highest_hz,
       "the lowest rate must be above 0 and below the highest"},
      {instrument.rate.resolution_hz > 0.0, "the resolution of the rate must be above 0"},
      {instrument.memory.fewest_points >= 2 &&
           instrument.memory.fewest_points <= instrument.memory.points,
       "the shortest waveform must have at least 2 points and fit the memory"},
      {instrument.rate.set_as == RateAs::kSampleRate || instrument.has(Quirk::kFixedLength),
       "a rate set as the frequency of the whole memory needs waveforms of a fixed length"},
      {instrument.format.bits >= 8 && instrument.format.bits <= 16,
       "the DAC must have 8 … 16 bits"},
      {!packets || instrument.memory.packet_points > 0, "packets have no size"},
      {!packets || (!dialect.more_part.empty() && !dialect.last_part.empty()),
       "packets need the words for more and last"},
      {!dialect.upload.empty() && !dialect.trigger.empty() && !dialect.output_on.empty() &&
           !dialect.output_off.empty() && !dialect.output.query.empty(),
       "upload, trigger, output_on, output_off and the query of the output are needed"},
      {!dialect.is_on.empty() && !dialect.is_off.empty(),
       "the answers for output on and off are needed"},
      {instrument.verification != Verification::kErrorQueue || !dialect.next_error.empty(),
       "verification by the error queue needs its query"},
      {instrument.verification != Verification::kReadBack || !dialect.read_back.empty(),
       "verification by reading back needs its query"},
  };
  for (const Rule& rule : rules) {
    if (!rule.holds) {
      return Error{fmt::format("{}: {}", instrument.name, rule.text)};
    }
  }
  for (const std::string& text : templates_of(instrument)) {
    if (const Status checked = check_text(text); !checked.ok()) {
      return Error{fmt::format("{}: {}", instrument.name, checked.error())};
    }
  }
  std::vector<Field> asked = {dialect.output};
  for (const Setting& setting : instrument.settings) {
    asked.push_back(setting.asked);
  }
  for (const Field& one : asked) {
    if (const Status checked = check_field(one.field); !checked.ok()) {
      return Error{fmt::format("{}: {}", instrument.name, checked.error())};
    }
  }
  return Done{};
}

}  // namespace gsbench::scpi
