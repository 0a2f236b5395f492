// The edges of the inputs, on their way from the capture timer's interrupt to the main loop. The
// newest kKeptEdges are kept, so that the bench can ask for them again.
#pragma once

#include <cstddef>
#include <cstdint>

#include <head/messages.hpp>

namespace gs::head {

class Edges {
 public:
  // ---- interrupt

  // `keep` is false: only the state of the input changes, and no edge is kept.
  void add(std::size_t input, bool closed, std::uint64_t count, bool keep);
  void add_missed(std::uint32_t edges) { missed_ = missed_ + edges; }

  // ---- main loop

  // Only while no edges are kept by add().
  void clear();
  // The next edge to send, with the timer's count; false: there is none.
  bool take(Edge& edge);
  // Continues with this edge. Returns false if it has not happened yet or is no longer kept.
  bool resend(std::uint32_t first_edge);

  std::uint32_t happened() const { return happened_; }
  std::uint8_t closed() const { return closed_; }  // bit i: input i
  std::uint32_t missed() const { return missed_ + overwritten_; }

 private:
  struct Kept {
    volatile std::uint64_t count;
    volatile std::uint8_t input;
    volatile bool closed;
  };

  Kept kept_[kKeptEdges] = {};
  volatile std::uint32_t happened_ = 0;
  volatile std::uint32_t missed_ = 0;
  volatile std::uint8_t closed_ = 0;
  std::uint32_t sent_ = 0;
  std::uint32_t overwritten_ = 0;  // before they were sent
};

}  // namespace gs::head
