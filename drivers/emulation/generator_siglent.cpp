// Siglent SDG1000X and SDG2000X: "C1:BSWV FRQ,1000,AMP,4", pairs of names and values, no errors.
// Sources: Siglent SDG Series Programming Guide PG02-E05C, and public drivers whose authors
// recorded the answers of an SDG1032X (firmware 1.01.01.33R1B6, USB and TCP) and of an SDG2042X
// (firmware 2.01.01.23R7, VXI-11). Where the two disagree with the guide, the instruments count.
#include "generator_dialect.hpp"
#include "generator_scpi.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

constexpr std::string_view kWaveData = "WAVEDATA,";
constexpr double kMostBurstCycles = 1e6;

struct FunctionName {
  GeneratorFunction function;
  std::string_view name;
};
constexpr FunctionName kSiglentFunctions[] = {
    {GeneratorFunction::kSine, "SINE"},    {GeneratorFunction::kSquare, "SQUARE"},
    {GeneratorFunction::kRamp, "RAMP"},    {GeneratorFunction::kPulse, "PULSE"},
    {GeneratorFunction::kNoise, "NOISE"},  {GeneratorFunction::kDc, "DC"},
    {GeneratorFunction::kArbitrary, "ARB"}};

std::string_view siglent_name(GeneratorFunction function) {
  return std::find_if(std::begin(kSiglentFunctions), std::end(kSiglentFunctions),
                      [&](const FunctionName& row) { return row.function == function; })
      ->name;
}

// Settings are rounded to what the front panel shows: 1 mV, 1 µHz.
double in_steps(double value, double step) {
  return std::round(value / step) * step;
}

class Siglent : public GeneratorDialect {
 public:
  Siglent(GeneratorState& state, bool sample_rates) : state_(state), has_rates_(sample_rates) {}

  // On TCP a message ends at the first 0x0A, also within the bytes of a waveform.
  std::size_t message_size(std::string_view bytes) override {
    const auto newline = bytes.find('\n', std::min(scanned_, bytes.size()));
    scanned_ = newline == std::string_view::npos ? bytes.size() : 0;
    return newline == std::string_view::npos ? 0 : newline + 1;
  }
  std::size_t text_size(std::string_view message) const override {
    const auto data = upper(message.substr(0, 400)).find(kWaveData);
    return data == std::string::npos ? trimmed(message).size() : data + kWaveData.size();
  }
  void connect() override { scanned_ = 0; }
  void lose_power() override { swallows_next_ = false; }
  GeneratorReply execute(std::string_view message) override;

 private:
  std::string answer(const std::string& header, std::string_view argument) const;
  void set(const std::string& header, std::string_view argument);
  void set_wave(std::string_view argument);
  void set_output(std::string_view argument);
  void set_rate(std::string_view argument);
  void set_burst(std::string_view argument);
  void select(std::string_view argument);
  void store(std::string_view argument);
  std::string wave() const;
  std::string carrier() const;
  std::string burst() const;
  std::string read_back(std::string_view argument) const;
  double frequency_hz() const;

  GeneratorState& state_;
  const bool has_rates_;
  std::size_t scanned_ = 0;
  bool swallows_next_ = false;
  bool infinite_ = false;
};

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

double Siglent::frequency_hz() const {
  const GeneratorSettings& now = state_.settings();
  const GeneratorWaveform* const selected = state_.find(now.waveform);
  return now.function == GeneratorFunction::kArbitrary &&
                 now.point_rate == PointRate::kSampleRate && selected != nullptr
             ? now.sample_rate_hz / static_cast<double>(selected->points())
             : now.frequency_hz;
}

// Numbers as an SDG2042X prints them: frequencies with ten digits, the rest with six.
std::string Siglent::wave() const {
  const GeneratorSettings& now = state_.settings();
  const double frequency = frequency_hz();
  std::string text = fmt::format("WVTP,{}", siglent_name(now.function));
  if (now.function == GeneratorFunction::kDc) {
    return text + fmt::format(",OFST,{:.6g}V", now.offset_v);
  }
  text += fmt::format(",FRQ,{:.10g}HZ,PERI,{:.6g}S,AMP,{:.6g}V", frequency, 1 / frequency,
                      now.amplitude_vpp);
  if (now.function == GeneratorFunction::kSine) {
    text += fmt::format(",AMPVRMS,{:.6g}Vrms", now.amplitude_vpp / std::sqrt(8.0));
  }
  text += fmt::format(",OFST,{:.6g}V,HLEV,{:.6g}V,LLEV,{:.6g}V,PHSE,{:.6g}", now.offset_v,
                      now.offset_v + now.amplitude_vpp / 2, now.offset_v - now.amplitude_vpp / 2,
                      now.phase_deg);
  if (now.function == GeneratorFunction::kSquare || now.function == GeneratorFunction::kPulse) {
    text += fmt::format(",DUTY,{:.6g}", now.duty_pct);
  } else if (now.function == GeneratorFunction::kRamp) {
    text += fmt::format(",SYM,{:.6g}", now.symmetry_pct);
  }
  return text;
}

