// A run that is stopped from outside: kept, and told as what it is.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using gsbench::test::Outcome;
using gsbench::test::Started;
using gsbench::test::TemporaryFolder;

// In real time the six seconds of the profile leave room for a signal.
Started start_slow_run(const fs::path& runs) {
  Started started = gsbench::test::start_gsbench(
      {"run", "paper/loss-500mw", "--real-time", "--json", "--out", runs.string()});
  // It is under way once its record is there.
  for (int tries = 0; tries < 1000; ++tries) {
    if (fs::exists(runs)) {
      for (const fs::directory_entry& entry : fs::directory_iterator(runs)) {
        if (fs::exists(entry.path() / "record.sqlite")) {
          std::this_thread::sleep_for(std::chrono::milliseconds(100));
          return started;
        }
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "the run did not begin";
  return started;
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, EndsTheRunWithARecordThatSaysSo) {
  const TemporaryFolder folder;
  const fs::path runs = folder.path() / "runs";
  const Started started = start_slow_run(runs);
  kill(started.pid, GetParam());
  const Outcome outcome = gsbench::test::wait_for(started);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["verdict"], "ERROR");
  const Outcome report =
      gsbench::test::run_gsbench({"report", gsbench::test::only_run(runs).string()});
  EXPECT_NE(report.out.find("interrupted"), std::string::npos) << report.out;
}

INSTANTIATE_TEST_SUITE_P(BothSignals, Interrupt, testing::Values(SIGINT, SIGTERM));

TEST(Interrupt, AKilledRunLeavesNoRunThatLooksFinished) {
  const TemporaryFolder folder;
  const fs::path runs = folder.path() / "runs";
  const Started started = start_slow_run(runs);
  kill(started.pid, SIGKILL);
  EXPECT_EQ(gsbench::test::wait_for(started).exit_code, 128 + SIGKILL);
  const Outcome list = gsbench::test::run_gsbench({"runs", "--out", runs.string()});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(list.out, "");
  EXPECT_NE(list.err.find("not ended, or was killed"), std::string::npos) << list.err;
  // What it had kept can still be read.
  const Outcome report =
      gsbench::test::run_gsbench({"report", gsbench::test::only_run(runs).string()});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_NE(report.out.find("did not finish"), std::string::npos) << report.out;
}

}  // namespace
