// The outlet on a board: each turn takes the bytes that came, a millisecond of samples at most, and
// sets the relay. The same for every board, and for the tests on the host.
#pragma once

#include <bare_metal/board.hpp>
#include <settings_area/settings_area.hpp>

#include <cstddef>
#include <cstdint>

#include <node/node.hpp>

namespace gs::bare_metal {

struct StartUp {
  outlet::Hardware hardware;
  node::Identity identity;
  bool watchdog_barked = false;
};

class Loop {
 public:
  Loop(Board& board, settings_area::FlashSettingsArea& area);

  // Says hello with the settings that were kept in force. False where the hardware is none that can
  // be served; the loop then only turns.
  bool start(const StartUp& start_up);

  // Says hello again, to whom it may have escaped.
  void introduce() { node_.receive(wire::identify(), endpoint_); }

  // False where there was nothing to do: the board may sleep until an interrupt.
  bool turn();

 private:
  bool take_bytes();
  bool take_samples();

  Board& board_;
  settings_area::FlashSettingsArea& area_;
  node::Node node_;
  node::SerialEndpoint endpoint_;
  std::int16_t chunk_[outlet::kMaxSampleRateHz / 1000] = {};
  std::uint16_t samples_per_ms_ = 1;
  std::uint16_t samples_in_ms_ = 0;
};

}  // namespace gs::bare_metal
