// Keysight 33500B. Source: Agilent/Keysight 33500 Series Operating and Service Guide
// (33500-90901), section SCPI programming reference. Numbers of errors above 0 are those of the
// 33220A's list where it has the same text.
#include "generator_scpi_dialect.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

constexpr std::size_t kKeysightErrorsKept = 20;
constexpr std::string_view kBuiltIn = "INT:\\BUILTIN\\EXP_RISE.ARB";

std::string keysight_number(double value) {
  return std::isinf(value) ? "+9.9E+37" : fmt::format("{:+.15E}", value);
}
std::string one_or_zero(bool on) {
  return on ? "1" : "0";
}

struct KeysightFunction {
  GeneratorFunction function;
  std::string_view name;
};
constexpr KeysightFunction kKeysightFunctions[] = {
    {GeneratorFunction::kSine, "SINusoid"}, {GeneratorFunction::kSquare, "SQUare"},
    {GeneratorFunction::kRamp, "TRIangle"}, {GeneratorFunction::kRamp, "RAMP"},
    {GeneratorFunction::kPulse, "PULSe"},   {GeneratorFunction::kNoise, "PRBS"},
    {GeneratorFunction::kNoise, "NOISe"},   {GeneratorFunction::kArbitrary, "ARBitrary"},
    {GeneratorFunction::kDc, "DC"}};

class Keysight : public ScpiDialect {
 public:
  explicit Keysight(GeneratorState& state) : ScpiDialect(state, {kKeysightErrorsKept, true}) {
    add_output();
    add_wave();
    add_levels();
    add_arbitrary();
    add_burst();
    add_rest();
  }
  void lose_power() override {
    ScpiDialect::lose_power();
    reset();
  }

 private:
  void add_output();
  void add_wave();
  void add_levels();
  void add_arbitrary();
  void add_burst();
  void add_rest();
  void set_function(std::string_view argument);
  void apply(std::string_view shape, std::string_view argument);
  void set_levels(double low_v, double high_v);
  void select(std::string_view argument);
  void take_data(std::string_view argument, bool dac);
  double volts_of(double amplitude) const;  // in the unit chosen, to peak to peak
  double amplitude_of(double vpp) const;

  // The value is clipped and reported (guide, error -222).
  std::optional<double> out_of_range(double limit) override {
    error(-222, "Data out of range; value clipped to limit");
    return limit;
  }
  // "*OPC? returns 1 when the sweep or burst is complete", *WAI waits as long (guide, TRIGger
  // Subsystem). A burst that repeats by itself is not waited for.
  std::int64_t complete() const override {
    const GeneratorSettings& now = state_.settings();
    return now.burst_on && now.trigger != TriggerSource::kInternal ? state_.player().burst_end()
                                                                   : state_.time().now();
  }
  void trigger() override {
    const GeneratorSettings& now = state_.settings();
    if (now.burst_on && now.trigger == TriggerSource::kManual) {
      state_.player().trigger();
    } else {
      error(-211, "Trigger ignored");
    }
  }
  void reset() override {
    shape_ = "SINusoid";
    unit_ = "VPP";
    filter_ = "STEP";
    swapped_ = false;
  }

  std::string_view shape_ = "SINusoid";
  std::string_view unit_ = "VPP";
  std::string_view filter_ = "STEP";
  std::string_view advance_ = "SRATe";
  bool swapped_ = false;  // FORMat:BORDer SWAP: little endian
};

void Keysight::add_output() {
  add(
      "OUTPut[:STATe]",
      [this](std::string_view argument) {
        flag(argument, [this](bool on) {
          change([&](GeneratorSettings& next) {
            next.output_on = on || (next.output_on && state_.faults().ignores_output_off);
          });
        });
      },
      [this](std::string_view) { return one_or_zero(state_.settings().output_on); });
  add(
      "OUTPut:LOAD",
      [this](std::string_view argument) {
        if (is_form_of(argument, "INFinity")) {
          state_.set_load(std::numeric_limits<double>::infinity());
          return;
        }
        number(argument, 1, 10e3, [this](double load_ohm) { state_.set_load(load_ohm); });
      },
      [this](std::string_view) { return keysight_number(state_.settings().load_ohm); });
  add(
      "OUTPut:POLarity",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"NORMal", "INVerted"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) { next.inverted = name == "INVerted"; });
        }
      },
      [this](std::string_view) { return state_.settings().inverted ? "INV" : "NORM"; });
}

