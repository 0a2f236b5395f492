// Recognises two units that take turns at the broker: they have the same client id, so that each
// leaves when the other comes, and comes back with a new hello of its earlier start.
#pragma once

#include <cstdint>
#include <vector>

namespace gsbench::link {

class Turns {
 public:
  // A hello of this start and with this number among the hellos of that start. `had_left`: the
  // outlet was not on the broker before; without it, a hello of an earlier start is late, because a
  // client may repeat it after newer ones when its connection has broken. True once two units have
  // taken turns: after two returns to an earlier start.
  bool take(std::uint32_t start_number, std::uint32_t sequence, bool had_left);
  bool knows(std::uint32_t start_number) const;  // among the newest

 private:
  struct Start {
    std::uint32_t number = 0;
    std::uint32_t newest_hello = 0;
  };

  std::vector<Start> starts_;  // the newest last
  int returns_ = 0;            // since the newest start began
};

}  // namespace gsbench::link
