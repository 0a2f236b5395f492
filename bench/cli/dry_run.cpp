#include "dry_run.hpp"

#include "commands.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <station/dry_run.hpp>
#include <station/source_check.hpp>

namespace gsbench::cli {
namespace {

using nlohmann::ordered_json;

ordered_json text_or_null(const std::string& text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

ordered_json outlet_json(const profile::Outlet& outlet, const station::Slot& slot) {
  return {{"outlet", outlet.id},
          {"place", slot.place},
          {"serial_number", slot.serial_number},
          {"link", text_or_null(slot.link_id.value_or(""))},
          {"relay_channel",
           slot.relay_channel ? ordered_json(*slot.relay_channel) : ordered_json(nullptr)},
          {"relay", text_or_null(slot.relay_name)}};
}

void print_as_json(const profile::Plan& plan, const std::string& station,
                   const station::DryRun& dry) {
  const station::Deviations deviations = station::deviations_of(dry.played);
  const profile::Tolerances& tolerances = plan.stimulus.tolerances;
  ordered_json out = {{"profile", plan.name},
                      {"station", station},
                      {"boot_s", dry.boot_s},
                      {"markers_before_s", dry.markers_before_s},
                      {"run_s", dry.run_s},
                      {"markers_after_s", dry.markers_after_s},
                      {"source",
                       {{"name", dry.source},
                        {"how", dry.played.how},
                        {"accuracy", text_or_null(dry.accuracy)},
                        {"frequency_mhz", deviations.frequency_mhz},
                        {"frequency_tolerance_mhz", tolerances.frequency_mhz},
                        {"voltage_pct", deviations.voltage_pct},
                        {"amplitude_pct", 1e2 * dry.played.amplitude_pu},
                        {"voltage_tolerance_pct", tolerances.voltage_pct},
                        {"time_ms", deviations.time_ms},
                        {"time_tolerance_ms", tolerances.time_ms}}},
                      {"clocks", ordered_json::array()},
                      {"outlets", ordered_json::array()}};
  for (const station::DryRun::Clock& clock : dry.clocks) {
    out["clocks"].push_back({{"what", clock.what},
                             {"aligned_by", clock.aligned_by},
                             {"uncertainty_ms", clock.uncertainty_ms},
                             {"not_known_yet", text_or_null(clock.not_known_yet)}});
  }
  for (std::size_t i = 0; i < dry.slots.size(); ++i) {
    out["outlets"].push_back(outlet_json(plan.outlets[i], dry.slots[i]));
  }
  print_json(out);
}

std::string outlet_line(const profile::Outlet& outlet, const station::Slot& slot) {
  const std::string relay =
      !slot.relay_channel ? "contact not sensed"
      : slot.relay_name.empty()
          ? fmt::format("relay channel {}", *slot.relay_channel)
          : fmt::format("relay channel {} ({})", *slot.relay_channel, slot.relay_name);
  return fmt::format("  {}: place {}, {}, {}", outlet.id, slot.place,
                     slot.link_id ? "link " + *slot.link_id : "no link", relay);
}

void print_as_text(const profile::Plan& plan, const std::string& station,
                   const station::DryRun& dry) {
  constexpr std::size_t kIndent = 4;
  const auto line = [](const std::string& text) { print_wrapped(text, kIndent); };
  const station::Deviations deviations = station::deviations_of(dry.played);
  const profile::Tolerances& tolerances = plan.stimulus.tolerances;
  line(fmt::format("{} at station {}: nothing was energised", plan.name, station));
  line(dry.boot_s > 0.0
           ? fmt::format("Outlets: up to {:.3g} s at nominal voltage to boot and join", dry.boot_s)
           : "Outlets: ready at once");
  line(
      dry.markers_before_s > 0.0
          ? fmt::format("Signal: {:.3f} s, with voltage dips {:.3f} s before and {:.3f} s after it",
                        dry.run_s, dry.markers_before_s, dry.markers_after_s)
          : fmt::format("Signal: {:.3f} s", dry.run_s));
  line(fmt::format("Source: {}", dry.source));
  for (const std::string& how : dry.played.how) {
    line("  " + how);
  }
  line(fmt::format("  frequency within {:.3g} mHz (tolerance {:.3g})", deviations.frequency_mhz,
                   tolerances.frequency_mhz));
  line(fmt::format("  voltage within {:.3g} % of the nominal peak (tolerance {:.3g}){}",
                   deviations.voltage_pct, tolerances.voltage_pct,
                   dry.played.amplitude_pu > 0.0
                       ? fmt::format(", of which {:.3g} % is the accuracy of the amplitude",
                                     1e2 * dry.played.amplitude_pu)
                       : ""));
  line(fmt::format("  time within {:.3g} ms (tolerance {:.3g})", deviations.time_ms,
                   tolerances.time_ms));
  line("  accuracy: " + (dry.accuracy.empty() ? "exact" : dry.accuracy));
  line("Clocks:");
  for (const station::DryRun::Clock& clock : dry.clocks) {
    line(fmt::format("  {}: {}, {}{}", clock.what, clock.aligned_by,
                     std::isnan(clock.uncertainty_ms)
                         ? "uncertainty measured in the run"
                         : fmt::format("± {:.3g} ms", clock.uncertainty_ms),
                     clock.not_known_yet.empty()
                         ? ""
                         : "; not known before the run, and not included: " + clock.not_known_yet));
  }
  line("Outlets of the profile and their slots:");
  for (std::size_t i = 0; i < dry.slots.size(); ++i) {
    line(outlet_line(plan.outlets[i], dry.slots[i]));
  }
}

}  // namespace

int dry_run(const profile::Plan& plan, station::Station& station, bool json) {
  const station::DryRun dry = station::dry_run(plan, station);
  (json ? print_as_json : print_as_text)(plan, station.name(), dry);
  return kPassed;
}

}  // namespace gsbench::cli
