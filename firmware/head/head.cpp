#include <algorithm>

#include <head/head.hpp>

namespace gs::head {

void Head::take(const std::uint8_t* message, std::size_t size) {
  Header header;
  if (!decode_header(message, size, header)) {
    refuse(Refusal::kMalformed, 0);
    return;
  }
  switch (header.kind) {
    case Kind::kIdentify:
      return take_identify(message, size, header.number);
    case Kind::kStop:
      return take_stop(message, size, header.number);
    case Kind::kPing:
      return take_ping(message, size, header.number);
    case Kind::kArm:
    case Kind::kSamples:
    case Kind::kPlay:
    case Kind::kResendEdges:
      return take_in_order(message, size, header);
    case Kind::kHello:
    case Kind::kStatus:
    case Kind::kEdge:
    case Kind::kRefused:
      break;
  }
  refuse(Refusal::kUnknownKind, header.number);
}

void Head::take_identify(const std::uint8_t* message, std::size_t size, std::uint32_t number) {
  Identify identify;
  if (!decode(message, size, identify)) {
    return refuse(Refusal::kMalformed, number);
  }
  player_.switch_off();
  player_.forget();
  edges_.clear();
  session_ =
      identify.protocol_version == kProtocolVersion ? Session::kOpen : Session::kOtherVersion;
  received_ = 0;
  run_ = 0;
  echo_ = 0;
  waiting_refusals_ = 0;
  accept(number);
  hello_is_wanted_ = true;
}

void Head::take_stop(const std::uint8_t* message, std::size_t size, std::uint32_t number) {
  Stop stop;
  if (!decode(message, size, stop)) {
    return refuse(Refusal::kMalformed, number);
  }
  player_.switch_off();
  accept(number);
  status_is_wanted_ = true;
}

void Head::take_ping(const std::uint8_t* message, std::size_t size, std::uint32_t number) {
  Ping ping;
  if (!decode(message, size, ping)) {
    return refuse(Refusal::kMalformed, number);
  }
  player_.feed();
  echo_ = ping.token;
  status_is_wanted_ = true;
  if (session_ == Session::kOpen && ahead(number) > 0) {
    report_gap(number);
  }
}

void Head::take_in_order(const std::uint8_t* message, std::size_t size, const Header& header) {
  const std::uint32_t number = header.number;
  if (session_ != Session::kOpen) {
    return refuse(session_ == Session::kNone ? Refusal::kNotIdentified : Refusal::kVersion, number);
  }
  if (ahead(number) > 0) {
    return report_gap(number);
  }
  if (ahead(number) < 0) {
    status_is_wanted_ = true;
    return;
  }
  if (header.kind == Kind::kSamples) {
    return take_as(samples_, message, size, number);
  }
  status_is_wanted_ = true;
  if (header.kind == Kind::kArm) {
    Arm arm;
    return take_as(arm, message, size, number);
  }
  if (header.kind == Kind::kPlay) {
    Play play;
    return take_as(play, message, size, number);
  }
  ResendEdges resend;
  take_as(resend, message, size, number);
}

template <class Message>
void Head::take_as(Message& into, const std::uint8_t* message, std::size_t size,
                   std::uint32_t number) {
  if (!decode(message, size, into)) {
    return refuse(Refusal::kMalformed, number);
  }
  const Refusal reason = apply(into);
  if (reason != kAccepted) {
    return refuse(reason, number);
  }
  accept(number);
}

Refusal Head::apply(const Arm& arm) {
  if (state() != State::kOff) {
    return Refusal::kState;
  }
  player_.forget();  // first, so that no edge is kept any more
  edges_.clear();
  player_.arm();
  received_ = 0;
  run_ = arm.run;
  return kAccepted;
}

Refusal Head::apply(const Samples& samples) {
  if (state() != State::kArmed && state() != State::kPlaying) {
    return Refusal::kState;
  }
  if (samples.first_sample != received_) {
    return Refusal::kPosition;
  }
  if (samples.count > player_.room()) {
    return Refusal::kNoRoom;
  }
  const bool in_range = std::all_of(
      samples.samples, samples.samples + samples.count,
      [](std::int16_t sample) { return sample >= -kFullScale && sample <= kFullScale; });
  if (!in_range) {
    return Refusal::kRange;
  }
  player_.put(samples.samples, samples.count);
  received_ += samples.count;
  return kAccepted;
}

Refusal Head::apply(const Play& play) {
  if (state() != State::kArmed) {
    return Refusal::kState;
  }
  if (play.prefill < 1 || play.prefill > kBufferSamples) {
    return Refusal::kRange;
  }
  player_.play(play.prefill);
  return kAccepted;
}

Refusal Head::apply(const ResendEdges& resend) {
  return edges_.resend(resend.first_edge) ? kAccepted : Refusal::kNotKept;
}

void Head::accept(std::uint32_t number) {
  expected_ = number + 1;
  gap_is_reported_ = false;
  player_.feed();
}

void Head::refuse(Refusal reason, std::uint32_t number) {
  if (waiting_refusals_ < kWaitingRefusals) {
    refusals_[waiting_refusals_++] = {reason, number, expected_};
  }
}

void Head::report_gap(std::uint32_t number) {
  if (!gap_is_reported_) {
    gap_is_reported_ = true;
    refuse(Refusal::kGap, number);
  }
}

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
