#include "edge_order.hpp"

namespace gsbench::head {

void EdgeOrder::take(const gs::head::Edge& edge) {
  if (edge.edge < next_) {
    return;
  }
  early_.emplace(edge.edge, edge);
  while (!early_.empty() && early_.begin()->first == next_) {
    in_order_.push_back(early_.begin()->second);
    early_.erase(early_.begin());
    ++next_;
    missing_since_.reset();
  }
}

std::optional<std::uint32_t> EdgeOrder::missing(std::uint32_t edges, Clock::time_point now) {
  if (edges <= next_) {
    missing_since_.reset();
    return std::nullopt;
  }
  if (!missing_since_) {
    missing_since_ = now;
  }
  if (now - *missing_since_ < kPatience) {
    return std::nullopt;
  }
  missing_since_ = now;
  return next_;
}

void EdgeOrder::move_to(std::vector<gs::head::Edge>& edges) {
  edges.insert(edges.end(), in_order_.begin(), in_order_.end());
  in_order_.clear();
}

}  // namespace gsbench::head
