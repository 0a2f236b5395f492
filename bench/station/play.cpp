#include "play.hpp"

#include "faults.hpp"
#include "watch.hpp"

#include <algorithm>

#include <waveform/tick.hpp>

namespace gsbench::station {
namespace {

// An outlet must have answered to its settings so soon after the start.
constexpr double kSettingsAnswerS = 0.096;

class Player {
 public:
  Player(const profile::Plan& plan, const std::vector<Slot>& slots, const PlayedSignal& signal,
         Station& station, const RunOptions& options, std::vector<record::OutletRecord>& outlets,
         capture::Capture& capture)
      : plan_(plan),
        slots_(slots),
        signal_(signal),
        station_(station),
        options_(options),
        outlets_(outlets),
        capture_(capture),
        watch_(outlets, plan.stimulus.sample_rate_hz) {}

  bool play() {
    const std::int64_t lead = signal_.lead_ticks();
    const std::int64_t end = signal_.total_ticks();
    // Where nothing is played before the run, answers come during its first reports.
    const std::int64_t answers_due = std::min(std::max(lead, tick_of(kSettingsAnswerS)), end);
    std::size_t command = 0;
    require(station_.source().start());
    for (std::int64_t tick = 0; tick < end;) {
      if (options_.stop != nullptr && options_.stop->load()) {
        return false;
      }
      for (; command < plan_.commands.size() && command_tick(command) <= tick; ++command) {
        send(plan_.commands[command], tick);
      }
      std::int64_t next = tick + std::max<std::int64_t>(tick_of(station_.block_s()), 1);
      for (const std::int64_t stop :
           {answers_due, command < plan_.commands.size() ? command_tick(command) : end, end}) {
        next = stop > tick ? std::min(next, stop) : next;
      }
      const std::int64_t played = require(station_.source().advance(next));
      listen(played);
      if (tick < answers_due && played >= answers_due) {
        watch_.check_answers(capture_);
      }
      tick = played;
      watch_.check_silence(capture_, tick);
      require_an_outlet(outlets_);
      if (options_.progress) {
        options_.progress(static_cast<double>(tick) / static_cast<double>(end));
      }
    }
    require(station_.source().stop());
    return true;
  }

 private:
  std::int64_t tick_of(double t_s) const {
    return waveform::tick_at(t_s, plan_.stimulus.sample_rate_hz);
  }

  std::int64_t command_tick(std::size_t command) const {
    return signal_.lead_ticks() + tick_of(plan_.commands[command].at_s);
  }

  // To all that came by the source's tick `now`.
  void listen(std::int64_t now) {
    happenings_.clear();
    edges_.clear();
    require(station_.link().poll(happenings_));
    require(station_.relay_sense().poll(edges_));
    watch_.hear(happenings_, now);
    capture_.add(happenings_.messages);
    add_edges();
  }

  void add_edges() {
    const relay::Alignment alignment = station_.relay_sense().alignment();
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      for (const relay::Edge& edge : edges_) {
        if (slots_[i].relay_channel == edge.channel) {
          capture_.add_edge(outlets_[i].id, alignment.tick_of(edge.count) - signal_.lead_ticks(),
                            edge.closed);
        }
      }
    }
  }

  void send(const profile::Command& command, std::int64_t tick) {
    gs::wire::Downlink message;
    message.kind = gs::wire::DownlinkKind::kCommand;
    message.close_relay = command.switch_on;
    message.request = ++requests_;
    for (std::size_t i = 0; i < plan_.outlets.size(); ++i) {
      const std::string& id = outlets_[i].id;
      const bool is_meant =
          command.outlets.empty() ||
          std::count(command.outlets.begin(), command.outlets.end(), plan_.outlets[i].id) > 0;
      if (is_meant && watch_.is_watched(id)) {
        require(station_.link().send(id, message));
        capture_.add_command(id, tick - signal_.lead_ticks(), command.switch_on);
      }
    }
  }

  const profile::Plan& plan_;
  const std::vector<Slot>& slots_;
  const PlayedSignal& signal_;
  Station& station_;
  const RunOptions& options_;
  std::vector<record::OutletRecord>& outlets_;
  capture::Capture& capture_;
  Watch watch_;
  std::uint32_t requests_ = 0;
  link::Happenings happenings_;
  std::vector<relay::Edge> edges_;
};

}  // namespace

void power_up(const PlayedSignal& signal, source::Source& source) {
  require(source.prepare(signal));
  require(source.energise());
}

bool play(const profile::Plan& plan, const std::vector<Slot>& slots, const PlayedSignal& signal,
          Station& station, const RunOptions& options, std::vector<record::OutletRecord>& outlets,
          capture::Capture& capture) {
  return Player(plan, slots, signal, station, options, outlets, capture).play();
}

}  // namespace gsbench::station
