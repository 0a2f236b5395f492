// Turns the captures of a timer, one channel for each input, into the edges of a head. The timer
// filters the inputs, so that a pin may have changed again before its capture is read. Therefore
// each capture toggles the state; the pin decides only if the timer reports lost captures.
//
// All calls must come from interrupts of one priority.
#pragma once

#include <cstddef>
#include <cstdint>

#include <head/head.hpp>

namespace gs::head {

class Contacts {
 public:
  explicit Contacts(Head& head) : head_(head) {}

  // `closed`: bit i is the state of input i, here and below.
  void start(std::uint8_t closed);
  // A capture at `count`. `lost`: the timer has lost captures of this input before it.
  void capture(std::size_t input, std::uint64_t count, bool lost, std::uint8_t closed);
  // To be called once a millisecond. If a pin differs from the state in two successive calls
  // without a capture, an edge was missed: it is counted, and the state follows the pin.
  void compare(std::uint8_t closed);

 private:
  Head& head_;
  std::uint8_t closed_ = 0;
  std::uint8_t differed_ = 0;  // at the last compare(), and not captured since
};

}  // namespace gs::head
