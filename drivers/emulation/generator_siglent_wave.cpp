// BSWV, the basic wave: function, frequency, amplitude, offset, phase.
#include "generator_scpi.hpp"
#include "generator_siglent.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

struct SiglentFunction {
  GeneratorFunction function;
  std::string_view name;
};
constexpr SiglentFunction kSiglentFunctions[] = {
    {GeneratorFunction::kSine, "SINE"},    {GeneratorFunction::kSquare, "SQUARE"},
    {GeneratorFunction::kRamp, "RAMP"},    {GeneratorFunction::kPulse, "PULSE"},
    {GeneratorFunction::kNoise, "NOISE"},  {GeneratorFunction::kDc, "DC"},
    {GeneratorFunction::kArbitrary, "ARB"}};

std::string_view siglent_name(GeneratorFunction function) {
  return std::find_if(std::begin(kSiglentFunctions), std::end(kSiglentFunctions),
                      [&](const SiglentFunction& row) { return row.function == function; })
      ->name;
}

// Settings are rounded to what the front panel shows: 1 mV, 1 µHz.
double in_steps(double value, double step) {
  return std::round(value / step) * step;
}

}  // namespace

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
      for (const SiglentFunction& row : kSiglentFunctions) {
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
      const double room = std::max(0.0, peak - next.amplitude_vpp / 2);
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

}  // namespace gsbench::emulation
