// Rigol DG1000Z. Sources: DG1000Z Programming Guide (Rigol, 2013 and later), and public drivers and
// their tests; what only users report says so.
#include "generator_scpi_dialect.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

constexpr std::size_t kErrorsKept = 20;
// The guide has packets of up to 16 384 points; two public drivers state that 8192 points, 16 384
// bytes, are the most that works. So does this one.
constexpr std::size_t kMostPacketBytes = 16384;
// Users pause 50 to 200 ms between packets, or wait for *OPC?, because packets that follow each
// other at once are lost.
constexpr std::int64_t kPacket_steps = TrueTime::kRate_hz / 20;
constexpr int kHighestCode = 0x3fff;
constexpr std::string_view kVolatile = "VOLATILE";

std::string rigol_number(double value) {
  return std::isinf(value) ? "9.900000E+37" : fmt::format("{:.6E}", value);
}
std::string on_or_off(bool on) {
  return on ? "ON" : "OFF";
}

class Rigol : public ScpiDialect {
 public:
  explicit Rigol(GeneratorState& state) : ScpiDialect(state, {kErrorsKept, false}) {
    add_output();
    add_wave();
    add_burst();
    add_data();
  }
  void lose_power() override {
    ScpiDialect::lose_power();
    reset();
  }

 private:
  void add_output();
  void add_wave();
  void add_burst();
  void add_data();
  void apply(GeneratorFunction function, std::string_view argument);
  void take_packet(std::string_view argument);
  void take_values(std::string_view argument);
  void end_upload(std::vector<std::int16_t> codes);

  std::optional<double> out_of_range(double /*limit*/) override {
    error(-222, "Data out of range");  // the setting stays
    return std::nullopt;
  }
  std::int64_t ready_for_query() const override { return busy_until_; }
  std::int64_t complete() const override { return busy_until_; }
  // "Only for the manual source, and when the output is on" (guide, BURSt:TRIGger:IMMediate).
  void trigger() override {
    const GeneratorSettings& now = state_.settings();
    if (now.burst_on && now.trigger == TriggerSource::kManual && now.output_on) {
      state_.player().trigger();
    } else {
      error(-211, "Trigger ignored");
    }
  }
  void reset() override {
    packets_.clear();
    idle_ = "FPT";
  }

  std::vector<std::int16_t> packets_;  // before END
  std::int64_t busy_until_ = std::numeric_limits<std::int64_t>::min();
  std::string idle_ = "FPT";
};

struct RigolFunction {
  GeneratorFunction function;
  std::string_view name;
};
// An uploaded waveform is USER (guide, FUNCtion[:SHAPe]); ARB is the name of later series.
constexpr RigolFunction kRigolFunctions[] = {
    {GeneratorFunction::kSine, "SINusoid"},      {GeneratorFunction::kSquare, "SQUare"},
    {GeneratorFunction::kRamp, "RAMP"},          {GeneratorFunction::kPulse, "PULSe"},
    {GeneratorFunction::kNoise, "NOISe"},        {GeneratorFunction::kDc, "DC"},
    {GeneratorFunction::kArbitrary, "USER"},     {GeneratorFunction::kArbitrary, "CUSTom"},
    {GeneratorFunction::kArbitrary, "ARBitrary"}};

void Rigol::add_output() {
  add(
      "OUTPut[:STATe]",
      [this](std::string_view argument) {
        flag(argument, [this](bool on) {
          change([&](GeneratorSettings& next) {
            next.output_on = on || (next.output_on && state_.faults().ignores_output_off);
          });
        });
      },
      [this](std::string_view) { return on_or_off(state_.settings().output_on); });
  for (const std::string_view pattern : {"OUTPut:LOAD", "OUTPut:IMPedance"}) {
    add(
        pattern,
        [this](std::string_view argument) {
          if (is_form_of(argument, "INFinity")) {
            state_.set_load(std::numeric_limits<double>::infinity());
            return;
          }
          number(argument, 1, 10e3, [this](double load_ohm) { state_.set_load(load_ohm); });
        },
        [this](std::string_view) { return rigol_number(state_.settings().load_ohm); });
  }
  add(
      "OUTPut:POLarity",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"NORMal", "INVerted"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) { next.inverted = name == "INVerted"; });
        }
      },
      [this](std::string_view) { return state_.settings().inverted ? "INVERTED" : "NORMAL"; });
}

