// Messages from the bench, and what they do. Messages to the bench: head_uplink.cpp.
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

}  // namespace gs::head
