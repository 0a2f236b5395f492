// Queues between an interrupt and the loop: one side puts, the other takes. An item must be
// stored before the counter advances. On a single core, volatile ensures this order.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::queues {

template <class T, std::size_t kItems>
class Ring {
  static_assert((kItems & (kItems - 1)) == 0, "the counters wrap at powers of two");

 public:
  std::size_t used() const { return put_ - taken_; }
  std::size_t room() const { return kItems - used(); }

  // Returns false if the ring is full.
  bool put(T item) {
    if (room() == 0) {
      return false;
    }
    items_[put_ % kItems] = item;
    put_ = put_ + 1;
    return true;
  }

  // Puts all items, or none if they do not fit.
  bool put(const T* items, std::size_t count) {
    if (room() < count) {
      return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
      put(items[i]);
    }
    return true;
  }

  // Only while neither side puts or takes.
  void clear() { taken_ = put_; }

  bool take(T& item) {
    if (used() == 0) {
      return false;
    }
    item = items_[taken_ % kItems];
    taken_ = taken_ + 1;
    return true;
  }

 private:
  volatile std::uint32_t put_ = 0;
  volatile std::uint32_t taken_ = 0;
  volatile T items_[kItems] = {};
};

template <std::size_t kBytes>
using ByteRing = Ring<std::uint8_t, kBytes>;

// Samples on their way from the ADC's interrupt to the loop. The loop learns of lost samples after
// it has taken all samples before the gap. When a block does not fit, it and all later blocks are
// dropped until then, so that there is only one gap at a time.
template <std::size_t kSamples>
class SampleQueue {
 public:
  // Called from the interrupt.
  void put(const std::int16_t* block, std::size_t count) {
    if (lost_ != 0 || !samples_.put(block, count)) {
      lose(static_cast<std::uint32_t>(count));
    }
  }
  void lose(std::uint32_t count) { lost_ = lost_ + count; }

  // Called from the loop, with the ADC's interrupt masked. Returns the number of samples taken. At
  // a gap, returns 0 and sets `lost` to the number of lost samples.
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

}  // namespace gs::queues