void Rigol::add_wave() {
  add(
      "[SOURce:]FUNCtion[:SHAPe]",
      [this](std::string_view argument) {
        for (const RigolFunction& row : kRigolFunctions) {
          if (is_form_of(argument, row.name)) {
            change([&](GeneratorSettings& next) { next.function = row.function; });
            return;
          }
        }
        error(-220, "Parameter error");
      },
      [this](std::string_view) {
        const auto* const row = std::find_if(std::begin(kRigolFunctions), std::end(kRigolFunctions),
                                             [this](const RigolFunction& known) {
                                               return known.function == state_.settings().function;
                                             });
        return short_form(row->name);
      });
  add(
      "[SOURce:]FREQuency[:FIXed]",
      [this](std::string_view argument) {
        number(argument, 1e-6, state_.highest_frequency_hz(state_.settings().function),
               [this](double value) {
                 change([&](GeneratorSettings& next) { next.frequency_hz = value; });
               });
      },
      [this](std::string_view) { return rigol_number(state_.settings().frequency_hz); });
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate][:AMPLitude]",
      [this](std::string_view argument) {
        number(argument, state_.lowest_vpp(), state_.highest_vpp(state_.settings().offset_v),
               [this](double value) {
                 change([&](GeneratorSettings& next) { next.amplitude_vpp = value; });
               });
      },
      [this](std::string_view) { return rigol_number(state_.settings().amplitude_vpp); });
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate]:OFFSet",
      [this](std::string_view argument) {
        const double room = state_.highest_peak_v() - state_.settings().amplitude_vpp / 2;
        number(argument, -room, room, [this](double value) {
          change([&](GeneratorSettings& next) { next.offset_v = value; });
        });
      },
      [this](std::string_view) { return rigol_number(state_.settings().offset_v); });
  add(
      "[SOURce:]VOLTage:UNIT",
      [this](std::string_view argument) {
        if (upper(argument) != "VPP") {
          error(-220, "Parameter error");  // not emulated
        }
      },
      [](std::string_view) { return "VPP"; });
  add(
      "[SOURce:]PHASe",
      [this](std::string_view argument) {
        number(argument, 0, 360, [this](double value) {
          change([&](GeneratorSettings& next) { next.phase_deg = value; });
        });
      },
      [this](std::string_view) { return rigol_number(state_.settings().phase_deg); });
  add(
      "[SOURce:]FUNCtion:ARB:MODE",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"SRATe", "FREQuency"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) {
            next.point_rate = name == "SRATe" ? PointRate::kSampleRate : PointRate::kFrequency;
          });
        }
      },
      [this](std::string_view) {
        return state_.settings().point_rate == PointRate::kSampleRate ? "SRATE" : "FREQ";
      });
  add(
      "[SOURce:]FUNCtion:ARB:SRATe",
      [this](std::string_view argument) {
        number(argument, 1e-6, state_.facts().highest_rate_hz, [this](double value) {
          change([&](GeneratorSettings& next) { next.sample_rate_hz = value; });
        });
      },
      [this](std::string_view) { return rigol_number(state_.settings().sample_rate_hz); });
  // APPLy does not switch the output on. APPLy:ARBitrary sets USER and SRATE (guide).
  const auto add_apply = [this](std::string_view pattern, GeneratorFunction function) {
    add(pattern, [this, function](std::string_view argument) { apply(function, argument); }, {});
  };
  add_apply("[SOURce:]APPLy:SINusoid", GeneratorFunction::kSine);
  add_apply("[SOURce:]APPLy:SQUare", GeneratorFunction::kSquare);
  add_apply("[SOURce:]APPLy:RAMP", GeneratorFunction::kRamp);
  add_apply("[SOURce:]APPLy:USER", GeneratorFunction::kArbitrary);
  add_apply("[SOURce:]APPLy:ARBitrary", GeneratorFunction::kArbitrary);
}

