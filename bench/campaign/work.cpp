#include <algorithm>
#include <mutex>

#include <campaign/work.hpp>
#include <drivers/workers.hpp>

namespace gsbench::campaign {

std::uint64_t run_blocks(std::uint64_t blocks, const Execution& execution, const Block& work,
                         Histograms& histograms) {
  const Reduction::Range range = execution.reduction->share(blocks);
  const Histograms empty = histograms;
  std::atomic<std::uint64_t> next{range.first};
  std::mutex mutex;
  std::uint64_t done = 0;
  // One thread, with its own histograms: takes blocks until none are left.
  const auto shift = [&](std::size_t) {
    Histograms own = empty;
    try {
      for (std::uint64_t block = next++; block < range.end && !stopped(execution); block = next++) {
        work(block, own);
        const std::lock_guard<std::mutex> lock(mutex);
        ++done;
        report_progress(execution, static_cast<double>(done),
                        static_cast<double>(range.end - range.first));
      }
    } catch (...) {
      next = range.end;  // the other threads start no more blocks
      throw;
    }
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t i = 0; i < own.size(); ++i) {
      histograms[i].merge(own[i]);
    }
  };
  const std::size_t threads = std::max<std::size_t>(execution.threads, 1);
  drivers::Workers(threads).run(threads, shift);
  execution.reduction->add_up(histograms, done);
  return done;
}

}  // namespace gsbench::campaign
