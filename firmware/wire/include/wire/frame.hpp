// Frames on a serial line: 0x00 COBS(message CRC-32) 0x00. The CRC is that of the message, in
// little-endian order. A frame has no other zero bytes, so that a receiver can resynchronise at any
// frame. The leading zero ends an earlier frame that was interrupted, for instance by a loss of
// power. Empty frames are ignored.
#pragma once

#include <cstddef>
#include <cstdint>

#include <wire/codec.hpp>

namespace gs::wire {

constexpr std::size_t kCrcLength = 4;
// Leading zero, one code byte per 254 bytes and one more, trailing zero.
constexpr std::size_t kLongestFrame =
    kLongestMessage + kCrcLength + (kLongestMessage + kCrcLength) / 254 + 3;

// Returns the number of bytes; 0 if the message is empty or too long, or the frame does not fit.
std::size_t frame(const std::uint8_t* message, std::size_t size, std::uint8_t* out,
                  std::size_t capacity);

class FrameReader {
 public:
  enum class Taken : std::uint8_t {
    kNothing = 0,   // no frame has ended
    kMessage = 1,   // message() and size() are valid until the next take()
    kBadFrame = 2,  // a frame ended that is not COBS, too long, too short, or has a wrong CRC
  };

  Taken take(std::uint8_t byte);

  const std::uint8_t* message() const { return bytes_; }
  std::size_t size() const { return size_; }

 private:
  Taken end_frame();
  void put(std::uint8_t byte);

  std::uint8_t bytes_[kLongestMessage + kCrcLength] = {};
  std::size_t size_ = 0;      // bytes decoded so far, or of the complete message
  std::uint8_t code_ = 0;     // code byte of the current COBS group; 0: none
  std::uint8_t to_come_ = 0;  // bytes missing from that group
  bool too_long_ = false;
};

// Detects lost and duplicate messages by the numbers of one count.
class Sequence {
 public:
  enum class Order : std::uint8_t {
    kNext = 0,
    kGap = 1,        // missed() messages were lost before this one
    kDuplicate = 2,  // a duplicate or late message: to be ignored
  };

  Order take(std::uint32_t sequence);
  void restart() { started_ = expects_ = false; }  // the next one is taken whatever its number
  // The number of the first message, if none is missing before it. A lower one is taken, too.
  void expect(std::uint32_t first) {
    expects_ = true;
    next_ = started_ ? next_ : first;
  }
  std::uint32_t missed() const { return missed_; }

 private:
  bool started_ = false;
  bool expects_ = false;
  std::uint32_t next_ = 0;
  std::uint32_t missed_ = 0;
};

}  // namespace gs::wire
