#include "generator_keysight.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

constexpr std::size_t kKeysightErrorsKept = 20;

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

constexpr std::string_view kKeysightSources[] = {"IMMediate", "EXTernal", "BUS"};

}  // namespace

Keysight::Keysight(GeneratorState& state) : ScpiDialect(state, {kKeysightErrorsKept, true}) {
  add_output();
  add_wave();
  add_levels();
  add_arbitrary();
  add_data();
  add_burst();
}

void Keysight::lose_power() {
  ScpiDialect::lose_power();
  reset();
}

// Volatile waveforms stay, so that their names are taken after *RST as well.
void Keysight::reset() {
  shape_ = "SINusoid";
  unit_ = "VPP";
  filter_ = "STEP";
  swapped_ = false;
}

std::string Keysight::written(double value) const {
  return std::isinf(value) ? "+9.900000000000000E+37" : fmt::format("{:+.15E}", value);
}

// The value is clipped and reported (guide, error -222).
std::optional<double> Keysight::out_of_range(double limit) {
  error(-222, "Data out of range; value clipped to limit");
  return limit;
}

// "*OPC? returns 1 to the output buffer when the sweep or burst is complete", *WAI waits as long
// (guide, TRIGger Subsystem). A burst that repeats by itself is not waited for.
std::int64_t Keysight::complete() const {
  const GeneratorSettings& now = state_.settings();
  return now.burst_on && now.trigger != TriggerSource::kInternal ? state_.player().burst_end()
                                                                 : state_.time().now();
}

void Keysight::trigger() {
  const GeneratorSettings& now = state_.settings();
  if (now.burst_on && now.trigger == TriggerSource::kManual) {
    state_.player().trigger();
  } else {
    error(-211, "Trigger ignored");
  }
}

// The last ones are without effect on the output.
void Keysight::add_output() {
  add_flag("OUTPut[:STATe]", &GeneratorSettings::output_on);
  add_load("OUTPut:LOAD");
  add_polarity("NORM", "INV");
  for (const std::string_view pattern :
       {"DISPlay[:STATe]", "DISPlay:TEXT", "DISPlay:TEXT:CLEar", "SYSTem:BEEPer[:IMMediate]",
        "SYSTem:REMote", "SYSTem:LOCal", "SYSTem:RWLock", "STATus:PRESet", "OUTPut:SYNC[:STATe]",
        "UNIT:ANGLe", "[SOURce:]VOLTage:RANGe:AUTO"}) {
    add(pattern, [](std::string_view) {}, {});
  }
}

// The front panel may have chosen another function than the last command.
std::string_view Keysight::shape() const {
  const GeneratorFunction now = state_.settings().function;
  std::string_view last;
  for (const KeysightFunction& row : kKeysightFunctions) {
    if (row.function == now) {
      if (row.name == shape_) {
        return shape_;
      }
      last = row.name;
    }
  }
  return last;
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
      [this](std::string_view) { return short_form(shape()); });
  add_number("[SOURce:]FREQuency[:CW][:FIXed]", &GeneratorSettings::frequency_hz, frequencies());
  add_number("[SOURce:]FUNCtion:SQUare:DCYCle", &GeneratorSettings::duty_pct, 0.01, 99.99);
  add_number("[SOURce:]FUNCtion:RAMP:SYMMetry", &GeneratorSettings::symmetry_pct, 0, 100);
  add_number("[SOURce:]PHASe[:ADJust]", &GeneratorSettings::phase_deg, -360, 360);
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

void Keysight::add_burst() {
  add_flag("[SOURce:]BURSt[:STATe]", &GeneratorSettings::burst_on);
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
      [this](std::string_view) { return written(state_.settings().burst_cycles); });
  add_number("[SOURce:]BURSt:INTernal:PERiod", &GeneratorSettings::burst_period_s, 1e-6, 8000);
  add_number("[SOURce:]BURSt:PHASe", &GeneratorSettings::phase_deg, -360, 360);
  add(
      "TRIGger:SOURce",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"IMMediate", "EXTernal", "BUS"});
        if (!name.empty()) {
          const auto* const at =
              std::find(std::begin(kKeysightSources), std::end(kKeysightSources), name);
          change([&](GeneratorSettings& next) {
            next.trigger = static_cast<TriggerSource>(at - std::begin(kKeysightSources));
          });
        }
      },
      [this](std::string_view) {
        return short_form(kKeysightSources[static_cast<std::size_t>(state_.settings().trigger)]);
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

std::unique_ptr<GeneratorDialect> make_keysight(GeneratorState& state) {
  return std::make_unique<Keysight>(state);
}

}  // namespace gsbench::emulation
