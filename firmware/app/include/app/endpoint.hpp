// The outlet's end of a link. It encodes and numbers the messages to send. It decodes received
// messages, drops late messages, duplicates and those of unknown sessions, and reports what it
// cannot take (wire/README.md, "What an outlet does with a message"). There is one class for a
// serial line and one for a broker.
#pragma once

#include <cstddef>
#include <cstdint>

#include <app/application.hpp>
#include <app/sessions.hpp>
#include <wire/frame.hpp>

namespace gs::app {

// Sends bytes without blocking. send() returns false if the carrier cannot take the bytes now. The
// message is then lost, and the application counts it.
class Carrier {
 public:
  virtual bool send(const std::uint8_t* bytes, std::size_t count) = 0;

 protected:
  ~Carrier() = default;
};

// For links that carry whole messages, such as MQTT.
class MessageEndpoint final : public Outbox {
 public:
  MessageEndpoint(Application& app, Carrier& carrier) : app_(app), carrier_(carrier) {}

  void put(const wire::Uplink& message) override;
  void receive(const std::uint8_t* message, std::size_t size);

 private:
  void take_command(const wire::Downlink& command, Session& session);

  Application& app_;
  Carrier& carrier_;
  Sessions sessions_;
  std::uint32_t hellos_sent_ = 0;
  std::uint32_t others_sent_ = 0;
  std::uint8_t bytes_[wire::kLongestMessage] = {};
};

// For links that carry a stream of bytes: messages travel in frames.
class SerialEndpoint final : public Outbox {
 public:
  SerialEndpoint(Application& app, Carrier& carrier)
      : app_(app), framer_(carrier), whole_(app, framer_) {}

  void put(const wire::Uplink& message) override { whole_.put(message); }
  void receive(const std::uint8_t* bytes, std::size_t count);

 private:
  class Framer final : public Carrier {
   public:
    explicit Framer(Carrier& carrier) : carrier_(carrier) {}
    bool send(const std::uint8_t* bytes, std::size_t count) override;

   private:
    Carrier& carrier_;
    std::uint8_t bytes_[wire::kLongestFrame] = {};
  };

  Application& app_;
  Framer framer_;
  MessageEndpoint whole_;
  wire::FrameReader reader_;
};

}  // namespace gs::app
