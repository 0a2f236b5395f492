// The outlet application: takes samples and messages, produces messages and the relay's state.
// All boards and the bench's simulated outlets run it; a board adds only its ADC, pins and link.
// No call blocks; all calls come from one thread.
#pragma once

#include <cstddef>
#include <cstdint>

#include <outlet/outlet.hpp>
#include <wire/messages.hpp>

namespace gs::app {

constexpr std::uint32_t kFirmwareVersion = 1000;  // 0.1.0 as major·10⁶ + minor·10³ + patch

// A hello in which the board sets id, board, instance, build and capabilities. The application
// fills in the other fields.
struct Identity : wire::Hello {
  // Of every message: another one for each start-up, from a source of random numbers or a count.
  std::uint32_t start_number = 0;
};

// Copies zero-terminated text into a field of Identity; text that is too long is truncated.
template <std::size_t N>
void set_text(char (&field)[N], const char* text) {
  std::size_t i = 0;
  for (; i < N - 1 && text[i] != '\0'; ++i) {
    field[i] = text[i];
  }
  for (; i < N; ++i) {
    field[i] = '\0';
  }
}

// Receives the application's messages, from within calls of Application.
class Outbox {
 public:
  virtual void put(const wire::Uplink& message) = 0;

 protected:
  ~Outbox() = default;
};

// Non-volatile storage of the settings.
class SettingsStorage {
 public:
  // Returns false if the settings could not be stored. The settings stored before then remain.
  virtual bool keep(const outlet::Settings& settings) = 0;
  virtual bool usable() const = 0;

 protected:
  ~SettingsStorage() = default;
};

class Application {
 public:
  // Starts the application and sends the first hello. Returns false if the hardware is not
  // supported; the application then does nothing, as before its first start. `storage` may be null;
  // otherwise it must outlive the application. `kept` is the stored settings, which are applied
  // before the hello is sent. If they are refused, an error message follows the hello.
  bool start(const outlet::Hardware& hardware, const Identity& identity, SettingsStorage* storage,
             Outbox& outbox, const outlet::Settings* kept = nullptr);
  // Applies stored settings before the first sample. Returns false if they are refused.
  bool restore(const outlet::Settings& settings);

  void feed(const std::int16_t* samples, std::size_t count, Outbox& outbox);
  // Obeys and answers a message. The endpoint passes each message once.
  void receive(const wire::Downlink& message, Outbox& outbox);
  // Answers a command with the relay's state, without obeying it.
  void answer_command(const wire::Downlink& command, Outbox& outbox) const;

  // Counts an error of the board or the link, and sends an error message.
  void note(wire::ErrorCode error, Outbox& outbox);
  void note_unsent(std::uint32_t count = 1) { counts_.messages_unsent += count; }
  // Counts a received message that has no effect.
  void note_dropped() { ++counts_.messages_dropped; }
  // The same, and sends an error message with this detail.
  void refuse(wire::ErrorCode error, std::uint32_t detail, Outbox& outbox);
  // Notes samples that the ADC delivered but the firmware did not take. Time stamps include them.
  void note_samples_lost(std::uint32_t count, Outbox& outbox);

  bool relay_closed() const { return state_.relay.closed; }
  std::uint64_t samples_taken() const { return counts_.samples; }
  std::uint32_t start_number() const { return identity_.start_number; }

 private:
  void send_hello(Outbox& outbox, std::uint32_t session = wire::kNoSession) const;
  void take_settings(const wire::Downlink& sent, Outbox& outbox);
  void take_command(const wire::Downlink& command, Outbox& outbox);
  void run_self_test(Outbox& outbox) const;
  void send_status(Outbox& outbox) const;
  void send_report(const outlet::Report& report, Outbox& outbox) const;
  void send_relay(Outbox& outbox) const;
  wire::Uplink message(wire::UplinkKind kind) const;
  template <class Content>
  void put(Outbox& outbox, wire::UplinkKind kind, Content wire::Uplink::*part,
           const Content& content) const;

  Identity identity_;
  SettingsStorage* storage_ = nullptr;
  outlet::Config config_;
  outlet::State state_;
  struct Counts {
    std::uint64_t samples = 0;
    std::uint32_t samples_lost = 0;
    std::uint32_t messages_bad = 0;
    std::uint32_t messages_unsent = 0;
    std::uint32_t messages_dropped = 0;
    std::uint32_t errors[static_cast<std::size_t>(wire::kLastErrorCode) + 1] = {};
  };
  Counts counts_;  // since start-up
  bool started_ = false;
  bool kept_ = false;  // the settings accepted last are stored
};

}  // namespace gs::app
