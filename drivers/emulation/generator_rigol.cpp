#include "generator_rigol.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

constexpr std::size_t kRigolErrorsKept = 20;
constexpr double kMostRigolCycles = 1e6;

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

constexpr std::string_view kRigolSources[] = {"INTernal", "EXTernal", "MANual"};

}  // namespace

Rigol::Rigol(GeneratorState& state) : ScpiDialect(state, {kRigolErrorsKept, false}) {
  add_output();
  add_wave();
  add_burst();
  add_idle();
  add_data();
}

void Rigol::lose_power() {
  ScpiDialect::lose_power();
  reset();
}

void Rigol::reset() {
  packets_.clear();
  idle_ = "FPT";
}

// Seven digits; INFinity is 9.900000E+37 (guide, OUTPut:IMPedance).
std::string Rigol::written(double value) const {
  return std::isinf(value) ? "9.900000E+37" : fmt::format("{:.6E}", value);
}

// The setting stays.
std::optional<double> Rigol::out_of_range(double /*limit*/) {
  error(-222, "Data out of range");
  return std::nullopt;
}

// A trigger counts with the manual source and the output on (guide, BURSt:TRIGger:IMMediate).
void Rigol::trigger() {
  const GeneratorSettings& now = state_.settings();
  if (now.burst_on && now.trigger == TriggerSource::kManual && now.output_on) {
    state_.player().trigger();
  } else {
    error(-211, "Trigger ignored");
  }
}

void Rigol::add_output() {
  add_flag("OUTPut[:STATe]", &GeneratorSettings::output_on);
  add_load("OUTPut:LOAD");
  add_load("OUTPut:IMPedance");
  add_polarity("NORMAL", "INVERTED");
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
  add_number("[SOURce:]FREQuency[:FIXed]", &GeneratorSettings::frequency_hz, frequencies());
  add_number("[SOURce:]VOLTage[:LEVel][:IMMediate][:AMPLitude]", &GeneratorSettings::amplitude_vpp,
             [this] {
               return std::pair(state_.lowest_vpp(),
                                state_.highest_vpp(state_.settings().offset_v));
             });
  add_number("[SOURce:]VOLTage[:LEVel][:IMMediate]:OFFSet", &GeneratorSettings::offset_v,
             offsets());
  add_number("[SOURce:]PHASe[:ADJust]", &GeneratorSettings::phase_deg, 0, 360);
  add(
      "[SOURce:]VOLTage:UNIT",
      [this](std::string_view argument) {
        if (upper(argument) != "VPP") {
          error(-220, "Parameter error");  // not emulated
        }
      },
      [](std::string_view) { return "VPP"; });
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
  add_number("[SOURce:]FUNCtion:ARB:SRATe", &GeneratorSettings::sample_rate_hz, 1e-6,
             state_.facts().highest_rate_hz);
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
  add_flag("[SOURce:]BURSt[:STATe]", &GeneratorSettings::burst_on);
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
        number(argument, 1, kMostRigolCycles, [this](double value) {
          change([&](GeneratorSettings& next) { next.burst_cycles = std::round(value); });
        });
      },
      [this](std::string_view) { return written(state_.settings().burst_cycles); });
  add_number("[SOURce:]BURSt:INTernal:PERiod", &GeneratorSettings::burst_period_s, 1e-6, 500);
  add_number("[SOURce:]BURSt:PHASe", &GeneratorSettings::phase_deg, 0, 360);
  add(
      "[SOURce:]BURSt:TRIGger:SOURce",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"INTernal", "EXTernal", "MANual"});
        if (!name.empty()) {
          const auto* const at =
              std::find(std::begin(kRigolSources), std::end(kRigolSources), name);
          change([&](GeneratorSettings& next) {
            next.trigger = static_cast<TriggerSource>(at - std::begin(kRigolSources));
          });
        }
      },
      [this](std::string_view) {
        return short_form(kRigolSources[static_cast<std::size_t>(state_.settings().trigger)]);
      });
  add("[SOURce:]BURSt:TRIGger[:IMMediate]", [this](std::string_view) { trigger(); }, {});
  add("TRIGger[:IMMediate]", [this](std::string_view) { trigger(); }, {});
}

// Between bursts: a code of 14 bits, or the first point, top, centre, bottom.
void Rigol::add_idle() {
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

std::unique_ptr<GeneratorDialect> make_rigol(GeneratorState& state) {
  return std::make_unique<Rigol>(state);
}

}  // namespace gsbench::emulation
