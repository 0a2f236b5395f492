#include "firmware_outlets.hpp"

#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <models/adc.hpp>
#include <models/noise.hpp>

namespace gsbench::fleet {
namespace {

constexpr std::size_t kOutletsInChunk = 50;

control_centre::Rules rules_of(Strategy strategy) {
  return strategy == Strategy::kPaper ? control_centre::Rules::kPaper
                                      : control_centre::Rules::kGsbench;
}

}  // namespace

FirmwareOutlets::FirmwareOutlets(const profile::Plan& plan, const Fleet& fleet, Strategy strategy,
                                 const Controls& controls, std::int64_t first_loss_tick,
                                 std::size_t threads)
    : plan_(plan),
      fleet_(fleet),
      first_loss_tick_(first_loss_tick),
      settings_(control_centre::grid_settings(plan.grid, rules_of(strategy))),
      switch_off_hz_(switch_off_hz(plan.grid, fleet, rules_of(strategy))),
      outlets_(fleet.outlets()),
      switched_((fleet.outlets() + kOutletsInChunk - 1) / kOutletsInChunk),
      workers_(threads) {
  hardware_.sample_rate_hz = static_cast<std::int32_t>(plan.stimulus.sample_rate_hz);
  hardware_.counts_per_pu = models::kCounts_per_pu;
  hardware_.nominal_hz = static_cast<std::int32_t>(std::lround(plan.grid.nominal_hz));
  settings_.version = 1;
  settings_.method = strategy == Strategy::kPaper ? gs::outlet::kByPaper : gs::outlet::kByGridState;
  if (controls.threshold_mw > 0.0) {
    settings_.threshold_mw = static_cast<float>(controls.threshold_mw);
  }
  configure();
}

gs::outlet::Settings FirmwareOutlets::settings_of(std::size_t outlet) const {
  gs::outlet::Settings settings = settings_;
  const std::size_t group = outlet / fleet_.per_group;
  settings.accumulated_mw = static_cast<float>(fleet_.accumulated_mw[group]);
  settings.switch_off_hz = static_cast<float>(switch_off_hz_[group]);
  return settings;
}

void FirmwareOutlets::configure() {
  const auto samples_in_report = static_cast<std::size_t>(plan_.stimulus.sample_rate_hz / 1000) *
                                 static_cast<std::size_t>(gs::outlet::kReport_ms);
  for (std::size_t i = 0; i < outlets_.size(); ++i) {
    Outlet& outlet = outlets_[i];
    outlet.skipped = i * 37 % samples_in_report;
    if (!gs::outlet::configure(hardware_, outlet.config)) {
      throw std::invalid_argument(fmt::format("the firmware does not support {} samples per second",
                                              hardware_.sample_rate_hz));
    }
    const gs::outlet::SettingsError error = apply(outlet.config, outlet.state, settings_of(i));
    if (error != gs::outlet::SettingsError::kNone) {
      throw std::invalid_argument(fmt::format("the firmware rejects the settings of group {}: {}",
                                              i / fleet_.per_group + 1, to_string(error)));
    }
  }
}

void FirmwareOutlets::send_settings_again(std::int64_t before_tick) {
  for (; updates_ < plan_.settings.size() &&
         waveform::tick_at(plan_.settings[updates_].at_s, plan_.stimulus.sample_rate_hz) <
             before_tick;
       ++updates_) {
    ++settings_.version;
    for (std::size_t i = 0; i < outlets_.size(); ++i) {
      // They were accepted once.
      apply(outlets_[i].config, outlets_[i].state, settings_of(i));
    }
  }
}

std::vector<Switched> FirmwareOutlets::take(std::int64_t first_tick,
                                            const std::vector<float>& voltage_pu) {
  send_settings_again(first_tick + static_cast<std::int64_t>(voltage_pu.size()));
  workers_.run(switched_.size(), [&](std::size_t chunk) { feed(chunk, first_tick, voltage_pu); });
  std::vector<Switched> all;
  for (std::vector<Switched>& some : switched_) {
    all.insert(all.end(), some.begin(), some.end());
    some.clear();
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Switched& a, const Switched& b) { return a.tick < b.tick; });
  return all;
}

void FirmwareOutlets::feed(std::size_t chunk, std::int64_t first_tick,
                           const std::vector<float>& voltage_pu) {
  const std::size_t first = chunk * kOutletsInChunk;
  const std::size_t end = std::min(first + kOutletsInChunk, outlets_.size());
  const std::size_t count = voltage_pu.size();
  std::vector<float> noisy(count);
  std::vector<std::int16_t> counts(count);
  for (std::size_t i = first; i < end; ++i) {
    Outlet& outlet = outlets_[i];
    noisy = voltage_pu;
    models::add_gaussian({plan_.seed, models::kSourceNoise, static_cast<std::uint32_t>(i)},
                         static_cast<std::uint64_t>(first_tick), count,
                         plan_.stimulus.noise_rms_pu(), noisy.data());
    std::transform(noisy.begin(), noisy.end(), counts.begin(),
                   [&](float pu) { return models::adc_counts(pu, hardware_.counts_per_pu); });
    std::size_t at = std::min(outlet.skipped, count);
    outlet.skipped -= at;
    while (at < count) {
      gs::outlet::Report report;
      bool ready = false;
      at += step(outlet.config, outlet.state, counts.data() + at, count - at, report, ready);
      if (ready) {
        note(i, report, first_tick + static_cast<std::int64_t>(at));
        renew(outlet.config, outlet.state);
      }
    }
  }
}

void FirmwareOutlets::note(std::size_t number, const gs::outlet::Report& report,
                           std::int64_t tick) {
  Outlet& outlet = outlets_[number];
  if ((report.happened & gs::outlet::kEvent) != 0) {
    if (tick < first_loss_tick_) {
      outlet.false_event = true;
    } else if (outlet.event_tick < 0) {
      outlet.event_tick = tick;
    }
  }
  if ((report.happened & gs::outlet::kDecision) != 0 && !outlet.loss_mw) {
    outlet.loss_mw = static_cast<double>(report.loss_mw);
  }
  if ((report.happened & gs::outlet::kRelay) != 0) {
    outlet.was_off = outlet.was_off || !report.relay_closed;
    const double power_mw = 1e-6 * static_cast<double>(fleet_.power_w[number]);
    switched_[number / kOutletsInChunk].push_back(
        {tick + kRelay_ms * plan_.stimulus.sample_rate_hz / 1000,
         report.relay_closed ? -power_mw : power_mw});
  }
}

OutletActions FirmwareOutlets::actions() const {
  OutletActions actions(plan_.grid.base_mw);
  std::size_t false_events = 0;
  for (const Outlet& outlet : outlets_) {
    actions.off += outlet.was_off ? 1 : 0;
    actions.events += outlet.event_tick >= 0 ? 1 : 0;
    false_events += outlet.false_event ? 1 : 0;
    if (outlet.event_tick >= 0) {
      const double event_s = static_cast<double>(outlet.event_tick) /
                             static_cast<double>(plan_.stimulus.sample_rate_hz);
      actions.latest_event_s = std::max(actions.latest_event_s.value_or(event_s), event_s);
    }
    if (outlet.loss_mw) {
      actions.loss_mw.add(*outlet.loss_mw);
    }
  }
  actions.false_events = false_events;
  return actions;
}

}  // namespace gsbench::fleet
