#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <drivers/workers.hpp>

namespace gsbench::drivers {
namespace {

TEST(Workers, DoEachPieceOnceForAnyNumberOfThreadsAndPieces) {
  for (const std::size_t threads : {0U, 1U, 2U, 3U, 8U}) {
    Workers workers(threads);
    for (const std::size_t pieces : {0U, 1U, 2U, 3U, 7U, 64U}) {
      std::vector<int> done(pieces, 0);
      workers.run(pieces, [&](std::size_t piece) { ++done[piece]; });
      EXPECT_EQ(done, std::vector<int>(pieces, 1)) << threads << " threads";
    }
  }
}

// The counters are plain ints: run() must synchronise the pieces' writes with the caller and with
// the next run (checked by the thread sanitizer). A lost or doubled piece changes a count.
TEST(Workers, RunManyShortJobsInSequence) {
  constexpr int kRuns = 3000;
  Workers workers(4);
  std::vector<int> done(5, 0);
  for (int run = 0; run < kRuns; ++run) {
    workers.run(done.size(), [&](std::size_t piece) { ++done[piece]; });
    ASSERT_EQ(done[static_cast<std::size_t>(run) % done.size()], run + 1);
  }
  EXPECT_EQ(done, std::vector<int>(5, kRuns));
}

TEST(Workers, RethrowTheFirstExceptionAfterAllPieces) {
  for (const std::size_t threads : {1U, 4U}) {
    Workers workers(threads);
    std::vector<int> done(16, 0);
    const auto odd_ones_throw = [&](std::size_t piece) {
      ++done[piece];
      if (piece % 2 == 1) {
        throw std::runtime_error("odd");
      }
    };
    EXPECT_THROW(workers.run(done.size(), odd_ones_throw), std::runtime_error);
    EXPECT_EQ(done, std::vector<int>(16, 1));
    EXPECT_NO_THROW(workers.run(done.size(), [&](std::size_t piece) { ++done[piece]; }))
        << "an exception must be rethrown only once";
    EXPECT_EQ(done, std::vector<int>(16, 2));
  }
}

TEST(Workers, StartAndStopWithoutWork) {
  for (int i = 0; i < 200; ++i) {
    const Workers workers(3);
  }
}

TEST(Workers, RunPiecesConcurrently) {
  Workers workers(2);
  std::mutex mutex;
  std::condition_variable both_here;
  int arrived = 0;
  int met = 0;
  workers.run(2, [&](std::size_t) {
    std::unique_lock<std::mutex> lock(mutex);
    ++arrived;
    both_here.notify_all();
    // Pieces run in sequence would never meet; the time limit only ends a failing test.
    met += both_here.wait_for(lock, std::chrono::seconds(20), [&] { return arrived == 2; }) ? 1 : 0;
  });
  EXPECT_EQ(met, 2);
}

}  // namespace
}  // namespace gsbench::drivers