void Rigol::apply(GeneratorFunction function, std::string_view argument) {
  const auto fields = fields_of(argument);
  GeneratorSettings next = state_.settings();
  next.function = function;
  if (function == GeneratorFunction::kArbitrary) {
    next.point_rate = PointRate::kSampleRate;
  }
  state_.set(next);
  constexpr std::string_view kParts[] = {"FREQ", "VOLT", "VOLT:OFFS", "PHAS"};
  for (std::size_t i = 0; i < fields.size() && i < std::size(kParts); ++i) {
    const bool rate = i == 0 && function == GeneratorFunction::kArbitrary;
    execute(std::string(rate ? "FUNC:ARB:SRAT" : kParts[i]) + " " + std::string(fields[i]) + "\n");
  }
}

void Rigol::add_burst() {
  add(
      "[SOURce:]BURSt[:STATe]",
      [this](std::string_view argument) {
        flag(argument,
             [this](bool on) { change([&](GeneratorSettings& next) { next.burst_on = on; }); });
      },
      [this](std::string_view) { return on_or_off(state_.settings().burst_on); });
  // Gated bursts are not emulated.
  add(
      "[SOURce:]BURSt:MODE",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"TRIGgered", "INFinity"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) {
            const bool infinite = name == "INFinity";
            if (infinite != std::isinf(next.burst_cycles)) {
              next.burst_cycles = infinite ? std::numeric_limits<double>::infinity() : 1.0;
            }
          });
        }
      },
      [this](std::string_view) {
        return std::isinf(state_.settings().burst_cycles) ? "INF" : "TRIG";
      });
  add(
      "[SOURce:]BURSt:NCYCles",
      [this](std::string_view argument) {
        number(argument, 1, 1e6, [this](double value) {
          change([&](GeneratorSettings& next) { next.burst_cycles = std::round(value); });
        });
      },
      [this](std::string_view) { return rigol_number(state_.settings().burst_cycles); });
  add(
      "[SOURce:]BURSt:INTernal:PERiod",
      [this](std::string_view argument) {
        number(argument, 1e-6, 500, [this](double value) {
          change([&](GeneratorSettings& next) { next.burst_period_s = value; });
        });
      },
      [this](std::string_view) { return rigol_number(state_.settings().burst_period_s); });
  add(
      "[SOURce:]BURSt:TRIGger:SOURce",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"INTernal", "EXTernal", "MANual"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) {
            next.trigger = name == "INTernal"   ? TriggerSource::kInternal
                           : name == "EXTernal" ? TriggerSource::kExternal
                                                : TriggerSource::kManual;
          });
        }
      },
      [this](std::string_view) {
        constexpr std::string_view kSources[] = {"INT", "EXT", "MAN"};
        return std::string(kSources[static_cast<std::size_t>(state_.settings().trigger)]);
      });
  add("[SOURce:]BURSt:TRIGger[:IMMediate]", [this](std::string_view) { trigger(); }, {});
  add("TRIGger[:IMMediate]", [this](std::string_view) { trigger(); }, {});
  add(
      "[SOURce:]BURSt:TDELay",
      [this](std::string_view argument) { number(argument, 0, 85, [](double) {}); },
      [](std::string_view) { return rigol_number(0); });
  // A code of 14 bits, or the first point, top, centre, bottom.
  add(
      "[SOURce:]BURSt:IDLE",
      [this](std::string_view argument) {
        if (const auto code = number_of(argument); code && std::isfinite(*code)) {
          if (*code < 0 || *code > kHighestCode) {
            error(-222, "Data out of range");
            return;
          }
          idle_ = fmt::format("{:.0f}", *code);
          state_.set_idle(2 * *code / kHighestCode - 1);
          return;
        }
        const auto name = one_of(argument, {"FPT", "TOP", "CENTER", "BOTTOM"});
        if (!name.empty()) {
          idle_ = name;
          state_.set_idle(name == "FPT" ? std::nullopt
                                        : std::optional<double>(name == "TOP"      ? 1.0
                                                                : name == "BOTTOM" ? -1.0
                                                                                   : 0.0));
        }
      },
      [this](std::string_view) { return idle_; });
}

