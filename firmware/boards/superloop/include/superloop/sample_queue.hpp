// Samples between a converter's interrupt and the loop, in order, with what was lost in its place:
// once a block did not fit, those after it are dropped too until the loop has taken what came
// before the gap.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::superloop {

template <std::size_t kSamples>
class SampleQueue {
  static_assert((kSamples & (kSamples - 1)) == 0, "the counters wrap at powers of two");

 public:
  // From the interrupt.
  void put(const volatile std::int16_t* block, std::size_t count) {
    if (lost_ != 0 || kSamples - (put_ - taken_) < count) {
      return lose(static_cast<std::uint32_t>(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
      samples_[(put_ + i) % kSamples] = block[i];
    }
    put_ = put_ + static_cast<std::uint32_t>(count);
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
    std::size_t count = put_ - taken_;
    count = count < most ? count : most;
    for (std::size_t i = 0; i < count; ++i) {
      out[i] = samples_[(taken_ + i) % kSamples];
    }
    taken_ = taken_ + static_cast<std::uint32_t>(count);
    return count;
  }

  bool empty() const { return put_ == taken_; }
  bool idle() const { return empty() && lost_ == 0; }

 private:
  volatile std::uint32_t put_ = 0;
  volatile std::uint32_t taken_ = 0;
  volatile std::uint32_t lost_ = 0;
  volatile std::int16_t samples_[kSamples] = {};
};

}  // namespace gs::superloop
