#include "generator_siglent.hpp"

#include "generator_scpi.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::emulation {

GeneratorReply Siglent::execute(std::string_view message) {
  message.remove_suffix(1);
  if (swallows_next_) {
    swallows_next_ = false;
    return {};
  }
  message = left_trimmed(message);
  const auto space = std::min(message.find_first_of(" \t\r"), message.size());
  std::string header = upper(message.substr(0, space));
  const std::string_view argument = left_trimmed(message.substr(space));
  if (!header.empty() && header.back() == '?') {
    header.pop_back();
    const std::string answered = answer(header, argument);
    return {answered.empty() ? answered : answered + "\n"};
  }
  set(header, argument);
  return {};
}

// A query that is not known gets no answer, and the next one works: recorded on the SDG1032X with
// CURRPRT? and VOLTSTAT?. SYSTem:ERRor? is not in the guide of either series.
std::string Siglent::answer(const std::string& header, std::string_view argument) const {
  const GeneratorSettings& now = state_.settings();
  if (header == "*IDN") {
    return state_.faults().identity.empty() ? state_.facts().identity : state_.faults().identity;
  }
  if (header == "*OPC") {
    return "1";
  }
  if (header == "MODE") {
    return "MODE PHASE-LOCKED";
  }
  if (header == "WVDT") {
    return read_back(argument);
  }
  if (header == "STL" && is_form_of(trimmed(argument), "USER")) {
    std::string list = "STL WVNM";
    for (const std::string& name : state_.names()) {
      list += "," + name;
    }
    return list;
  }
  if (header == "C1:OUTP" || header == "C1:OUTPUT") {
    const std::string load = std::isinf(now.load_ohm) ? "HZ" : fmt::format("{:.6g}", now.load_ohm);
    return fmt::format("C1:OUTP {},LOAD,{},PLRT,{}", now.output_on ? "ON" : "OFF", load,
                       now.inverted ? "INVT" : "NOR");
  }
  if (header == "C1:BSWV" || header == "C1:BASIC_WAVE") {
    return "C1:BSWV " + wave();
  }
  if (header == "C1:BTWV" || header == "C1:BURSTWAVE") {
    return "C1:BTWV " + burst();
  }
  if (header == "C1:ARWV" || header == "C1:ARBWAVE") {
    return now.waveform.empty() ? "C1:ARWV INDEX,2,NAME,StairUp"
                                : "C1:ARWV INDEX,0,NAME," + now.waveform;
  }
  if (has_rates_ && (header == "C1:SRATE" || header == "C1:SAMPLERATE")) {
    return now.point_rate == PointRate::kFrequency
               ? "C1:SRATE MODE,DDS"
               : fmt::format("C1:SRATE MODE,TARB,INTER,{},VALUE,{:.10g}Sa/s",
                             now.between == Between::kLine ? "LINE" : "HOLD", now.sample_rate_hz);
  }
  return "";
}

// Commands that are not known, and those of the second channel, are ignored.
void Siglent::set(const std::string& header, std::string_view argument) {
  if (header == "*RST") {
    state_.reset();
    infinite_ = false;
  } else if (header == "C1:OUTP" || header == "C1:OUTPUT") {
    set_output(argument);
  } else if (header == "C1:BSWV" || header == "C1:BASIC_WAVE") {
    set_wave(argument);
  } else if (header == "C1:BTWV" || header == "C1:BURSTWAVE") {
    set_burst(argument);
  } else if (header == "C1:ARWV" || header == "C1:ARBWAVE") {
    select(argument);
  } else if (header == "C1:WVDT") {
    store(argument);
  } else if (has_rates_ && (header == "C1:SRATE" || header == "C1:SAMPLERATE")) {
    set_rate(argument);
  }
}

void Siglent::set_output(std::string_view argument) {
  const auto fields = fields_of(argument);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string key = upper(fields[i]);
    GeneratorSettings next = state_.settings();
    if (key == "ON" || key == "OFF") {
      next.output_on = key == "ON";
      state_.set(next);
    } else if (key == "LOAD" && i + 1 < fields.size()) {
      ++i;
      if (upper(fields[i]) == "HZ") {
        state_.set_load(std::numeric_limits<double>::infinity());
      } else if (const auto load = number_of(fields[i]); load) {
        state_.set_load(std::clamp(*load, 50.0, 100e3));
      }
    } else if (key == "PLRT" && i + 1 < fields.size()) {
      next.inverted = upper(fields[++i]) == "INVT";
      state_.set(next);
    }
  }
}

// TrueArb of the 2000X (guide, section SRATE). VALUE counts in TARB mode only.
void Siglent::set_rate(std::string_view argument) {
  const auto fields = fields_of(argument);
  GeneratorSettings next = state_.settings();
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
    const std::string key = upper(fields[i]);
    const std::string value = upper(fields[i + 1]);
    if (key == "MODE" && (value == "DDS" || value == "TARB")) {
      next.point_rate = value == "DDS" ? PointRate::kFrequency : PointRate::kSampleRate;
    } else if (key == "INTER" && (value == "LINE" || value == "HOLD")) {
      next.between = value == "LINE" ? Between::kLine : Between::kHold;
    } else if (key == "VALUE" && next.point_rate == PointRate::kSampleRate) {
      if (const auto rate = number_of(value); rate) {
        next.sample_rate_hz = std::clamp(*rate, 1e-6, state_.facts().highest_rate_hz);
      }
    }
  }
  if (next.point_rate == PointRate::kFrequency) {
    next.between = Between::kHold;
  }
  state_.set(next);
}

void Siglent::lose_power() {
  swallows_next_ = false;
  infinite_ = false;
}

std::unique_ptr<GeneratorDialect> make_siglent(GeneratorState& state, bool sample_rates) {
  return std::make_unique<Siglent>(state, sample_rates);
}

}  // namespace gsbench::emulation
