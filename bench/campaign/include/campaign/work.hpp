// A campaign's work: numbered blocks, computed on several threads and added up in histograms. The
// result of a block depends only on its number.
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

// How a campaign is distributed over processes: process k of N takes a range of the blocks. Only
// histograms are combined; their sum does not depend on the order. Results for single outlets stay
// in their process. This base class stands for a single process.
class Reduction {
 public:
  struct Range {
    std::uint64_t first;
    std::uint64_t end;
  };
  virtual ~Reduction() = default;
  // The blocks of this process.
  virtual Range share(std::uint64_t blocks) const { return {0, blocks}; }
  // Replaces both arguments, in every process, by the sum over all processes.
  virtual void add_up(Histograms& /*histograms*/, std::uint64_t& /*blocks_done*/) const {}
};

inline const Reduction kOneProcess{};

// Throws std::invalid_argument(message) if the condition is false.
inline void demand(bool condition, const std::string& message) {
  if (!condition) {
    throw std::invalid_argument(message);
  }
}

struct Execution {
  std::size_t threads = 1;
  const std::atomic<bool>* stop = nullptr;    // when set, no new block is started
  std::function<void(double part)> progress;  // 0 … 1; called on any thread, one call at a time
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

// A copy without the progress callback, for a nested step.
inline Execution quiet(const Execution& execution) {
  Execution silent = execution;
  silent.progress = nullptr;
  return silent;
}

using Block = std::function<void(std::uint64_t block, Histograms& own)>;

// Adds the results of all blocks to `histograms`, which must not contain values yet. Returns when
// all blocks are done or `execution` is stopped. The result is the number of blocks done. Rethrows
// an exception of a block.
std::uint64_t run_blocks(std::uint64_t blocks, const Execution& execution, const Block& work,
                         Histograms& histograms);

}  // namespace gsbench::campaign
