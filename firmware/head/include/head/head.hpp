// A DAC head without its hardware: plays the bench's stream and measures the edges of its inputs,
// on one clock. protocol.md describes states, flow control and timing. The board and the bench's
// emulated head run this code.
//
// On a board, three contexts share the object, in order of rising priority:
// - the main loop calls take, bad_frame and next_message
// - the interrupt of the codes calls next_codes and fail
// - the interrupt of the edges calls set_input, edge and edges_missed
// Each may be interrupted at any point by one of a higher priority. On a host, one thread at a time
// uses the object.
//
// Counts are those of the capture timer, from start-up on. No call blocks.
#pragma once

#include <cstddef>
#include <cstdint>

#include <head/codec.hpp>
#include <head/edges.hpp>
#include <head/messages.hpp>
#include <head/player.hpp>

namespace gs::head {

constexpr std::uint32_t kFirmwareVersion = 1000;  // 0.1.0

// What the board states about itself in the hello.
struct Hardware {
  char board[kBoardBytes + 1] = {};             // printable ASCII, then zeros
  std::uint8_t unique_id[kUniqueIdBytes] = {};  // zeros: unknown
  std::uint32_t build = 0;                      // first 32 bits of the sources' SHA-256
  std::uint16_t flags = 0;                      // HelloFlag
  std::uint32_t counts_per_sample = 0;
  std::uint16_t full_scale_mv = kFullScale_mv;  // nominal voltage of kFullScale, peak
};

class Head {
 public:
  // The first message is a hello.
  explicit Head(const Hardware& hardware) : hardware_(hardware) {}

  // A message from the bench: the contents of a frame with a correct CRC.
  void take(const std::uint8_t* message, std::size_t size);
  // A frame that is not COBS, or has a wrong CRC.
  void bad_frame() { ++bad_frames_; }
  // Writes the next message to send and returns its length, at most kLongestUplink. Returns 0 if
  // there is none now, or `capacity` is less than kLongestUplink. To be called until it returns 0,
  // at least once a millisecond. `now`: the count now.
  std::size_t next_message(std::uint64_t now, std::uint8_t* out, std::size_t capacity);

  // Writes the next codes for the DAC, 1 … 4095, kCodeRate_hz of them a second; mid-scale unless
  // playing. `first_count`: when the first of them will be at the output. A stream begins, and
  // `stop` takes effect, with the first code of a call, so that calls should be for a millisecond.
  void next_codes(std::uint64_t first_count, std::uint16_t* out, std::size_t count) {
    player_.next_codes(first_count, out, count);
  }
  // The board cannot play: the head is then faulted, if it was armed or playing.
  void fail(Fault fault) { player_.fail(fault); }
  // The state of an input, 0 … kInputs − 1, without an edge. All are open at start-up.
  void set_input(std::size_t input, bool closed) { edges_.add(input, closed, 0, false); }
  // The input has changed.
  void edge(std::size_t input, bool closed, std::uint64_t count) {
    edges_.add(input, closed, count, player_.has_begun());
  }
  // Edges too close together to be measured.
  void edges_missed(std::uint32_t edges) { edges_.add_missed(edges); }

  State state() const { return player_.state(); }
  std::size_t buffered() const { return kBufferSamples - player_.room(); }  // samples

 private:
  enum class Session : std::uint8_t { kNone, kOtherVersion, kOpen };

  void take_identify(const std::uint8_t* message, std::size_t size, std::uint32_t number);
  void take_stop(const std::uint8_t* message, std::size_t size, std::uint32_t number);
  void take_ping(const std::uint8_t* message, std::size_t size, std::uint32_t number);
  void take_in_order(const std::uint8_t* message, std::size_t size, const Header& header);
  template <class Message>
  void take_as(Message& into, const std::uint8_t* message, std::size_t size, std::uint32_t number);
  // Each returns kAccepted, or the reason and has no effect.
  static constexpr Refusal kAccepted = Refusal{};
  Refusal apply(const Arm& arm);
  Refusal apply(const Samples& samples);
  Refusal apply(const Play& play);
  Refusal apply(const ResendEdges& resend);

  // Distance of a number from the expected one, modulo 2^32; negative: a repeated message.
  std::int32_t ahead(std::uint32_t number) const {
    return static_cast<std::int32_t>(number - expected_);
  }
  void accept(std::uint32_t number);
  void refuse(Refusal reason, std::uint32_t number);
  void report_gap(std::uint32_t number);

  template <class Message>
  std::size_t send(const Message& message, std::uint8_t* out, std::size_t capacity);
  std::size_t send_refusal(std::uint8_t* out, std::size_t capacity);
  bool status_is_due() const;
  Hello hello() const;
  Status status(std::uint64_t now) const;

  static constexpr std::size_t kWaitingRefusals = 8;

  const Hardware hardware_;
  Player player_;
  Edges edges_;

  Session session_ = Session::kNone;
  std::uint32_t expected_ = 0;  // number of the next message from the bench
  std::uint64_t received_ = 0;  // samples of the run
  std::uint32_t run_ = 0;
  std::uint32_t echo_ = 0;
  std::uint32_t bad_frames_ = 0;
  Samples samples_ = {};  // decoded here instead of on the stack

  std::uint32_t number_ = 0;  // of the next message to the bench
  bool hello_is_wanted_ = true;
  bool status_is_wanted_ = false;
  bool gap_is_reported_ = false;
  Refused refusals_[kWaitingRefusals] = {};
  std::size_t waiting_refusals_ = 0;
  std::uint32_t codes_at_status_ = 0;
  std::uint32_t changes_at_status_ = 0;
};

}  // namespace gs::head
