#include <algorithm>

#include <fmt/format.h>

#include <profile/load.hpp>
#include <station/source_check.hpp>

namespace gsbench::station {

Deviations deviations_of(const source::Played& played) {
  return {1e3 * played.frequency_hz, 1e2 * (played.voltage_pu + played.amplitude_pu),
          1e3 * played.time_s};
}

std::string beyond(const profile::Tolerances& tolerances, const Deviations& deviations) {
  std::string text;
  const auto compare = [&](const char* what, double value, const char* unit, const char* key,
                           double limit) {
    if (!(value <= limit)) {  // also for NaN
      text += fmt::format("{}{} by {:.3g} {} ({} is {:.3g})", text.empty() ? "" : ", ", what, value,
                          unit, key, limit);
    }
  };
  compare("frequency", deviations.frequency_mhz, "mHz", "frequency_tolerance_mhz",
          tolerances.frequency_mhz);
  compare("voltage", deviations.voltage_pct, "%", "voltage_tolerance_pct", tolerances.voltage_pct);
  compare("time", deviations.time_ms, "ms", "time_tolerance_ms", tolerances.time_ms);
  return text;
}

source::Played check_source(const profile::Plan& plan, const PlayedSignal& signal,
                            const source::Source& source) {
  drivers::Result<source::Played> played = source.check(signal);
  if (!played.ok()) {
    throw profile::ConfigurationError(plan.path + ": " + played.error());
  }
  const std::string excess = beyond(plan.stimulus.tolerances, deviations_of(played.value()));
  if (!excess.empty()) {
    throw profile::ConfigurationError(
        fmt::format("{}: {}: the played signal would deviate too much from the profile: {}",
                    plan.path, source.limits().name, excess));
  }
  return played.take();
}

PlayedSignal signal_of(const profile::Plan& plan, const std::vector<Slot>& slots,
                       const Station& station) {
  const bool any_link = std::any_of(slots.begin(), slots.end(),
                                    [](const Slot& slot) { return slot.link_id.has_value(); });
  return {plan, any_link && !station.outlets_count_ticks()};
}

}  // namespace gsbench::station
