#include <outlet/crc32.hpp>
#include <outlet/name_table.hpp>
#include <outlet/relay_control.hpp>

namespace gs::outlet {
namespace {

// Random number in [0, 1) from the noise of a measurement. It differs between outlets, and is the
// same in a replay.
float random_part(float frequency_hz) {
  Crc32 crc;
  crc.add_word(frequency_hz);
  return static_cast<float>(crc.value() >> 8) * (1.0f / 16777216.0f);
}

void open_now(RelayState& relay) {
  relay.opening = false;
  relay.closed = false;
  relay.cause = relay.opening_cause;
  relay.restores = true;
  relay.above_s = 0.0f;
}

}  // namespace

const char* to_string(Cause cause) {
  static constexpr const char* kNames[] = {"none", "loss", "frequency", "command"};
  return name_of<Cause::kCommand>(cause, kNames);
}

bool open(const Settings& settings, RelayState& relay, Cause cause, float frequency_hz) {
  if (!relay.closed || relay.opening) {
    return false;
  }
  relay.opening = true;
  relay.opening_cause = cause;
  relay.opens_in_s = settings.delay_s;
  relay.restore_after_s =
      settings.restore_dwell_s + random_part(frequency_hz) * settings.restore_spread_s;
  if (relay.opens_in_s > 0.0f) {
    return false;
  }
  open_now(relay);
  return true;
}

bool command(RelayState& relay, bool close) {
  const bool changes = relay.closed != close;
  relay.opening = false;
  relay.closed = close;
  relay.restores = close;
  if (changes) {
    relay.cause = close ? Cause::kNone : Cause::kCommand;
  }
  return changes;
}

RelayChange run(const Settings& settings, RelayState& relay, float frequency_hz) {
  if (relay.opening) {
    relay.opens_in_s -= kReport_s;
    if (relay.opens_in_s > 0.0f) {
      return RelayChange::kNone;
    }
    open_now(relay);
    return RelayChange::kOpened;
  }
  const bool may_restore = !relay.closed && relay.restores && settings.restore_hz > 0.0f;
  if (!may_restore || !(frequency_hz >= settings.restore_hz)) {
    relay.above_s = 0.0f;
    return RelayChange::kNone;
  }
  relay.above_s += kReport_s;
  if (relay.above_s < relay.restore_after_s) {
    return RelayChange::kNone;
  }
  relay.closed = true;
  relay.cause = Cause::kNone;
  return RelayChange::kRestored;
}

}  // namespace gs::outlet