void Keysight::set_function(std::string_view argument) {
  for (const KeysightFunction& row : kKeysightFunctions) {
    if (is_form_of(argument, row.name)) {
      shape_ = row.name;
      change([&](GeneratorSettings& next) {
        next.function = row.function;
        next.frequency_hz = std::min(next.frequency_hz, state_.highest_frequency_hz(row.function));
        if (row.name == "TRIangle") {
          next.symmetry_pct = 50;
        }
      });
      return;
    }
  }
  error(-224, "Illegal parameter value");
}

void Keysight::add_wave() {
  add(
      "[SOURce:]FUNCtion[:SHAPe]", [this](std::string_view argument) { set_function(argument); },
      [this](std::string_view) { return short_form(shape_); });
  add(
      "[SOURce:]FREQuency[:CW][:FIXed]",
      [this](std::string_view argument) {
        number(argument, 1e-6, state_.highest_frequency_hz(state_.settings().function),
               [this](double value) {
                 change([&](GeneratorSettings& next) { next.frequency_hz = value; });
               });
      },
      [this](std::string_view) { return keysight_number(state_.settings().frequency_hz); });
  add(
      "[SOURce:]FUNCtion:SQUare:DCYCle",
      [this](std::string_view argument) {
        number(argument, 0.01, 99.99, [this](double value) {
          change([&](GeneratorSettings& next) { next.duty_pct = value; });
        });
      },
      [this](std::string_view) { return keysight_number(state_.settings().duty_pct); });
  add(
      "[SOURce:]FUNCtion:RAMP:SYMMetry",
      [this](std::string_view argument) {
        number(argument, 0, 100, [this](double value) {
          change([&](GeneratorSettings& next) { next.symmetry_pct = value; });
        });
      },
      [this](std::string_view) { return keysight_number(state_.settings().symmetry_pct); });
  add(
      "[SOURce:]PHASe[:ADJust]",
      [this](std::string_view argument) {
        number(argument, -360, 360, [this](double value) {
          change([&](GeneratorSettings& next) { next.phase_deg = value; });
        });
      },
      [this](std::string_view) { return keysight_number(state_.settings().phase_deg); });
  for (const std::string_view shape : {"SINusoid", "SQUare", "RAMP", "ARBitrary"}) {
    const std::string_view pattern = shape == "SINusoid" ? "[SOURce:]APPLy:SINusoid"
                                     : shape == "SQUare" ? "[SOURce:]APPLy:SQUare"
                                     : shape == "RAMP"   ? "[SOURce:]APPLy:RAMP"
                                                         : "[SOURce:]APPLy:ARBitrary";
    add(pattern, [this, shape](std::string_view argument) { apply(shape, argument); }, {});
  }
}

// APPLy turns the burst off, sets the trigger source to IMMediate and switches the output on
// (guide, APPLy Subsystem).
void Keysight::apply(std::string_view shape, std::string_view argument) {
  set_function(shape);
  change([](GeneratorSettings& next) {
    next.burst_on = false;
    next.trigger = TriggerSource::kInternal;
  });
  const auto fields = fields_of(argument);
  constexpr std::string_view kParts[] = {"FREQ ", "VOLT ", "VOLT:OFFS "};
  for (std::size_t i = 0; i < fields.size() && i < std::size(kParts); ++i) {
    const bool rate = i == 0 && shape == "ARBitrary";
    execute(std::string(rate ? "FUNC:ARB:SRAT " : kParts[i]) + std::string(fields[i]) + "\n");
  }
  change([](GeneratorSettings& next) { next.output_on = true; });
}

// RMS of full-scale sine, square and ramp; others are set peak to peak only.
double Keysight::volts_of(double amplitude) const {
  const GeneratorSettings& now = state_.settings();
  const double crest = now.function == GeneratorFunction::kSine     ? std::sqrt(2.0)
                       : now.function == GeneratorFunction::kSquare ? 1.0
                                                                    : std::sqrt(3.0);
  if (unit_ == "VRMS") {
    return 2 * crest * amplitude;
  }
  if (unit_ == "DBM") {
    return 2 * crest * std::sqrt(1e-3 * std::pow(10, amplitude / 10) * now.load_ohm);
  }
  return amplitude;
}

