// When the relay opens and closes. It opens after the time delay of the settings, or at once by a
// command. If the outlet itself opened it, it closes again when the frequency has recovered
// (restoration).
#pragma once

#include <cstdint>

#include <outlet/settings.hpp>

namespace gs::outlet {

// Reason of the relay's last change: none, or one of the three criteria of §5.5.
enum class Cause : std::uint8_t { kNone = 0, kLoss = 1, kFrequency = 2, kCommand = 3 };

const char* to_string(Cause cause);

struct RelayState {
  bool closed = true;
  Cause cause = Cause::kNone;
  // A decision to open that waits for the time delay.
  bool opening = false;
  Cause opening_cause = Cause::kNone;
  float opens_in_s = 0.0f;
  // Restoration: time for which f has been at least restore_hz, and the time after which the relay
  // closes.
  bool restores = true;  // false after a command to open
  float above_s = 0.0f;
  float restore_after_s = 0.0f;
};

// The outlet's own decision to switch off. No effect if the relay is open or about to open. Returns
// true if the relay opens now, which it does without a time delay. `frequency_hz`: the newest
// measurement; the random part of the restoration is derived from its noise.
bool open(const Settings& settings, RelayState& relay, Cause cause, float frequency_hz);

// Criterion (3). Takes effect at once and cancels an opening that waits for the time delay. Returns
// true if the relay changes. After a command to open the relay is not restored, also if it was open
// before; then it keeps its cause.
bool command(RelayState& relay, bool close);

enum class RelayChange : std::uint8_t { kNone, kOpened, kRestored };

// Advances the time delay and the restoration by one report of 16 ms. `frequency_hz`: NaN if it was
// not measured, which restarts the dwell time of the restoration.
RelayChange run(const Settings& settings, RelayState& relay, float frequency_hz);

}  // namespace gs::outlet
