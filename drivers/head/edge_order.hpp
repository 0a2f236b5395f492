// Puts the edges of a head in the order of their numbers, and finds those that were lost on the
// line.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <head/messages.hpp>

namespace gsbench::head {

class EdgeOrder {
 public:
  using Clock = std::chrono::steady_clock;

  void restart() { *this = EdgeOrder(); }
  // An edge that was taken before is ignored.
  void take(const gs::head::Edge& edge);
  // `edges`: their number up to now, from a status. Returns the number of the first edge to ask for
  // again, at most once in kPatience: an edge may be on its way.
  std::optional<std::uint32_t> missing(std::uint32_t edges, Clock::time_point now);
  // Moves the edges without gaps to the end of `edges`.
  void move_to(std::vector<gs::head::Edge>& edges);

 private:
  static constexpr std::chrono::milliseconds kPatience{20};

  std::uint32_t next_ = 0;
  std::vector<gs::head::Edge> in_order_;
  std::map<std::uint32_t, gs::head::Edge> early_;  // behind a gap
  std::optional<Clock::time_point> missing_since_;
};

}  // namespace gsbench::head
