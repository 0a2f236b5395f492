#include "faults.hpp"
#include "run_steps.hpp"
#include "watch.hpp"
#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>

#include <waveform/synthesizer.hpp>

namespace gsbench::station {
namespace {

// Time after the start by which an outlet must have acknowledged its settings.
constexpr double kSettingsAnswer_s = 0.096;
// The same for settings that are sent during the run: as long as an outlet may be silent.
constexpr double kLaterAnswer_s = 1.0;

// What is sent at a tick of the source.
struct Sending {
  std::int64_t at_tick;
  std::function<void(std::int64_t tick)> send;
};

void require_an_outlet(const std::vector<record::OutletRecord>& outlets) {
  if (outlets.empty()) {
    throw BenchFault("the run has no outlets");
  }
  if (std::all_of(outlets.begin(), outlets.end(),
                  [](const record::OutletRecord& outlet) { return !outlet.fault.empty(); })) {
    const record::OutletRecord& first = outlets.front();
    throw BenchFault("outlet " + first.id + " " + first.fault + "; no working outlet is left");
  }
}

std::vector<std::uint32_t> versions_sent(const std::vector<record::OutletRecord>& outlets) {
  std::vector<std::uint32_t> versions;
  for (const record::OutletRecord& outlet : outlets) {
    const auto version = outlet.settings.find("version");
    versions.push_back(
        version != outlet.settings.end() ? static_cast<std::uint32_t>(version->second) : 0);
  }
  return versions;
}

struct Player {
  const profile::Plan& plan;
  const std::vector<Slot>& slots;
  const PlayedSignal& signal;
  Station& station;
  const RunOptions& options;
  std::vector<record::OutletRecord>& outlets;
  capture::Capture& capture;
  Recorder& recorder;
  Watch watch = {outlets, plan.stimulus.sample_rate_hz};
  std::uint32_t requests = 0;
  std::vector<std::uint32_t> versions = versions_sent(outlets);  // of the settings
  link::Happenings happenings = {};
  std::vector<relay::Edge> edges = {};
  std::vector<bool> open_at_start = std::vector<bool>(slots.size());
  struct Sent {
    std::size_t outlet;
    bool switch_on;
    std::int64_t tick;  // that the source had reached
    std::chrono::steady_clock::time_point time;
  };
  std::vector<Sent> sent = {};

  bool play() {
    bool to_the_end = true;
    try {
      play_signal();
    } catch (const Stopped&) {
      to_the_end = false;
    } catch (const BenchFault&) {
      add_commands();
      throw;
    }
    add_commands();
    add_positions_at_start();
    return to_the_end;
  }

  void play_signal() {
    source::Source& source = station.source();
    const std::int64_t lead = signal.lead_ticks();
    const std::int64_t end = signal.total_ticks();
    // Without marker dips before the run, the answers arrive with its first reports.
    const std::int64_t answers_due = std::min(std::max(lead, tick_of(kSettingsAnswer_s)), end);
    const std::vector<Sending> sendings = all_sendings();
    auto next_sending = sendings.begin();
    require(source, source.start());
    for (std::int64_t tick = 0; tick < end;) {
      for (; next_sending != sendings.end() && next_sending->at_tick <= tick; ++next_sending) {
        next_sending->send(tick);
      }
      std::int64_t next = tick + std::max<std::int64_t>(tick_of(station.block_s()), 1);
      for (const std::int64_t stop :
           {answers_due, next_sending != sendings.end() ? next_sending->at_tick : end, end}) {
        next = stop > tick ? std::min(next, stop) : next;
      }
      const std::int64_t played = require(source, source.advance(next));
      listen(played);
      if (tick < answers_due && played >= answers_due) {
        watch.check_answers(capture);
      }
      tick = played;
      watch.check_later_answers(capture, tick);
      watch.check_silence(capture, tick);
      recorder.reached(tick);
      require_an_outlet(outlets);
      if (options.progress) {
        options.progress(static_cast<double>(tick) / static_cast<double>(end));
      }
    }
    require(source, source.stop());
  }

  std::int64_t tick_of(double t_s) const {
    return waveform::tick_at(t_s, plan.stimulus.sample_rate_hz);
  }

  // Ascending in time.
  std::vector<Sending> all_sendings() {
    std::vector<Sending> all;
    for (const profile::SettingsUpdate& update : plan.settings) {
      all.push_back({signal.lead_ticks() + tick_of(update.at_s),
                     [this, &update](std::int64_t tick) { send(update, tick); }});
    }
    for (const profile::Command& command : plan.commands) {
      all.push_back({signal.lead_ticks() + tick_of(command.at_s),
                     [this, &command](std::int64_t tick) { send(command, tick); }});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Sending& a, const Sending& b) { return a.at_tick < b.at_tick; });
    return all;
  }

