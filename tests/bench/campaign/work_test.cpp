#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>

#include <campaign/work.hpp>

namespace gsbench::campaign {
namespace {

Histograms one() {
  return {Histogram(0.0, 1000.0, 1000)};
}

void add_number(std::uint64_t block, Histograms& own) {
  own[0].add(static_cast<double>(block));
}

TEST(Work, EveryBlockIsDoneOnceOnAnyNumberOfThreads) {
  for (const std::size_t threads : {1U, 2U, 3U, 8U}) {
    Histograms histograms = one();
    Execution execution;
    execution.threads = threads;
    EXPECT_EQ(run_blocks(1000, execution, add_number, histograms), 1000U);
    for (std::size_t bin = 0; bin < 1000; ++bin) {
      EXPECT_EQ(histograms[0].in_bin(bin), 1) << bin;
    }
  }
}

TEST(Work, ProgressRisesToOne) {
  Histograms histograms = one();
  Execution execution;
  execution.threads = 3;
  double last = 0.0;
  execution.progress = [&](double part) {
    EXPECT_GT(part, last);
    last = part;
  };
  run_blocks(100, execution, add_number, histograms);
  EXPECT_EQ(last, 1.0);
}

TEST(Work, WhenStoppedKeepsTheBlocksDone) {
  Histograms histograms = one();
  std::atomic<bool> stop{false};
  Execution execution;
  execution.stop = &stop;
  const auto done = run_blocks(
      1000, execution,
      [&](std::uint64_t block, Histograms& own) {
        add_number(block, own);
        stop = block == 9;
      },
      histograms);
  EXPECT_EQ(done, 10U);
  EXPECT_EQ(histograms[0].count(), 10);
}

TEST(Work, RethrowsAnExceptionOfABlock) {
  Histograms histograms = one();
  Execution execution;
  execution.threads = 2;
  EXPECT_THROW(run_blocks(
                   100, execution,
                   [](std::uint64_t block, Histograms&) {
                     if (block == 50) {
                       throw std::runtime_error("block 50");
                     }
                   },
                   histograms),
               std::runtime_error);
}

// One of several processes: computes its range and adds up the results of all.
class SecondHalf final : public Reduction {
 public:
  Range share(std::uint64_t blocks) const override { return {blocks / 2, blocks}; }
  void add_up(Histograms& histograms, std::uint64_t& blocks_done) const override {
    histograms[0].add(0.0);  // the result of another process
    ++blocks_done;
  }
};

TEST(Work, TheReductionChoosesTheBlocksAndAddsUpTheResults) {
  Histograms histograms = one();
  const SecondHalf reduction;
  Execution execution;
  execution.reduction = &reduction;
  EXPECT_EQ(run_blocks(100, execution, add_number, histograms), 51U);
  EXPECT_EQ(histograms[0].count_between(50.0, 100.0), 50);
  EXPECT_EQ(histograms[0].count_between(1.0, 50.0), 0);
  EXPECT_EQ(histograms[0].in_bin(0), 1);
}

}  // namespace
}  // namespace gsbench::campaign
