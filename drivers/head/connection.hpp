// The bench's side of the protocol of firmware/head/protocol.md: frames, numbers, and repetition of
// what was lost (go-back-N).
#pragma once

#include "edge_order.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <head/codec.hpp>
#include <head/messages.hpp>
#include <source/interrupt.hpp>
#include <transport/transport.hpp>
#include <wire/frame.hpp>

namespace gsbench::head {

namespace protocol = gs::head;
using transport::Clock;

class Connection {
 public:
  Connection(const std::string& port, int baud)
      : transport_(transport::make_transport(port, baud)) {}

  const std::string& port() const { return transport_->port(); }
  bool is_open() const { return transport_->is_open(); }
  // Blocks as Transport::open() does.
  drivers::Status open();
  void close() noexcept { transport_->close(); }

  // Begins a session: the head switches its output off and clears everything. Blocks until its
  // hello arrives, 1 s at most. An error if interrupted.
  drivers::Result<protocol::Hello> identify(source::Interrupt& interrupt);

  // Sends a message with the next number. It is kept until the head has accepted it, and sent again
  // if it was lost. For identify(), arm() and ping(), use these functions.
  template <class Message>
  drivers::Status send(const Message& message);
  drivers::Status arm(std::uint32_t run);
  // Asks for a status, which also reports a loss of the messages before.
  drivers::Status ping();

  // Reads what arrives. Blocks until a byte has arrived, at most until `until`. An error if the
  // connection is lost, the head restarted, or it refused a message for another reason than a loss.
  drivers::Status receive(Clock::time_point until);

  // Output off, confirmed by the head. Ends the session, but needs none. Blocks for 0.6 s at most.
  drivers::Status switch_off();

  // The newest status and when it arrived; none before the first.
  const std::optional<protocol::Status>& status() const { return status_; }
  Clock::time_point status_arrival() const { return status_arrival_; }
  // Whether the newest status answers the newest ping.
  bool ping_answered() const { return status_ && status_->echo == ping_; }
  // Shortest time from a ping to its answer.
  std::optional<Clock::duration> round_trip() const { return round_trip_; }
  EdgeOrder& edges() { return edges_; }

 private:
  struct Kept {
    std::uint32_t number;
    std::vector<std::uint8_t> frame;
    Clock::time_point sent;
  };

  template <class Message>
  static std::vector<std::uint8_t> framed(const Message& message, std::uint32_t number);
  template <class Message>
  bool decoded(Message& message) const {
    return protocol::decode(reader_.message(), reader_.size(), message);
  }
  void take_message(Clock::time_point arrival);
  void take(const protocol::Hello& hello, std::uint32_t number);
  void take(const protocol::Status& status, Clock::time_point arrival);
  void take(const protocol::Refused& refused);
  void accept_until(std::uint32_t expected);
  drivers::Status repeat_lost();
  drivers::Status go_back();

  std::unique_ptr<transport::Transport> transport_;
  std::vector<std::uint8_t> bytes_;
  gs::wire::FrameReader reader_;

  bool in_session_ = false;
  std::optional<protocol::Hello> hello_;
  bool foreign_bytes_ = false;  // of whatever is on the port
  std::uint32_t next_ = 0;      // number of the next message
  std::deque<Kept> kept_;       // not accepted yet
  std::uint32_t run_ = 0;

  std::optional<protocol::Status> status_;
  Clock::time_point status_arrival_;
  std::uint32_t ping_ = 0;  // token of the newest ping
  std::optional<Clock::time_point> ping_sent_;
  std::optional<Clock::duration> round_trip_;
  EdgeOrder edges_;

  bool gap_ = false;  // reported by the head, not yet repeated
  std::optional<std::uint32_t> edges_to_ask_for_;
  std::string failure_;  // what receive() reports
};

template <class Message>
std::vector<std::uint8_t> Connection::framed(const Message& message, std::uint32_t number) {
  std::array<std::uint8_t, protocol::kLongestMessage> bytes;
  const std::size_t size = protocol::encode(message, number, bytes.data(), bytes.size());
  std::vector<std::uint8_t> frame(gs::wire::kLongestFrame);
  frame.resize(gs::wire::frame(bytes.data(), size, frame.data(), frame.size()));
  return frame;
}

template <class Message>
drivers::Status Connection::send(const Message& message) {
  kept_.push_back({next_, framed(message, next_), Clock::now()});
  ++next_;
  return transport_->send(kept_.back().frame);
}

}  // namespace gsbench::head
