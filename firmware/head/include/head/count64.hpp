// Extends the 32-bit counts of a timer to 64 bits. Needs no interrupt of the timer's overflow, so
// that an edge near an overflow cannot be taken for one before or after it.
//
// All calls must come from one interrupt priority, or with interrupts masked.
#pragma once

#include <cstdint>

namespace gs::head {

class Count64 {
 public:
  std::uint64_t now() const { return now_; }  // the count of the last advance()
  // To be called with ascending counts, at least once in 2^31 counts: 25 s at 84 MHz.
  void advance(std::uint32_t timer) { now_ = extend(timer); }

  // `timer` may be up to 2^31 − 1 counts before or after the last advance(). Returns 0 for a count
  // before start-up.
  std::uint64_t extend(std::uint32_t timer) const {
    const auto since = static_cast<std::int32_t>(timer - static_cast<std::uint32_t>(now_));
    const std::uint64_t count = now_ + static_cast<std::uint64_t>(std::int64_t{since});
    return since < 0 && count > now_ ? 0 : count;
  }

 private:
  std::uint64_t now_ = 0;
};

}  // namespace gs::head
