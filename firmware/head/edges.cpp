#include <head/edges.hpp>

namespace gs::head {

void Edges::add(std::size_t input, bool closed, std::uint64_t count, bool keep) {
  const unsigned bit = 1U << input;
  closed_ = static_cast<std::uint8_t>(closed ? closed_ | bit : closed_ & ~bit);
  if (!keep) {
    return;
  }
  Kept& kept = kept_[happened_ % kKeptEdges];
  kept.count = count;
  kept.input = static_cast<std::uint8_t>(input);
  kept.closed = closed;
  happened_ = happened_ + 1;
}

void Edges::clear() {
  happened_ = 0;
  sent_ = 0;
}

bool Edges::take(Edge& edge) {
  while (sent_ != happened_) {
    const std::uint32_t waiting = happened_ - sent_;
    if (waiting > kKeptEdges) {
      overwritten_ += waiting - static_cast<std::uint32_t>(kKeptEdges);
      sent_ += waiting - static_cast<std::uint32_t>(kKeptEdges);
    }
    const Kept& kept = kept_[sent_ % kKeptEdges];
    edge.edge = sent_;
    edge.input = kept.input;
    edge.closed = kept.closed;
    edge.count = static_cast<std::int64_t>(kept.count);
    // Not overwritten by an interrupt while it was read.
    if (happened_ - sent_ <= kKeptEdges) {
      ++sent_;
      return true;
    }
  }
  return false;
}

bool Edges::resend(std::uint32_t first_edge) {
  const std::uint32_t happened = happened_;
  if (first_edge > happened || happened - first_edge > kKeptEdges) {
    return false;
  }
  sent_ = first_edge;
  return true;
}

}  // namespace gs::head
