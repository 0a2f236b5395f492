#include "connection.hpp"

#include <fmt/format.h>

namespace gsbench::head {

using drivers::Done;
using drivers::Error;
using drivers::Result;

namespace {

using namespace std::chrono_literals;

constexpr int kIdentifyAttempts = 5;
constexpr auto kIdentifyPatience = 200ms;
constexpr int kStopAttempts = 3;
constexpr auto kStopPatience = 200ms;
// A message that was not accepted after this time was the last one before a pause, and was lost.
// Longer than a USB adapter keeps bytes (16 ms) and the time between two statuses.
constexpr auto kAcceptedAfter = 40ms;

const char* meaning(protocol::Refusal reason) {
  switch (reason) {
    case protocol::Refusal::kMalformed:
      return "malformed";
    case protocol::Refusal::kUnknownKind:
      return "of an unknown kind";
    case protocol::Refusal::kNotIdentified:
      return "the head has forgotten this session, so it has restarted";
    case protocol::Refusal::kVersion:
      return "of another protocol version";
    case protocol::Refusal::kGap:
      return "messages before it are missing";
    case protocol::Refusal::kState:
      return "not accepted in the head's state";
    case protocol::Refusal::kPosition:
      return "its samples are not the next ones";
    case protocol::Refusal::kNoRoom:
      return "its samples have no room";
    case protocol::Refusal::kRange:
      return "a sample is beyond full scale";
    case protocol::Refusal::kNotKept:
      return "the head no longer has the edges that were lost on the line";
  }
  return "for an unknown reason";
}

}  // namespace

drivers::Status Connection::open() {
  in_session_ = false;
  reader_ = {};
  status_.reset();
  failure_.clear();
  foreign_bytes_ = false;
  return transport_->open();
}

Result<protocol::Hello> Connection::identify(source::Interrupt& interrupt) {
  in_session_ = false;
  hello_.reset();
  for (int attempt = 0; attempt < kIdentifyAttempts; ++attempt) {
    if (interrupt.is_set()) {
      return Error{port() + ": " + source::Interrupt::error().message};
    }
    const drivers::Status sent = transport_->send(framed(protocol::Identify(), next_++));
    if (!sent.ok()) {
      return Error{sent.error()};
    }
    const auto end = Clock::now() + kIdentifyPatience;
    while (!hello_ && Clock::now() < end && !interrupt.is_set()) {
      if (const drivers::Status received = receive(source::Interrupt::part_of(end));
          !received.ok()) {
        return Error{received.error()};
      }
    }
    if (hello_) {
      in_session_ = true;
      kept_.clear();
      edges_.restart();
      status_.reset();
      gap_ = false;
      return *hello_;
    }
  }
  return Error{port() + (foreign_bytes_ ? ": what answers is not a DAC head"
                                        : ": no DAC head answers (1 s)")};
}

drivers::Status Connection::arm(std::uint32_t run) {
  run_ = run;
  edges_.restart();
  return send(protocol::Arm{run});
}

drivers::Status Connection::ping() {
  ping_sent_ = Clock::now();
  return transport_->send(framed(protocol::Ping{++ping_}, next_));
}

drivers::Status Connection::receive(Clock::time_point until) {
  bytes_.clear();
  if (drivers::Status received = transport_->receive(bytes_, until); !received.ok()) {
    return received;
  }
  const auto arrival = Clock::now();
  foreign_bytes_ = foreign_bytes_ || !bytes_.empty();
  for (const std::uint8_t byte : bytes_) {
    if (reader_.take(byte) == gs::wire::FrameReader::Taken::kMessage) {
      take_message(arrival);
    }
  }
  if (!failure_.empty()) {
    return Error{port() + ": " + failure_};
  }
  return in_session_ ? repeat_lost() : Done{};
}

drivers::Status Connection::switch_off() {
  in_session_ = false;
  failure_.clear();
  for (int attempt = 0; attempt < kStopAttempts; ++attempt) {
    if (drivers::Status sent = transport_->send(framed(protocol::Stop(), next_++)); !sent.ok()) {
      return sent;
    }
    if (drivers::Status sent = ping(); !sent.ok()) {
      return sent;
    }
    for (const auto end = Clock::now() + kStopPatience; Clock::now() < end;) {
      if (drivers::Status received = receive(end); !received.ok()) {
        return received;
      }
      if (ping_answered() && status_->state == protocol::State::kOff) {
        return Done{};
      }
    }
  }
  return Error{port() + ": the head does not confirm that its output is off"};
}

void Connection::take_message(Clock::time_point arrival) {
  protocol::Header header;
  protocol::Hello hello;
  protocol::Status status;
  protocol::Edge edge;
  protocol::Refused refused;
  if (!protocol::decode_header(reader_.message(), reader_.size(), header)) {
    return;
  }
  if (decoded(hello)) {
    take(hello, header.number);
  } else if (decoded(status)) {
    take(status, arrival);
  } else if (in_session_ && decoded(edge)) {
    edges_.take(edge);
  } else if (in_session_ && decoded(refused)) {
    take(refused);
  }
}

// A hello with number 0 means that the head has just started.
void Connection::take(const protocol::Hello& hello, std::uint32_t number) {
  if (!in_session_ && number != 0) {
    hello_ = hello;
  } else if (in_session_ && number == 0) {
    failure_ = (hello.flags & protocol::kRestartedByWatchdog) != 0
                   ? "the head has restarted, because its firmware had hung"
                   : "the head has restarted";
  }
}

void Connection::take(const protocol::Status& status, Clock::time_point arrival) {
  status_ = status;
  status_arrival_ = arrival;
  if (ping_sent_ && status.echo == ping_) {
    const Clock::duration round_trip = arrival - *ping_sent_;
    round_trip_ = round_trip_ ? std::min(*round_trip_, round_trip) : round_trip;
    ping_sent_.reset();
  }
  accept_until(status.expected);
  if (status.run == run_) {
    // Several statuses may arrive at once; only the first one asks.
    if (const auto missing = edges_.missing(status.edges, arrival)) {
      edges_to_ask_for_ = missing;
    }
  }
}

void Connection::take(const protocol::Refused& refused) {
  accept_until(refused.expected);
  if (refused.reason == protocol::Refusal::kGap) {
    gap_ = true;
  } else if (failure_.empty()) {
    failure_ =
        fmt::format("the head refused message {}: {}", refused.refused, meaning(refused.reason));
  }
}

void Connection::accept_until(std::uint32_t expected) {
  while (!kept_.empty() && static_cast<std::int32_t>(kept_.front().number - expected) < 0) {
    kept_.pop_front();
  }
}

drivers::Status Connection::repeat_lost() {
  if (edges_to_ask_for_) {
    const protocol::ResendEdges resend{*edges_to_ask_for_};
    edges_to_ask_for_.reset();
    if (drivers::Status sent = send(resend); !sent.ok()) {
      return sent;
    }
  }
  const bool overdue = !kept_.empty() && Clock::now() - kept_.front().sent > kAcceptedAfter;
  return gap_ || overdue ? go_back() : Done{};
}

drivers::Status Connection::go_back() {
  gap_ = false;
  for (Kept& kept : kept_) {
    kept.sent = Clock::now();
    if (drivers::Status sent = transport_->send(kept.frame); !sent.ok()) {
      return sent;
    }
  }
  return Done{};
}

}  // namespace gsbench::head