double Keysight::amplitude_of(double vpp) const {
  const double one_v = unit_ == "DBM" ? 1.0 : volts_of(1.0);
  if (unit_ == "DBM") {
    const double zero_dbm = volts_of(0.0);
    return 20 * std::log10(vpp / zero_dbm);
  }
  return vpp / one_v;
}

void Keysight::set_levels(double low_v, double high_v) {
  const double lowest = state_.lowest_vpp();
  const double peak = state_.highest_peak_v();
  if (high_v - low_v < lowest * (1 - 1e-9) || high_v > peak || low_v < -peak) {
    error(-222, "Data out of range");
    return;
  }
  change([&](GeneratorSettings& next) {
    next.amplitude_vpp = high_v - low_v;
    next.offset_v = (high_v + low_v) / 2;
  });
}

void Keysight::add_levels() {
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate][:AMPLitude]",
      [this](std::string_view argument) {
        const double highest = state_.highest_vpp(state_.settings().offset_v);
        number(argument, amplitude_of(state_.lowest_vpp()), amplitude_of(highest),
               [this](double value) {
                 const double vpp = volts_of(value);
                 change([&](GeneratorSettings& next) { next.amplitude_vpp = vpp; });
               });
      },
      [this](std::string_view) {
        return keysight_number(amplitude_of(state_.settings().amplitude_vpp));
      });
  add(
      "[SOURce:]VOLTage:UNIT",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"VPP", "VRMS", "DBM"});
        if (name == "DBM" && std::isinf(state_.settings().load_ohm)) {
          error(-221, "Settings conflict; dBm needs a finite load");
        } else if (!name.empty()) {
          unit_ = name;
        }
      },
      [this](std::string_view) { return std::string(unit_); });
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate]:OFFSet",
      [this](std::string_view argument) {
        const double room = state_.highest_peak_v() - state_.settings().amplitude_vpp / 2;
        number(argument, -room, room, [this](double value) {
          change([&](GeneratorSettings& next) { next.offset_v = value; });
        });
      },
      [this](std::string_view) { return keysight_number(state_.settings().offset_v); });
  const auto low = [this] {
    return state_.settings().offset_v - state_.settings().amplitude_vpp / 2;
  };
  const auto high = [this] {
    return state_.settings().offset_v + state_.settings().amplitude_vpp / 2;
  };
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate]:HIGH",
      [this, low](std::string_view argument) {
        const double peak = state_.highest_peak_v();
        number(argument, -peak, peak, [&](double value) { set_levels(low(), value); });
      },
      [high](std::string_view) { return keysight_number(high()); });
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate]:LOW",
      [this, high](std::string_view argument) {
        const double peak = state_.highest_peak_v();
        number(argument, -peak, peak, [&](double value) { set_levels(value, high()); });
      },
      [low](std::string_view) { return keysight_number(low()); });
}

