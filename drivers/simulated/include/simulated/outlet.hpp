// One simulated outlet: the firmware with a model of its ADC and of its relay.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include <app/application.hpp>
#include <models/adc.hpp>
#include <models/noise.hpp>
#include <models/relay_model.hpp>

namespace gsbench::simulated {

struct OutletParameters {
  models::RelayParameters relay;
  double downlink_ms = 5.0;  // delay from send() to the outlet
};

class Outlet {
 public:
  Outlet(const OutletParameters& parameters, const std::string& id, std::uint32_t index);

  // Resets all state and powers up. False if the firmware refuses sample rate or nominal frequency.
  bool start(std::int64_t sample_rate_hz, int nominal_hz, float noise_rms_pu, std::uint64_t seed);

  // Feeds samples first_tick … first_tick + count − 1 to the outlet's terminals.
  void feed(std::int64_t first_tick, const float* voltage_pu, std::size_t count);
  void send(std::int64_t tick, const gs::wire::Downlink& message);

  // Appends what happened since the last call.
  void take_messages(std::vector<gs::wire::Uplink>& messages);
  void take_edges(std::vector<models::ContactEdge>& edges, std::int64_t up_to_tick);

  bool relay_closed() const { return app_.relay_closed(); }

 private:
  struct Pending {
    std::int64_t tick;
    gs::wire::Downlink message;
  };
  class Collector final : public gs::app::Outbox {
   public:
    void put(const gs::wire::Uplink& message) override { messages.push_back(message); }
    std::vector<gs::wire::Uplink> messages;
  };

  void feed_undisturbed(std::int64_t first_tick, const float* voltage_pu, std::size_t count);
  void follow_relay();
  void turn_coil(std::int64_t coil_tick, bool closes);

  OutletParameters parameters_;
  gs::app::Identity identity_;
  std::uint32_t index_;
  std::int64_t sample_rate_hz_ = 0;
  float noise_rms_pu_ = 0.0F;
  std::uint64_t seed_ = 0;
  gs::app::Application app_;
  Collector collector_;
  std::size_t relay_changes_read_ = 0;  // messages of the collector already seen by follow_relay
  std::deque<Pending> pending_;
  std::vector<models::ContactEdge> edges_;
  std::uint64_t coil_changes_ = 0;
  std::int64_t contact_moves_tick_ = 0;  // first contact edge of the newest coil change
  std::vector<float> volts_;
  std::vector<std::int16_t> samples_;
};

}  // namespace gsbench::simulated
