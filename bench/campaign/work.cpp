#include <exception>
#include <mutex>
#include <thread>

#include <campaign/work.hpp>

namespace gsbench::campaign {
namespace {

class OneProcess final : public Reduction {
 public:
  Range share(std::uint64_t blocks) const override { return {0, blocks}; }
  void add_up(Tallies&, std::uint64_t&) const override {}
};

// What the threads share.
class Shift {
 public:
  Shift(const Reduction::Range& range, const Execution& execution, const Block& work,
        Tallies& tallies)
      : range_(range), next_(range.first), execution_(execution), work_(work), tallies_(tallies) {}

  void work() {
    Tallies own = empty_;
    try {
      for (std::uint64_t block = next_++; block < range_.end && !stopped(); block = next_++) {
        work_(block, own);
        note_done();
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      failure_ = failure_ == nullptr ? std::current_exception() : failure_;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t i = 0; i < own.size(); ++i) {
      tallies_[i].merge(own[i]);
    }
  }

  std::uint64_t done() const { return done_; }
  void rethrow() const {
    if (failure_ != nullptr) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  bool stopped() {
    if (campaign::stopped(execution_)) {
      return true;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    return failure_ != nullptr;
  }
  void note_done() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    if (execution_.progress) {
      execution_.progress(static_cast<double>(done_) /
                          static_cast<double>(range_.end - range_.first));
    }
  }

  const Reduction::Range range_;
  std::atomic<std::uint64_t> next_;
  const Execution& execution_;
  const Block& work_;
  Tallies& tallies_;
  const Tallies empty_ = tallies_;
  std::mutex mutex_;
  std::uint64_t done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

const Reduction& one_process() {
  static const OneProcess process;
  return process;
}

std::uint64_t run_blocks(std::uint64_t blocks, const Execution& execution, const Block& work,
                         Tallies& tallies) {
  Shift shift(execution.reduction->share(blocks), execution, work, tallies);
  std::vector<std::thread> helpers;
  try {
    while (helpers.size() + 1 < execution.threads) {
      helpers.emplace_back([&shift] { shift.work(); });
    }
  } catch (const std::exception&) {
    // No room for so many: those that are there do it all.
  }
  shift.work();
  for (std::thread& helper : helpers) {
    helper.join();
  }
  shift.rethrow();
  std::uint64_t done = shift.done();
  execution.reduction->add_up(tallies, done);
  return done;
}

}  // namespace gsbench::campaign
