// Frames on a serial line: 0x00 COBS(message CRC-32) 0x00, the CRC little-endian over the message.
// A zero byte stands nowhere else, so that a receiver that lost its place finds the next frame; the
// leading zero ends whatever a power cut or a plug left half said. Empty frames are ignored.
#pragma once

#include <cstddef>
#include <cstdint>

#include <wire/codec.hpp>

namespace gs::wire {

constexpr std::size_t kCrcLength = 4;
// Zero, one code byte in 254 and one more, zero.
constexpr std::size_t kLongestFrame =
    kLongestMessage + kCrcLength + (kLongestMessage + kCrcLength) / 254 + 3;

// Returns the number of bytes; 0 where the message is empty, or it or its frame too long.
std::size_t frame(const std::uint8_t* message, std::size_t size, std::uint8_t* out,
                  std::size_t capacity);

class FrameReader {
 public:
  enum class Taken : std::uint8_t {
    kNothing = 0,   // no frame has ended
    kMessage = 1,   // message() and size() hold one, until the next take()
    kBadFrame = 2,  // one ended that is not COBS, too long, too short, or has a wrong CRC
  };

  Taken take(std::uint8_t byte);

  const std::uint8_t* message() const { return bytes_; }
  std::size_t size() const { return size_; }

 private:
  Taken end_frame();
  void put(std::uint8_t byte);

  std::uint8_t bytes_[kLongestMessage + kCrcLength] = {};
  std::size_t size_ = 0;      // decoded so far, or of the message that was found
  std::uint8_t code_ = 0;     // of the group in hand; 0: none
  std::uint8_t to_come_ = 0;  // bytes of that group
  bool too_long_ = false;
};

// Tells what is new from what comes twice or not at all. Messages are numbered from 0 at start-up.
class Sequence {
 public:
  enum class Order : std::uint8_t {
    kNext = 0,
    kGap = 1,        // missed() of them did not come
    kDuplicate = 2,  // or one from long before: not to be looked at
  };

  Order take(std::uint32_t sequence);
  void restart() { started_ = false; }  // the other side did
  std::uint32_t missed() const { return missed_; }
  // How far the newest duplicate was behind what is expected next.
  std::uint32_t behind() const { return behind_; }

 private:
  bool started_ = false;
  std::uint32_t next_ = 0;
  std::uint32_t missed_ = 0;
  std::uint32_t behind_ = 0;
};

}  // namespace gs::wire