void Rigol::add_data() {
  add("[SOURce:][TRACe:]DATA:DAC16", [this](std::string_view argument) { take_packet(argument); },
      {});
  add("[SOURce:][TRACe:]DATA[:DATA]", [this](std::string_view argument) { take_values(argument); },
      {});
  add("[SOURce:][TRACe:]DATA:POINts", {}, [this](std::string_view argument) {
    const GeneratorWaveform* const found =
        upper(argument) == kVolatile ? state_.find(std::string(kVolatile)) : nullptr;
    return std::to_string(found == nullptr ? 0 : found->points());
  });
  add(
      "[SOURce:][TRACe:]DATA:POINts:INTerpolate",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"LINear", "OFF"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) {
            next.between = name == "OFF" ? Between::kHold : Between::kLine;
          });
        }
      },
      [this](std::string_view) {
        return state_.settings().between == Between::kLine ? "LINEAR" : "OFF";
      });
  // The syntax of the DG1000 and DG4000 is known, and refused.
  for (const std::string_view older :
       {"[SOURce:][TRACe:]DATA:DAC", "[SOURce:]FUNCtion:USER", "[SOURce:]DATA:LOAD"}) {
    add(older, [this](std::string_view) { error(-220, "Parameter error"); }, {});
  }
}

// "VOLATILE,CON|END,#5…": little-endian codes 0 … 3FFF.
void Rigol::take_packet(std::string_view argument) {
  const auto comma = argument.find(',');
  const auto second = comma == std::string_view::npos ? comma : argument.find(',', comma + 1);
  if (second == std::string_view::npos || upper(argument.substr(0, comma)) != kVolatile) {
    error(-220, "Parameter error");
    return;
  }
  const std::string flag = upper(trimmed(argument.substr(comma + 1, second - comma - 1)));
  const auto bytes = block_of(left_trimmed(argument.substr(second + 1)));
  if (!bytes || bytes->size() % 2 != 0 || (flag != "CON" && flag != "END")) {
    error(-220, "Parameter error");
    return;
  }
  const std::int64_t now = state_.time().now();
  if (now < busy_until_) {
    return;  // lost, and not reported
  }
  busy_until_ = now + kPacket_steps;
  if (bytes->size() > kMostPacketBytes || bytes->size() / 2 < state_.facts().fewest_points) {
    error(bytes->size() > kMostPacketBytes ? -223 : -220,
          bytes->size() > kMostPacketBytes ? "Too much data" : "Parameter error");
    return;
  }
  std::vector<std::int16_t> codes = packets_;
  for (std::size_t i = 0; i < bytes->size(); i += 2) {
    const auto low = static_cast<unsigned char>((*bytes)[i]);
    const auto high = static_cast<unsigned char>((*bytes)[i + 1]);
    const int code = low | high << 8;
    if (code > kHighestCode) {
      error(-222, "Data out of range");
      return;
    }
    codes.push_back(static_cast<std::int16_t>(code));
  }
  if (flag == "CON") {
    packets_ = std::move(codes);
  } else {
    packets_.clear();
    end_upload(std::move(codes));
  }
}

// "VOLATILE,0.1,-0.5,…": −1 … 1.
void Rigol::take_values(std::string_view argument) {
  const auto fields = fields_of(argument);
  if (fields.size() < 2 || upper(fields[0]) != kVolatile) {
    error(-220, "Parameter error");
    return;
  }
  std::vector<std::int16_t> codes;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const auto value = number_of(fields[i]);
    if (!value || std::abs(*value) > 1) {
      error(-222, "Data out of range");
      return;
    }
    codes.push_back(static_cast<std::int16_t>(std::lround((*value + 1) / 2 * kHighestCode)));
  }
  end_upload(std::move(codes));
}

// The output switches to the waveform by itself, in SRATE mode, and leaves burst mode. It is not
// switched on.
void Rigol::end_upload(std::vector<std::int16_t> codes) {
  const std::size_t points = codes.size();
  state_.forget_waveforms();
  if (points > state_.facts().most_points || !state_.has_room(points)) {
    error(-321, "Out of memory");
    return;
  }
  const double zero = kHighestCode / 2.0;
  state_.store({std::string(kVolatile), std::move(codes), zero, 1 / zero});
  change([&](GeneratorSettings& next) {
    next.function = GeneratorFunction::kArbitrary;
    next.waveform = kVolatile;
    next.point_rate = PointRate::kSampleRate;
    next.burst_on = false;
    next.output_on = next.output_on || state_.faults().upload_switches_on;
  });
}

}  // namespace

std::unique_ptr<GeneratorDialect> make_rigol(GeneratorState& state) {
  return std::make_unique<Rigol>(state);
}

}  // namespace gsbench::emulation