void Keysight::add_arbitrary() {
  add(
      "[SOURce:]FUNCtion[:SHAPe]:ARBitrary",
      [this](std::string_view argument) { select(argument); },
      [this](std::string_view) {
        const std::string& name = state_.settings().waveform;
        return "\"" + (name.empty() ? std::string(kBuiltIn) : name) + "\"";
      });
  add(
      "[SOURce:]FUNCtion[:SHAPe]:ARBitrary:SRATe",
      [this](std::string_view argument) {
        number(argument, 1e-6, state_.facts().highest_rate_hz, [this](double value) {
          change([&](GeneratorSettings& next) { next.sample_rate_hz = value; });
        });
      },
      [this](std::string_view) { return keysight_number(state_.settings().sample_rate_hz); });
  // OFF steps from point to point. NORMal and STEP are low-pass filters of the maker's; at mains
  // frequency, joined points differ from them by less than 1e-4 from 10 kSa/s on.
  add(
      "[SOURce:]FUNCtion[:SHAPe]:ARBitrary:FILTer",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"NORMal", "STEP", "OFF"});
        if (!name.empty()) {
          filter_ = name;
          change([&](GeneratorSettings& next) {
            next.between = name == "OFF" ? Between::kHold : Between::kLine;
          });
        }
      },
      [this](std::string_view) { return short_form(filter_); });
  // Points that advance by triggers are not emulated.
  add(
      "[SOURce:]FUNCtion[:SHAPe]:ARBitrary:ADVance",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"SRATe"});
        advance_ = name.empty() ? advance_ : name;
      },
      [this](std::string_view) { return short_form(advance_); });
  add("[SOURce:]FUNCtion[:SHAPe]:ARBitrary:POINts", {}, [this](std::string_view) {
    const GeneratorWaveform* const found = state_.find(state_.settings().waveform);
    return fmt::format("{:+d}", found == nullptr ? 100 : static_cast<int>(found->points()));
  });
  add("[SOURce:]DATA:ARBitrary", [this](std::string_view argument) { take_data(argument, false); },
      {});
  add("[SOURce:]DATA:ARBitrary:DAC",
      [this](std::string_view argument) { take_data(argument, true); }, {});
  add("[SOURce:]DATA:VOLatile:CLEar", [this](std::string_view) { state_.forget_waveforms(); }, {});
  add("[SOURce:]DATA:VOLatile:CATalog", {}, [this](std::string_view) {
    std::string list = "\"" + std::string(kBuiltIn) + "\"";
    for (const std::string& name : state_.names()) {
      list += ",\"" + name + "\"";
    }
    return list;
  });
  add("[SOURce:]DATA:VOLatile:FREE", {}, [this](std::string_view) {
    std::size_t free = state_.facts().memory_points;
    for (const std::string& name : state_.names()) {
      free -= state_.find(name)->points();
    }
    return fmt::format("{:+d}", static_cast<std::int64_t>(state_.has_room(0) ? free : 0));
  });
  add("[SOURce:]DATA:ATTRibute:POINts", {}, [this](std::string_view argument) {
    const GeneratorWaveform* const found =
        state_.find(argument.empty() ? state_.settings().waveform : unquoted(argument));
    return fmt::format("{:+d}", found == nullptr ? 0 : static_cast<int>(found->points()));
  });
  add(
      "FORMat:BORDer",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"NORMal", "SWAPped"});
        swapped_ = name.empty() ? swapped_ : name == "SWAPped";
      },
      [this](std::string_view) { return swapped_ ? "SWAP" : "NORM"; });
}

void Keysight::select(std::string_view argument) {
  const std::string name = unquoted(argument);
  if (upper(name) == kBuiltIn || upper(name) == "EXP_RISE") {
    change([](GeneratorSettings& next) { next.waveform.clear(); });
  } else if (state_.find(name) == nullptr) {
    error(785, "Specified arb waveform does not exist");
  } else {
    change([&](GeneratorSettings& next) { next.waveform = name; });
  }
}

// "name, values" or "name, #…": 16-bit codes up to ±32 767, or single-precision numbers up to ±1
// (guide, DATA:ARBitrary[:DAC]). "Specifying a waveform that is already loaded generates a
// 'Specified arb waveform already exists' error."
void Keysight::take_data(std::string_view argument, bool dac) {
  const auto comma = argument.find(',');
  const std::string name = unquoted(argument.substr(0, comma));
  if (comma == std::string_view::npos || name.empty()) {
    error(-109, "Missing parameter");
    return;
  }
  if (state_.find(name) != nullptr) {
    error(786, "Specified arb waveform already exists");
    return;
  }
  const double full_scale = dac ? 1.0 : 32767.0;
  std::vector<std::int16_t> codes;
  bool in_range = true;
  const auto take = [&](double value) {
    const double code = std::round(value * full_scale);
    in_range = in_range && std::abs(code) <= 32767.0;
    codes.push_back(in_range ? static_cast<std::int16_t>(code) : std::int16_t{0});
  };
  const std::string_view rest = left_trimmed(argument.substr(comma + 1));
  if (!rest.empty() && rest.front() == '#') {
    const auto bytes = block_of(rest);
    const std::size_t size = dac ? 2 : 4;
    if (!bytes || bytes->size() % size != 0) {
      error(-161, "Invalid block data");
      return;
    }
    for (std::size_t at = 0; at < bytes->size(); at += size) {
      char point[4];
      std::memcpy(point, bytes->data() + at, size);
      if (!swapped_) {
        std::reverse(point, point + size);
      }
      std::int16_t code = 0;
      float part = 0;
      std::memcpy(dac ? static_cast<void*>(&code) : &part, point, size);
      take(dac ? code : part);
    }
  } else {
    for (const std::string_view field : fields_of(rest)) {
      const auto value = number_of(field);
      if (!value) {
        error(-104, "Data type error");
        return;
      }
      take(*value);
    }
  }
  if (!in_range || codes.size() < state_.facts().fewest_points) {
    error(-222, "Data out of range");
  } else if (codes.size() > state_.facts().most_points || !state_.has_room(codes.size())) {
    error(781, "Not enough memory to store new arb waveform; use DATA:VOLATILE:CLEAR");
  } else {
    state_.store({name, std::move(codes), 0.0, 1 / 32767.0});
    if (state_.faults().upload_switches_on) {
      change([](GeneratorSettings& next) { next.output_on = true; });
    }
  }
}

