#include <superloop/loop.hpp>

namespace gs::superloop {

Loop::Loop(Board& board, settings_storage::FlashSettingsStorage& storage)
    : board_(board), storage_(storage), endpoint_(app_, board) {}

bool Loop::start(const StartUp& start_up) {
  outlet::Settings kept;
  const bool keeps = (start_up.identity.capabilities & wire::kKeepsSettings) != 0;
  const bool has_kept = keeps && storage_.load(kept);
  if (!app_.start(start_up.hardware, start_up.identity, keeps ? &storage_ : nullptr, endpoint_,
                  has_kept ? &kept : nullptr)) {
    return false;
  }
  samples_per_ms_ = static_cast<std::uint16_t>(start_up.hardware.sample_rate_hz / 1000);
  board_.drive_relay(app_.relay_closed());
  if (!start_up.hardware.has_crystal) {
    app_.note(wire::ErrorCode::kClock, endpoint_);
  }
  if (start_up.reset_by_watchdog) {
    app_.note(wire::ErrorCode::kWatchdog, endpoint_);
  }
  return true;
}

bool Loop::turn() {
  const bool had_bytes = take_bytes();
  const bool had_samples = take_samples();
  if (had_bytes || had_samples) {
    board_.drive_relay(app_.relay_closed());
  }
  // Without samples the outlet measures nothing: the watchdog must then restart it.
  if (had_samples || board_.adc_idle()) {
    board_.feed_watchdog();
  }
  return had_bytes || had_samples;
}

bool Loop::take_bytes() {
  // At most one frame per turn, so that a flood of bytes cannot delay the samples.
  std::uint8_t byte = 0;
  std::size_t taken = 0;
  for (; taken < wire::kLongestFrame && board_.take_byte(byte); ++taken) {
    endpoint_.receive(&byte, 1);
  }
  return taken > 0;
}

bool Loop::take_samples() {
  // Not beyond the end of the millisecond: reports end there, and the relay changes with a report.
  std::uint32_t lost = 0;
  const std::size_t count =
      board_.take_samples(chunk_, static_cast<std::size_t>(samples_per_ms_ - samples_in_ms_), lost);
  if (lost > 0) {
    app_.note_samples_lost(lost, endpoint_);
  }
  app_.feed(chunk_, count, endpoint_);
  samples_in_ms_ = static_cast<std::uint16_t>((samples_in_ms_ + count) % samples_per_ms_);
  return count > 0 || lost > 0;
}

}  // namespace gs::superloop
