// Samples between a converter's interrupt and the loop, in order, with what was lost in its place:
// once a block did not fit, those after it are dropped too until the loop has taken what came
// before the gap.
#pragma once

#include <cstddef>
#include <cstdint>

#include <superloop/byte_ring.hpp>

namespace gs::superloop {

template <std::size_t kSamples>
class SampleQueue {
 public:
  // From the interrupt.
  void put(const std::int16_t* block, std::size_t count) {
    if (lost_ != 0 || !samples_.put(block, count)) {
      lose(static_cast<std::uint32_t>(count));
    }
  }
  void lose(std::uint32_t count) { lost_ = lost_ + count; }

  // From the loop, with that interrupt masked: lost ones come before the samples that are returned.
  std::size_t take(std::int16_t* out, std::size_t most, std::uint32_t& lost) {
    lost = 0;
    if (empty()) {
      lost = lost_;
      lost_ = 0;
      return 0;
    }
    std::size_t count = 0;
    while (count < most && samples_.take(out[count])) {
      ++count;
    }
    return count;
  }

  bool empty() const { return samples_.used() == 0; }
  bool idle() const { return empty() && lost_ == 0; }

 private:
  Ring<std::int16_t, kSamples> samples_;
  volatile std::uint32_t lost_ = 0;
};

}  // namespace gs::superloop