  // Reads everything that has arrived up to the source's tick `now`.
  void listen(std::int64_t now) {
    happenings.clear();
    edges.clear();
    require(station.link().poll(happenings));
    require(station.relay_sense().poll(edges));
    watch.process(happenings, now);
    capture.add(happenings.messages);
    add_edges();
  }

  // Edges before and after the run are not kept, but the position of the contact at tick 0 is: an
  // open one is an opening at tick 0.
  void add_edges() {
    const relay::Alignment alignment = station.relay_sense().alignment();
    for (std::size_t i = 0; i < slots.size(); ++i) {
      for (const relay::Edge& edge : edges) {
        if (slots[i].relay_channel == edge.channel) {
          const std::int64_t tick = alignment.tick_of(edge.count) - signal.lead_ticks();
          if (tick > plan.duration_ticks()) {
            continue;
          }
          if (tick > 0) {
            capture.add_edge(outlets[i].id, tick, edge.closed);
          } else {
            open_at_start[i] = !edge.closed;
          }
        }
      }
    }
  }

  void add_positions_at_start() {
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (open_at_start[i]) {
        capture.add_edge(outlets[i].id, 0, false);
      }
    }
  }

  void send(const profile::SettingsUpdate& update, std::int64_t tick) {
    gs::wire::Downlink message;
    message.kind = gs::wire::DownlinkKind::kSettings;
    for (std::size_t i = 0; i < plan.outlets.size(); ++i) {
      const std::string& id = outlets[i].id;
      const auto settings = update.outlets.find(plan.outlets[i].id);
      if (settings == update.outlets.end() || !watch.is_watched(id)) {
        continue;
      }
      versions[i] = gs::outlet::next_version(versions[i]);
      message.settings = control_centre::outlet_settings(plan.grid, settings->second, versions[i]);
      capture.add_sent(id, station::sent(message, tick - signal.lead_ticks()));
      require(station.link().send(id, message));
      capture.add_settings(id, tick - signal.lead_ticks(), versions[i], update.changes);
      watch.expect_answer(id, update.at_s,
                          std::min(tick + tick_of(kLaterAnswer_s), signal.total_ticks()));
    }
  }

  // Only now: the relay sense may not have been aligned when a command was sent.
  void add_commands() {
    for (const Sent& command : sent) {
      capture.add_command(outlets[command.outlet].id, tick_sent(command) - signal.lead_ticks(),
                          command.switch_on);
    }
  }

  // The tick that the source plays at the time of sending. A generator is late by what its trigger
  // takes, which only a relay sense that is aligned with its voltage knows.
  std::int64_t tick_sent(const Sent& command) {
    const relay::RelaySense& sense = station.relay_sense();
    if (const std::optional<std::int64_t> count = sense.count_at(command.time)) {
      return sense.alignment().tick_of(*count);
    }
    if (const std::optional<source::HostClock> clock = station.source().host_clock()) {
      return std::llround(std::chrono::duration<double>(command.time - clock->tick_0).count() /
                          clock->tick_s);
    }
    return command.tick;
  }

  void send(const profile::Command& command, std::int64_t tick) {
    gs::wire::Downlink message;
    message.kind = gs::wire::DownlinkKind::kCommand;
    message.close_relay = command.switch_on;
    message.request = ++requests;
    for (std::size_t i = 0; i < plan.outlets.size(); ++i) {
      const std::string& id = outlets[i].id;
      const bool is_addressed =
          command.outlets.empty() ||
          std::count(command.outlets.begin(), command.outlets.end(), plan.outlets[i].id) > 0;
      if (is_addressed && watch.is_watched(id)) {
        capture.add_sent(id, station::sent(message, tick - signal.lead_ticks()));
        sent.push_back({i, command.switch_on, tick, std::chrono::steady_clock::now()});
        require(station.link().send(id, message));
      }
    }
  }
};

}  // namespace

bool play(const profile::Plan& plan, const std::vector<Slot>& slots, const PlayedSignal& signal,
          Station& station, const RunOptions& options, std::vector<record::OutletRecord>& outlets,
          capture::Capture& capture, Recorder& recorder) {
  return Player{plan, slots, signal, station, options, outlets, capture, recorder}.play();
}

}  // namespace gsbench::station
