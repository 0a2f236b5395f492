// When the relay opens and closes: after the time delay, by command at once, and again by itself
// when the frequency has recovered (restoration).
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
  // Restoration: time above restore_hz, and the time that is due.
  float above_s = 0.0f;
  float restore_after_s = 0.0f;
};

// An outlet's own decision to switch off. Without a time delay the relay opens now; returns true if
// it does. `frequency_hz`: the newest measurement, whose noise is the random part of the
// restoration.
bool open(const Settings& settings, RelayState& relay, Cause cause, float frequency_hz);

// Criterion (3). Replaces what the outlet itself had decided. Returns true if the relay changes.
bool command(RelayState& relay, bool close);

enum class RelayChange : std::uint8_t { kNone, kOpened, kRestored };

// One report of 16 ms. `frequency_hz`: NaN if it was not measured.
RelayChange run(const Settings& settings, RelayState& relay, float frequency_hz);

}  // namespace gs::outlet
