// A campaign's work: numbered blocks, on as many threads as there are, added up into tallies. What
// a block comes to depends on its number alone.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include <campaign/tally.hpp>

namespace gsbench::campaign {

using Tallies = std::vector<Tally>;

// How a campaign is shared out among processes. There is one so far; whoever spreads campaigns over
// a cluster implements it (MPI: a slice of the blocks by rank, sums by MPI_Allreduce).
class Reduction {
 public:
  struct Range {
    std::uint64_t first;
    std::uint64_t end;
  };
  virtual ~Reduction() = default;
  virtual Range share(std::uint64_t blocks) const = 0;  // this process's
  // Of all processes, in each.
  virtual void add_up(Tallies& tallies, std::uint64_t& blocks_done) const = 0;
};

const Reduction& one_process();

struct Execution {
  std::size_t threads = 1;
  const std::atomic<bool>* stop = nullptr;    // after the blocks in hand
  std::function<void(double part)> progress;  // from any thread, one at a time
  const Reduction* reduction = &one_process();
};

inline bool stopped(const Execution& execution) {
  return execution.stop != nullptr && execution.stop->load();
}

// The same, for a part whose progress is told by whoever asks for it.
inline Execution quiet(const Execution& execution) {
  Execution silent = execution;
  silent.progress = nullptr;
  return silent;
}

using Block = std::function<void(std::uint64_t block, Tallies& own)>;

// Adds the blocks up into `tallies`, which come empty. Returns how many blocks were done: all,
// unless it was stopped. Rethrows what a block throws.
std::uint64_t run_blocks(std::uint64_t blocks, const Execution& execution, const Block& work,
                         Tallies& tallies);

}  // namespace gsbench::campaign
