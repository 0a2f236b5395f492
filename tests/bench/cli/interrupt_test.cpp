// Runs that are interrupted or killed.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::HasSubstr;

// In real time the profile takes six seconds, enough time for a signal.
Started start_slow_run(
    const TemporaryFolder& folder, const std::function<void()>& prepare = [] {}) {
  Started started = start_gsbench(
      {"run", "paper/loss-500mw", "--real-time", "--json", "--out", folder.file("runs")}, prepare);
  // The run has started when its record exists.
  EXPECT_TRUE(until([&] {
    const Words entries = folder.entries();
    return std::any_of(entries.begin(), entries.end(), [](const std::string& entry) {
      return std::filesystem::path(entry).filename() == "record.sqlite";
    });
  }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return started;
}

Outcome stop_slow_run(const TemporaryFolder& folder, int signal) {
  return stop(start_slow_run(folder), signal);
}

TEST(Interrupt, EndsTheRunAndKeepsItAsInterrupted) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    const Outcome outcome = stop_slow_run(folder, signal);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["verdict"], "ERROR");
    const json& kept = result["outlets"][0]["kept"]["measurements"];
    EXPECT_GT(kept, 0);
    const std::string run = only_run(folder.path() / "runs").string();
    EXPECT_EQ(run_gsbench({"report", run, "--format", "json"}).out, outcome.out);
    const Outcome report = run_gsbench({"report", run});
    EXPECT_THAT(report.out, HasSubstr("interrupted"));
    EXPECT_THAT(report.out, HasSubstr("Kept of sheds-1: " + kept.dump() + " measurement"));
    EXPECT_THAT(run_gsbench({"report", run, "--format", "junit"}).out,
                HasSubstr("not judged; kept: " + kept.dump() + " measurement"));
  }
}

TEST(Interrupt, AHangUpThatTheParentIgnoresDoesNotEndIt) {
  const TemporaryFolder folder;
  const Started started = start_slow_run(folder, [] { std::signal(SIGHUP, SIG_IGN); });
  const Outcome outcome = stop(started, SIGHUP);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["verdict"], "PASS");
}

TEST(Interrupt, AKilledRunIsListedAsUnfinished) {
  const TemporaryFolder folder;
  const Started started = start_slow_run(folder);
  const json in_progress = run_for_json({"runs", "--out", folder.file("runs"), "--json"})[0];
  EXPECT_EQ(in_progress["state"], "in progress");
  EXPECT_TRUE(in_progress["verdict"].is_null());
  EXPECT_EQ(stop(started, SIGKILL).exit_code, 128 + SIGKILL);
  const Outcome list = run_gsbench({"runs", "--out", folder.file("runs")});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(list.err, "");
  EXPECT_THAT(list.out, HasSubstr("  unfinished  ERROR "));
  // The part that was stored can be read.
  const Outcome report = run_gsbench({"report", only_run(folder.path() / "runs").string()});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_THAT(report.out, HasSubstr("did not finish"));
}

}  // namespace
}  // namespace gsbench::test