// The fields of BSWV? without PERI, HLEV and LLEV.
std::string Siglent::carrier() const {
  const std::string all = wave();
  std::string text;
  const auto fields = fields_of(all);
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
    if (fields[i] != "PERI" && fields[i] != "HLEV" && fields[i] != "LLEV") {
      text += (text.empty() ? "" : ",") + std::string(fields[i]) + "," + std::string(fields[i + 1]);
    }
  }
  return text;
}

// Values out of range are clamped without a sign: AMP,0.001 reads 0.002V on the SDG1032X.
void Siglent::set_wave(std::string_view argument) {
  const auto fields = fields_of(argument);
  GeneratorSettings next = state_.settings();
  bool has_type = false;
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
    const std::string key = upper(fields[i]);
    if (key == "WVTP") {
      for (const FunctionName& row : kSiglentFunctions) {
        if (upper(fields[i + 1]) == row.name) {
          next.function = row.function;
          next.burst_on = false;  // recorded for modulation and sweep; assumed for the burst
          has_type = true;
        }
      }
      next.frequency_hz = std::min(next.frequency_hz, state_.highest_frequency_hz(next.function));
      continue;
    }
    const auto number = number_of(fields[i + 1]);
    if (!number || std::isinf(*number)) {
      continue;
    }
    const double peak = state_.highest_peak_v();
    if (key == "FRQ" || (key == "PERI" && *number > 0)) {
      const double wanted = key == "FRQ" ? *number : 1 / *number;
      next.frequency_hz =
          in_steps(std::clamp(wanted, 1e-6, state_.highest_frequency_hz(next.function)), 1e-6);
      const GeneratorWaveform* const selected = state_.find(next.waveform);
      if (next.point_rate == PointRate::kSampleRate && selected != nullptr) {
        next.sample_rate_hz = std::clamp(wanted * static_cast<double>(selected->points()), 1e-6,
                                         state_.facts().highest_rate_hz);
      }
    } else if (key == "AMP") {
      next.amplitude_vpp =
          std::clamp(in_steps(*number, 0.001), state_.lowest_vpp(),
                     std::max(state_.lowest_vpp(), state_.highest_vpp(next.offset_v)));
    } else if (key == "OFST") {
      const double room = peak - next.amplitude_vpp / 2;
      next.offset_v = std::clamp(in_steps(*number, 0.001), -room, room);
    } else if (key == "PHSE") {
      next.phase_deg = *number - 360 * std::floor(*number / 360);
    } else if (key == "DUTY") {
      next.duty_pct = std::clamp(*number, 0.1, 99.9);
    } else if (key == "SYM") {
      next.symmetry_pct = std::clamp(*number, 0.0, 100.0);
    }
  }
  state_.set(next);
  // Recorded by others: with WVTP beside other fields, the message after it is lost.
  swallows_next_ = has_type && fields.size() > 2;
}

