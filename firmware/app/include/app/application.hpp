// An outlet as the rest of the world meets it: samples and messages in, messages and a relay out.
// Every board and the bench's simulated outlets run this; a board adds only its ADC, pins and link.
#pragma once

#include <cstddef>
#include <cstdint>

#include <outlet/outlet.hpp>
#include <wire/messages.hpp>

namespace gs::app {

constexpr std::uint32_t kFirmwareVersion = 1000;  // 0.1.0 as major·10⁶ + minor·10³ + patch

// Which outlet this is, as its hello says it: id, board, instance, build and capabilities. The rest
// of the hello the app fills in.
using Identity = wire::Hello;

// Copies zero-terminated text into one of the above, cut where it is too long.
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

// Where the app's messages go. Called from within the app's own calls.
class Outbox {
 public:
  virtual void put(const wire::Uplink& message) = 0;

 protected:
  ~Outbox() = default;
};

// Where settings outlast a loss of power.
class SettingsStorage {
 public:
  // False where they could not be kept; what had been kept before is then still there.
  virtual bool keep(const outlet::Settings& settings) = 0;
  virtual bool usable() const = 0;

 protected:
  ~SettingsStorage() = default;
};

class Application {
 public:
  // False where the hardware is none that can be served; the app then does nothing, as before its
  // first start. `area` may be null; it must outlive the app. With `kept`, settings from there,
  // the first hello tells them in force already; where they are refused, it is told as an error.
  bool start(const outlet::Hardware& hardware, const Identity& identity, SettingsStorage* area,
             Outbox& outbox, const outlet::Settings* kept = nullptr);
  // Settings that were kept, before the first sample. False where they are refused.
  bool restore(const outlet::Settings& settings);

  void feed(const std::int16_t* samples, std::size_t count, Outbox& outbox);
  void receive(const wire::Downlink& message, Outbox& outbox);

  // Something went wrong on the board or the link; counted, and told.
  void note(wire::ErrorCode error, Outbox& outbox);
  void note_unsent() { ++counts_.messages_unsent; }
  // Samples that the ADC had and the firmware did not take: time goes on without them.
  void note_samples_lost(std::uint32_t count, Outbox& outbox);

  bool relay_closed() const { return state_.relay_closed; }
  std::uint64_t samples_taken() const { return counts_.samples; }

 private:
  void introduce(Outbox& outbox) const;
  void take_settings(const wire::Downlink& sent, Outbox& outbox);
  void take_command(const wire::Downlink& command, Outbox& outbox);
  void test_itself(Outbox& outbox) const;
  void report_status(Outbox& outbox) const;
  void tell(const outlet::Report& report, Outbox& outbox) const;
  void report_relay(Outbox& outbox) const;
  wire::Uplink message(wire::UplinkKind kind) const;
  template <class Content>
  void put(Outbox& outbox, wire::UplinkKind kind, Content wire::Uplink::*part,
           const Content& content) const;

  Identity identity_;
  SettingsStorage* area_ = nullptr;
  outlet::Config config_;
  outlet::State state_;
  struct Counts {
    std::uint64_t samples = 0;
    std::uint32_t samples_lost = 0;
    std::uint32_t messages_bad = 0;
    std::uint32_t messages_unsent = 0;
    std::uint32_t errors[static_cast<std::size_t>(wire::kLastErrorCode) + 1] = {};
  };
  Counts counts_;  // since start-up
  bool started_ = false;
};

}  // namespace gs::app
