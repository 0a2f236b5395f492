#include "turns.hpp"

#include <algorithm>
#include <cstddef>

namespace gsbench::link {

bool Turns::take(std::uint32_t start_number, std::uint32_t sequence, bool had_left) {
  constexpr int kReturnsOfTwo = 2;
  constexpr std::size_t kMostStarts = 16;
  const auto known = std::find_if(starts_.begin(), starts_.end(),
                                  [&](const Start& start) { return start.number == start_number; });
  if (known == starts_.end()) {
    starts_.push_back({start_number, sequence});
    if (starts_.size() > kMostStarts) {
      starts_.erase(starts_.begin());
    }
    returns_ = 0;
    return false;
  }
  const bool is_new = sequence - known->newest_hello - 1 < (1U << 31U);
  if (is_new) {
    known->newest_hello = sequence;
    if (had_left) {
      returns_ += known + 1 == starts_.end() ? 0 : 1;
      std::rotate(known, known + 1, starts_.end());
    }
  }
  return returns_ >= kReturnsOfTwo;
}

bool Turns::knows(std::uint32_t start_number) const {
  return std::any_of(starts_.begin(), starts_.end(),
                     [&](const Start& start) { return start.number == start_number; });
}

}  // namespace gsbench::link
