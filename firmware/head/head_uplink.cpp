// Messages to the bench: which one is due, and what is in it.
#include <algorithm>

#include <head/head.hpp>

namespace gs::head {

std::size_t Head::next_message(std::uint64_t now, std::uint8_t* out, std::size_t capacity) {
  if (capacity < kLongestUplink) {
    return 0;
  }
  if (hello_is_wanted_) {
    hello_is_wanted_ = false;
    return send(hello(), out, capacity);
  }
  if (waiting_refusals_ > 0) {
    return send_refusal(out, capacity);
  }
  Edge edge;
  if (edges_.take(edge)) {
    edge.count -= static_cast<std::int64_t>(player_.begin_count());
    return send(edge, out, capacity);
  }
  if (status_is_due()) {
    // Before the state is read, so that a later change is not overlooked.
    changes_at_status_ = player_.changes();
    codes_at_status_ = player_.codes();
    status_is_wanted_ = false;
    gap_is_reported_ = false;
    return send(status(now), out, capacity);
  }
  return 0;
}

std::size_t Head::send_refusal(std::uint8_t* out, std::size_t capacity) {
  const Refused first = refusals_[0];
  --waiting_refusals_;
  std::copy(refusals_ + 1, refusals_ + 1 + waiting_refusals_, refusals_);
  return send(first, out, capacity);
}

template <class Message>
std::size_t Head::send(const Message& message, std::uint8_t* out, std::size_t capacity) {
  return encode(message, number_++, out, capacity);
}

bool Head::status_is_due() const {
  if (status_is_wanted_ || player_.changes() != changes_at_status_) {
    return true;
  }
  const bool active = state() == State::kArmed || state() == State::kPlaying;
  return active && player_.codes() - codes_at_status_ >= kCodeRate_hz / 1000 * kStatusPeriod_ms;
}

Hello Head::hello() const {
  Hello hello;
  hello.flags = hardware_.flags;
  std::copy(hardware_.board, hardware_.board + sizeof hello.board, hello.board);
  std::copy(hardware_.unique_id, hardware_.unique_id + kUniqueIdBytes, hello.unique_id);
  hello.firmware_version = kFirmwareVersion;
  hello.build = hardware_.build;
  hello.full_scale_mv = hardware_.full_scale_mv;
  hello.counts_per_sample = hardware_.counts_per_sample;
  return hello;
}

Status Head::status(std::uint64_t now) const {
  Status status;
  status.state = state();
  status.fault = status.state == State::kFaulted ? player_.fault() : Fault::kNone;
  status.run = run_;
  status.expected = expected_;
  status.position = player_.position();
  status.room = static_cast<std::uint16_t>(player_.room());
  status.count = player_.has_begun() ? static_cast<std::int64_t>(now - player_.begin_count())
                                     : std::int64_t{0};
  status.echo = echo_;
  status.edges = edges_.happened();
  status.closed = edges_.closed();
  status.underruns = player_.underruns();
  status.watchdog_trips = player_.watchdog_trips();
  status.bad_frames = bad_frames_;
  status.edges_missed = edges_.missed();
  return status;
}

}  // namespace gs::head
