// An outlet as the rest of the world meets it: samples and messages in, messages and a relay out.
// Every board and the bench's simulated outlets run this; a board adds only its ADC, pins and link.
#pragma once

#include <cstddef>
#include <cstdint>

#include <outlet/outlet.hpp>
#include <wire/messages.hpp>

namespace gs::node {

constexpr std::uint32_t kFirmwareVersion = 1000;  // 0.1.0 as major·10⁶ + minor·10³ + patch

// Where the node's messages go. Called from within feed() and receive().
class Outbox {
 public:
  virtual void put(const wire::Uplink& message) = 0;

 protected:
  ~Outbox() = default;
};

class Node {
 public:
  // False where the hardware is none that can be served; the node then does nothing, as before its
  // first start.
  bool start(const outlet::Hardware& hardware, Outbox& outbox);

  void feed(const std::int16_t* samples, std::size_t count, Outbox& outbox);
  void receive(const wire::Downlink& message, Outbox& outbox);

  bool relay_closed() const { return state_.relay_closed; }
  std::uint64_t samples_taken() const { return samples_; }

 private:
  void take_settings(const outlet::Settings& settings, Outbox& outbox);
  void tell(const outlet::Report& report, Outbox& outbox) const;
  wire::Uplink message(wire::UplinkKind kind) const;
  wire::Uplink relay_message() const;

  outlet::Config config_;
  outlet::State state_;
  std::uint64_t samples_ = 0;
  bool started_ = false;
};

}  // namespace gs::node
