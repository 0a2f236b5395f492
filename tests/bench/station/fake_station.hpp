// A station whose source, link and relay sense fail as scripted and log the calls. Its outlets
// answer and report like real ones, without firmware.
#pragma once

#include <atomic>
#include <chrono>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <station/station.hpp>

namespace gsbench::station::test {

constexpr std::int64_t kNeverTick = std::numeric_limits<std::int64_t>::max();

struct Script {
  std::size_t outlets = 2;
  std::size_t relay_channels = 2;
  bool noise_per_outlet = false;
  double block_s = 0.1;
  source::Kind kind = source::Kind::kStreamed;
  source::Played played = {};
  std::string accuracy = {};
  std::vector<std::string> ports = {};
  bool counts_ticks = true;
  std::chrono::milliseconds answers_within{0};
  double sense_uncertainty_ticks = 0.0;        // before the run
  double sense_uncertainty_grows_ticks = 0.0;  // by the first poll
  std::string sense_not_known_yet;
  double sense_count_at_tick_0 = 0.0;
  double sense_uncertainty_between_ticks = 0.0;
  std::optional<std::int64_t> sense_count_now;  // of this machine's clock, at any time
  std::optional<source::HostClock> host_clock;  // of the source

  // Failures. Calls are counted from 0.
  std::string start_error;  // of the source; it is live nevertheless
  std::optional<int> hold_fails_at;
  // Sets the flag within this call of the source, which heeds it: "upload", "power_up", …
  std::string stops_in;
  std::atomic<bool>* stop = nullptr;
  std::string make_safe_error;
  std::string open_error;        // of the link
  std::size_t unreachable = 0;   // the last so many outlets: their ports cannot be opened
  std::string sense_open_error;  // of the relay sense
  std::optional<int> play_fails_at;
  std::optional<int> play_throws_at;  // drivers must not throw
  std::optional<int> send_fails_at;
  std::optional<int> link_poll_fails_at;
  std::optional<int> relay_poll_fails_at;

  // Behaviour of the last outlet.
  bool without_link = false;
  bool joins = true;
  std::string requires_serial_number;  // of its slot, which has a port; empty: none
  std::vector<relay::Edge> edges;      // returned by the first poll of the relay sense
  std::uint16_t protocol_version = gs::wire::kProtocolVersion;
  gs::outlet::SettingsError settings_error = gs::outlet::SettingsError::kNone;
  bool answers_settings = true;
  gs::outlet::SettingsError later_settings_error = gs::outlet::SettingsError::kNone;
  bool answers_later_settings = true;  // those that are sent during the run
  std::int64_t silent_from_tick = kNeverTick;
};

// A script with one field set.
template <class Field, class Value>
Script with(Field Script::*field, const Value& value) {
  Script script;
  script.*field = value;
  return script;
}

class FakeStation final : public Station, private source::Source, private link::Link {
 public:
  explicit FakeStation(Script script) : script_(std::move(script)) {}

  std::string name() const override { return "fake"; }
  source::Source& source() override { return *this; }
  link::Link& link() override { return *this; }
  relay::RelaySense& relay_sense() override { return sense_; }
  std::vector<Slot> slots() const override;
  bool outlets_count_ticks() const override { return script_.counts_ticks; }
  std::chrono::milliseconds answers_within() const override { return script_.answers_within; }
  std::string source_accuracy() const override { return script_.accuracy; }
  std::vector<std::string> ports() const override { return script_.ports; }
  double block_s() const override { return script_.block_s; }

  // True if the source is off and the link is closed, each as its last call.
  bool is_safe() const { return made_safe_ > 0 && closed_ > 0 && !source_on_ && !link_open_; }
  bool was_touched() const { return touched_; }
  bool was_energised() const { return energised_; }
  bool was_open_when_energised() const { return open_when_energised_; }
  int holds() const { return holds_; }
  int blocks_played() const { return plays_; }
  std::int64_t tick() const { return played_tick_; }
  const std::vector<gs::wire::Downlink>& sent_to(std::size_t outlet) const {
    return sent_.at(outlet);
  }

 private:
  source::Limits limits() const override;
  std::optional<source::HostClock> host_clock() const override { return script_.host_clock; }
  drivers::Result<source::Played> deviation(const source::Stimulus&) const override {
    return script_.played;
  }
  drivers::Status upload(const source::Progress&) override { return heed("upload"); }
  drivers::Status keep_up() override;
  drivers::Status power_up() override;
  drivers::Status begin() override { return heed("begin"); }
  drivers::Result<std::int64_t> play_until(std::int64_t until_tick) override;
  drivers::Status end() override { return heed("end"); }
  drivers::Status switch_off() noexcept override;
  drivers::Status heed(const std::string& call);

  drivers::Status open() override;
  drivers::Status send(const std::string& id, const gs::wire::Downlink& message) override;
  drivers::Status poll(link::Happenings& happenings) override;
  std::vector<link::Fault> missing() override { return unreachable(); }
  std::vector<link::Fault> unreachable() override;
  void close() noexcept override;

  class Sense final : public relay::RelaySense {
   public:
    explicit Sense(const Script& script) : script_(script) {}
    drivers::Status open() override;
    relay::Alignment alignment() const override;
    std::string not_known_yet() const override { return script_.sense_not_known_yet; }
    std::optional<std::int64_t> count_at(std::chrono::steady_clock::time_point) const override {
      return script_.sense_count_now;
    }
    drivers::Status poll(std::vector<relay::Edge>& edges) override;

   private:
    const Script& script_;
    int polls_ = 0;
  };

  bool is_last(std::size_t outlet) const { return outlet + 1 == script_.outlets; }
  bool is_linked(std::size_t outlet) const { return !(is_last(outlet) && script_.without_link); }
  bool is_reachable(std::size_t outlet) const {
    return outlet + script_.unreachable < script_.outlets;
  }
  void join(std::vector<link::Change>& changes) const;
  // To the settings with this number, from 0.
  void answer_settings(std::size_t outlet, std::size_t number,
                       std::vector<link::Received>& messages) const;

  Script script_;
  Sense sense_{script_};
  bool touched_ = false;
  bool energised_ = false;
  bool open_when_energised_ = false;
  int holds_ = 0;
  bool source_on_ = false;
  bool link_open_ = false;
  bool joined_ = false;
  int made_safe_ = 0;
  int closed_ = 0;
  int plays_ = 0;
  int sends_ = 0;
  int link_polls_ = 0;
  std::int64_t played_tick_ = 0;
  std::int64_t reported_tick_ = 0;
  std::vector<std::vector<gs::wire::Downlink>> sent_{script_.outlets};
  std::vector<std::size_t> answered_ = std::vector<std::size_t>(script_.outlets);  // settings
};

}  // namespace gsbench::station::test
