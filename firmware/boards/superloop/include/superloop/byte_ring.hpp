// What goes between an interrupt and the loop: one side puts, the other takes. On one core,
// volatile keeps the order: an item is in before it counts.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::superloop {

template <class T, std::size_t kItems>
class Ring {
  static_assert((kItems & (kItems - 1)) == 0, "the counters wrap at powers of two");

 public:
  std::size_t used() const { return put_ - taken_; }
  std::size_t room() const { return kItems - used(); }

  // False where it is full.
  bool put(T item) {
    if (room() == 0) {
      return false;
    }
    items_[put_ % kItems] = item;
    put_ = put_ + 1;
    return true;
  }

  // All of them or none.
  bool put(const T* items, std::size_t count) {
    if (room() < count) {
      return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
      put(items[i]);
    }
    return true;
  }

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

}  // namespace gs::superloop
