// The outlet on a board: each turn takes the bytes that came, a millisecond of samples at most, and
// sets the relay. The same for every board, and for the tests on the host.
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
  bool watchdog_barked = false;
};

class Loop {
 public:
  Loop(Board& board, settings_storage::FlashSettingsStorage& area);

  // Says hello with the settings that were kept in force. False where the hardware is none that can
  // be served; the loop then only turns.
  bool start(const StartUp& start_up);

  // Says hello again, to whom it may have escaped.
  void introduce() { app_.receive(wire::identify(), endpoint_); }

  // False where there was nothing to do: the board may sleep until an interrupt.
  bool turn();

 private:
  bool take_bytes();
  bool take_samples();

  Board& board_;
  settings_storage::FlashSettingsStorage& area_;
  app::Application app_;
  app::SerialEndpoint endpoint_;
  std::int16_t chunk_[outlet::kMaxSampleRate_hz / 1000] = {};
  std::uint16_t samples_per_ms_ = 1;
  std::uint16_t samples_in_ms_ = 0;
};

}  // namespace gs::superloop