void Keysight::add_burst() {
  add(
      "[SOURce:]BURSt[:STATe]",
      [this](std::string_view argument) {
        flag(argument,
             [this](bool on) { change([&](GeneratorSettings& next) { next.burst_on = on; }); });
      },
      [this](std::string_view) { return one_or_zero(state_.settings().burst_on); });
  // Gated bursts are not emulated.
  add(
      "[SOURce:]BURSt:MODE", [this](std::string_view argument) { one_of(argument, {"TRIGgered"}); },
      [](std::string_view) { return "TRIG"; });
  add(
      "[SOURce:]BURSt:NCYCles",
      [this](std::string_view argument) {
        if (is_form_of(argument, "INFinity")) {
          change([](GeneratorSettings& next) {
            next.burst_cycles = std::numeric_limits<double>::infinity();
          });
          return;
        }
        number(argument, 1, 1e8, [this](double value) {
          change([&](GeneratorSettings& next) { next.burst_cycles = std::round(value); });
        });
      },
      [this](std::string_view) { return keysight_number(state_.settings().burst_cycles); });
  add(
      "[SOURce:]BURSt:INTernal:PERiod",
      [this](std::string_view argument) {
        number(argument, 1e-6, 8000, [this](double value) {
          change([&](GeneratorSettings& next) { next.burst_period_s = value; });
        });
      },
      [this](std::string_view) { return keysight_number(state_.settings().burst_period_s); });
  add(
      "[SOURce:]BURSt:PHASe",
      [this](std::string_view argument) {
        number(argument, -360, 360, [this](double value) {
          change([&](GeneratorSettings& next) { next.phase_deg = value; });
        });
      },
      [this](std::string_view) { return keysight_number(state_.settings().phase_deg); });
  add(
      "TRIGger:SOURce",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"IMMediate", "EXTernal", "BUS"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) {
            next.trigger = name == "IMMediate"  ? TriggerSource::kInternal
                           : name == "EXTernal" ? TriggerSource::kExternal
                                                : TriggerSource::kManual;
          });
        }
      },
      [this](std::string_view) {
        constexpr std::string_view kSources[] = {"IMM", "EXT", "BUS"};
        return std::string(kSources[static_cast<std::size_t>(state_.settings().trigger)]);
      });
  // "Forces a trigger, whatever the source" (guide, TRIGger[1|2]).
  add("TRIGger[:IMMediate]",
      [this](std::string_view) {
        if (state_.settings().burst_on) {
          state_.player().trigger();
        } else {
          error(-211, "Trigger ignored");
        }
      },
      {});
  add("ABORt", [this](std::string_view) { state_.player().abort(); }, {});
}

// Commands without effect on the output.
void Keysight::add_rest() {
  for (const std::string_view pattern :
       {"DISPlay[:STATe]", "DISPlay:TEXT", "DISPlay:TEXT:CLEar", "SYSTem:BEEPer[:IMMediate]",
        "SYSTem:REMote", "SYSTem:LOCal", "SYSTem:RWLock", "STATus:PRESet", "OUTPut:SYNC[:STATe]",
        "UNIT:ANGLe"}) {
    add(pattern, [](std::string_view) {}, {});
  }
}

}  // namespace

std::unique_ptr<GeneratorDialect> make_keysight(GeneratorState& state) {
  return std::make_unique<Keysight>(state);
}

}  // namespace gsbench::emulation