void Siglent::set_output(std::string_view argument) {
  const auto fields = fields_of(argument);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string key = upper(fields[i]);
    GeneratorSettings next = state_.settings();
    if (key == "ON" || key == "OFF") {
      next.output_on = key == "ON" || (next.output_on && state_.faults().ignores_output_off);
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

// While the burst is off, the answer is STATE,OFF and other fields are ignored (recorded on the
// SDG2042X). Gated bursts are not emulated.
std::string Siglent::burst() const {
  const GeneratorSettings& now = state_.settings();
  if (!now.burst_on) {
    return "STATE,OFF";
  }
  std::string text = "STATE,ON";
  if (now.trigger == TriggerSource::kInternal) {
    text += fmt::format(",PRD,{:.6g}S", now.burst_period_s);
  }
  constexpr std::string_view kSources[] = {"INT", "EXT", "MAN"};
  text += fmt::format(",STPS,{:.6g},TRSR,{}", now.phase_deg,
                      kSources[static_cast<std::size_t>(now.trigger)]);
  text += now.trigger == TriggerSource::kExternal ? "" : ",TRMD,OFF";
  text += infinite_ ? ",TIME,INF" : fmt::format(",TIME,{:.10g}", now.burst_cycles);
  return text + ",DLAY,6.04035e-07S,GATE_NCYC,NCYC,CARR," + carrier();
}

void Siglent::set_burst(std::string_view argument) {
  const auto fields = fields_of(argument);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string key = upper(fields[i]);
    GeneratorSettings next = state_.settings();
    if (key == "MTRIG") {
      if (next.burst_on && next.trigger == TriggerSource::kManual) {
        state_.player().trigger();
      }
      continue;
    }
    if (key == "CARR" || i + 1 == fields.size()) {
      break;
    }
    const std::string value = upper(fields[++i]);
    const auto number = number_of(value);
    if (key == "STATE") {
      next.burst_on = value == "ON" && next.function != GeneratorFunction::kNoise &&
                      next.function != GeneratorFunction::kDc;
    } else if (!next.burst_on) {
      continue;
    } else if (key == "TRSR") {
      if (value == "MAN") {
        next.trigger = TriggerSource::kManual;
      } else if (value == "EXT") {
        next.trigger = TriggerSource::kExternal;
      } else if (value == "INT" && !infinite_) {
        next.trigger = TriggerSource::kInternal;
      }
    } else if (key == "TIME" && number) {
      infinite_ = std::isinf(*number);
      next.burst_cycles =
          infinite_ ? *number : std::clamp(std::round(*number), 1.0, kMostBurstCycles);
      next.trigger = infinite_ ? TriggerSource::kExternal : next.trigger;
    } else if (key == "PRD" && number && next.trigger == TriggerSource::kInternal) {
      next.burst_period_s = std::clamp(*number, 1e-6, 1000.0);
    } else if (key == "STPS" && number && std::isfinite(*number)) {
      next.phase_deg = *number - 360 * std::floor(*number / 360);
    }
    state_.set(next);
  }
}

// A name that is not stored is ignored. The function stays: BSWV WVTP,ARB selects it.
void Siglent::select(std::string_view argument) {
  const auto fields = fields_of(argument);
  GeneratorSettings next = state_.settings();
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
    if (upper(fields[i]) == "NAME" && state_.find(unquoted(fields[i + 1])) != nullptr) {
      next.waveform = unquoted(fields[i + 1]);
    } else if (upper(fields[i]) == "INDEX") {
      next.waveform.clear();
    }
  }
  state_.set(next);
}

// Codes of 16 bits, little endian, +32767 is half the amplitude (guide, section WVDT). What came
// before a 0x0A is stored without a sign; so is less than LENGTH. What does not fit is not stored.
void Siglent::store(std::string_view argument) {
  const auto data = upper(argument.substr(0, 400)).find(kWaveData);
  if (data == std::string::npos) {
    return;
  }
  std::string_view bytes = argument.substr(data + kWaveData.size());
  std::string name;
  const auto fields = fields_of(argument.substr(0, data));
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
    if (upper(fields[i]) == "WVNM") {
      name = unquoted(fields[i + 1]);
    } else if (upper(fields[i]) == "LENGTH") {
      std::string length = upper(fields[i + 1]);
      double unit = 1;
      while (!length.empty() && (length.back() == 'B' || length.back() == 'K')) {
        unit = length.back() == 'K' ? 1024 : unit;
        length.pop_back();
      }
      const double said = number_of(length).value_or(1e9) * unit;
      if (said >= 0 && said < static_cast<double>(bytes.size())) {
        bytes = bytes.substr(0, static_cast<std::size_t>(said));
      }
    }
  }
  const std::size_t points = bytes.size() / 2;
  if (name.empty() || points < state_.facts().fewest_points ||
      points > state_.facts().most_points || !state_.has_room(points)) {
    return;
  }
  std::vector<std::int16_t> codes(points);
  for (std::size_t i = 0; i < points; ++i) {
    const auto low = static_cast<unsigned char>(bytes[2 * i]);
    const auto high = static_cast<unsigned char>(bytes[2 * i + 1]);
    codes[i] = static_cast<std::int16_t>(low | high << 8);
  }
  state_.store({name, std::move(codes), 0.0, 1 / 32767.0});
}

// "WVDT? USER,name" has no answer if there is no such waveform. Else: fields, codes, a newline.
std::string Siglent::read_back(std::string_view argument) const {
  const auto fields = fields_of(argument);
  const GeneratorWaveform* const found =
      fields.size() == 2 && upper(fields[0]) == "USER" ? state_.find(unquoted(fields[1])) : nullptr;
  if (found == nullptr) {
    return "";
  }
  std::string text = fmt::format(
      "WVDT WVNM,{},LENGTH,{}B,TYPE,5,FREQ,1000.000000000,AMPL,4.000000,OFST,0.000000,"
      "PHASE,0.000000000,WAVEDATA,",
      found->name(), 2 * found->points());
  for (const std::int16_t code : found->codes()) {
    text += static_cast<char>(code & 0xff);
    text += static_cast<char>((code >> 8) & 0xff);
  }
  return text;
}

}  // namespace

std::unique_ptr<GeneratorDialect> make_siglent(GeneratorState& state, bool sample_rates) {
  return std::make_unique<Siglent>(state, sample_rates);
}

}  // namespace gsbench::emulation
