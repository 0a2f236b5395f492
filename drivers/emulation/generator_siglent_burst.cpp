#include "generator_scpi.hpp"
#include "generator_siglent.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

constexpr double kMostSiglentCycles = 1e6;

}  // namespace

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
          infinite_ ? *number : std::clamp(std::round(*number), 1.0, kMostSiglentCycles);
      next.trigger = infinite_ ? TriggerSource::kExternal : next.trigger;
    } else if (key == "PRD" && number && next.trigger == TriggerSource::kInternal) {
      next.burst_period_s = std::clamp(*number, 1e-6, 1000.0);
    } else if (key == "STPS" && number && std::isfinite(*number)) {
      next.phase_deg = *number - 360 * std::floor(*number / 360);
    }
    state_.set(next);
  }
}

}  // namespace gsbench::emulation
