// The main loop of a board without an operating system. Each turn takes received bytes (at most
// one frame), then samples (at most 1 ms), then sets the relay. All boards and the tests on the
// host share this loop.
#pragma once

#include <settings_storage/settings_storage.hpp>

#include <cstddef>
#include <cstdint>

#include <app/application.hpp>
#include <superloop/board.hpp>

namespace gs::superloop {

struct StartUp {
  outlet::Hardware hardware;
  app::Identity identity;
  bool reset_by_watchdog = false;
};

class Loop {
 public:
  Loop(Board& board, settings_storage::FlashSettingsStorage& storage);

  // Applies the stored settings and sends the hello. The storage is not used without the capability
  // to keep settings. Returns false if the hardware is not
  // supported; the application then does nothing.
  bool start(const StartUp& start_up);

  // Sends the hello again, after a reconnection.
  void send_hello() { app_.receive(wire::identify(), endpoint_); }

  // Counts messages that were lost after the board had accepted them.
  void note_unsent(std::uint32_t count) { app_.note_unsent(count); }

  // Returns false if there was nothing to do: the board may sleep until an interrupt.
  bool turn();

 private:
  bool take_bytes();
  bool take_samples();

  Board& board_;
  settings_storage::FlashSettingsStorage& storage_;
  app::Application app_;
  app::SerialEndpoint endpoint_;
  std::int16_t chunk_[outlet::kMaxSampleRate_hz / 1000] = {};
  std::uint16_t samples_per_ms_ = 1;
  std::uint16_t samples_in_ms_ = 0;
};

}  // namespace gs::superloop
