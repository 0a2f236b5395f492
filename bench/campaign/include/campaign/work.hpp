// A campaign's work: numbered blocks, on as many threads as there are, added up into histograms.
// What a block comes to depends on its number alone.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <campaign/histogram.hpp>

namespace gsbench::campaign {

using Histograms = std::vector<Histogram>;

// How a campaign is shared out among processes: shard k of N takes a slice of the blocks. Only
// histograms go through it, whose parts add up to the same bits in any order; what is kept for each
// outlet stays in its process. As it stands: there is one process.
class Reduction {
 public:
  struct Range {
    std::uint64_t first;
    std::uint64_t end;
  };
  virtual ~Reduction() = default;
  virtual Range share(std::uint64_t blocks) const { return {0, blocks}; }  // this process's
  // Of all processes, in each.
  virtual void add_up(Histograms& /*histograms*/, std::uint64_t& /*blocks_done*/) const {}
};

inline const Reduction kOneProcess{};

// Throws std::invalid_argument with that message unless it holds.
inline void demand(bool holds, const std::string& otherwise) {
  if (!holds) {
    throw std::invalid_argument(otherwise);
  }
}

struct Execution {
  std::size_t threads = 1;
  const std::atomic<bool>* stop = nullptr;    // after the blocks in hand
  std::function<void(double part)> progress;  // from any thread, one at a time
  const Reduction* reduction = &kOneProcess;
};

inline bool stopped(const Execution& execution) {
  return execution.stop != nullptr && execution.stop->load();
}

inline void report_progress(const Execution& execution, double done, double all) {
  if (execution.progress) {
    execution.progress(done / all);
  }
}

// The same, for a part whose progress is told by whoever asks for it.
inline Execution quiet(const Execution& execution) {
  Execution silent = execution;
  silent.progress = nullptr;
  return silent;
}

using Block = std::function<void(std::uint64_t block, Histograms& own)>;

// Adds the blocks up into `histograms`, which come empty. Returns how many blocks were done: all,
// unless it was stopped. Rethrows what a block throws.
std::uint64_t run_blocks(std::uint64_t blocks, const Execution& execution, const Block& work,
                         Histograms& histograms);

}  // namespace gsbench::campaign
