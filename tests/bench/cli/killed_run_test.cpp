// Runs in real time that are killed by SIGKILL at random instants: what they stored up to a second
// before can be read.
#include "gsbench_process.hpp"
#include <sys/wait.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include <profile/load.hpp>
#include <record/store.hpp>
#include <station/run.hpp>

namespace gsbench::test {
namespace {

using ::testing::HasSubstr;

constexpr int kKills = 100;
constexpr int kAtOnce = 20;
constexpr double kDuration_s = 4.0;
constexpr std::int64_t kRate_hz = 8000;
constexpr std::int64_t kReportTicks = 128;

profile::Plan plan() {
  return profile::parse_profile(
      "title = \"A run that is killed\"\nsource = \"none\"\n[grid]\nsystem = \"ieee24\"\n"
      "[[grid.loss]]\nat_s = 1.0\npower_mw = 500.0\n[signal]\nduration_s = 4.0\nnoise_pct = 1.0\n"
      "[[outlet]]\ncount = 2\naccumulated_mw = 100.0\n"
      "[[expect]]\nmeasure = \"event.count\"\nmax = 1\n",
      "killed.toml");
}

struct Bench {
  pid_t pid = -1;
  int progress = -1;  // the part that has been played, a double for each block
  std::string record;
};

// In a process of its own, which plays in real time and reports each block that it has played.
Bench start(const std::string& record) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t pid = ::fork();
  if (pid == 0) {
    const profile::Plan played = plan();
    station::SimulatedOptions simulated;
    simulated.real_time = true;
    const auto station = station::simulated_station(played, simulated);
    record::Writer writer(record);
    station::RunOptions options;
    options.writer = &writer;
    options.progress = [&](double part) {
      if (::write(ends[1], &part, sizeof part) != sizeof part) {
        ::_exit(1);
      }
    };
    station::run(played, *station, options);
    ::_exit(0);
  }
  ::close(ends[1]);
  return {pid, ends[0], record};
}

// Returns how much of the signal it had played, s.
double kill(const Bench& bench) {
  ::kill(bench.pid, SIGKILL);
  int status = 0;
  EXPECT_EQ(::waitpid(bench.pid, &status, 0), bench.pid);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the run ended before it was killed";
  double played = 0.0;
  for (double part = 0.0; ::read(bench.progress, &part, sizeof part) == sizeof part;) {
    played = part;
  }
  ::close(bench.progress);
  return played * kDuration_s;
}

// Every report of the outlet up to a second before `played_s`, and nothing else.
void expect_reports_until(const record::OutletRecord& outlet, double played_s) {
  const std::vector<std::int64_t>& tick = outlet.trace.tick;
  for (std::size_t i = 0; i < tick.size(); ++i) {
    ASSERT_EQ(tick[i], static_cast<std::int64_t>(i + 1) * kReportTicks);
  }
  const double last_s = static_cast<double>(tick.size() * kReportTicks) / kRate_hz;
  EXPECT_GT(last_s, played_s - 1.0);
  EXPECT_LE(last_s, played_s + 0.1);
  EXPECT_EQ(outlet.verdict, record::Verdict::kError);
}

void expect_kept(const Bench& bench, double played_s) {
  SCOPED_TRACE("played " + std::to_string(played_s) + " s");
  const record::RunRecord run = record::read_run(bench.record);
  EXPECT_TRUE(run.interrupted);
  EXPECT_EQ(run.verdict, record::Verdict::kError);
  for (const record::OutletRecord& outlet : run.outlets) {
    expect_reports_until(outlet, played_s);
  }
  if (played_s > 0.0) {
    EXPECT_EQ(run.outlets.size(), 2U);
  }
  const Outcome report = run_gsbench({"report", bench.record});
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_THAT(report.out, HasSubstr("ERROR: "));
  EXPECT_THAT(report.out, HasSubstr("interrupted"));
}

TEST(KilledRun, KeepsEveryReportUpToASecondBefore) {
  const TemporaryFolder folder;
  std::mt19937 random(20261130);
  int with_reports = 0;
  for (int killed = 0; killed < kKills; killed += kAtOnce) {
    std::vector<Bench> benches;
    std::vector<std::pair<double, std::size_t>> deadlines;
    for (std::size_t i = 0; i < kAtOnce; ++i) {
      benches.push_back(start(folder.file(std::to_string(killed) + "-" + std::to_string(i))));
      deadlines.emplace_back(0.005 + 3.5 * static_cast<double>(random()) / 4294967296.0, i);
    }
    std::sort(deadlines.begin(), deadlines.end());
    const auto begin = std::chrono::steady_clock::now();
    std::vector<double> played_s(kAtOnce);
    for (const auto& [at_s, i] : deadlines) {
      std::this_thread::sleep_until(begin + std::chrono::duration<double>(at_s));
      played_s[i] = kill(benches[i]);
    }
    for (std::size_t i = 0; i < kAtOnce; ++i) {
      if (std::filesystem::exists(benches[i].record)) {
        expect_kept(benches[i], played_s[i]);
      } else {
        EXPECT_EQ(played_s[i], 0.0);
      }
      with_reports += played_s[i] > 0.5 ? 1 : 0;
    }
  }
  EXPECT_GT(with_reports, kKills / 2);
}

}  // namespace
}  // namespace gsbench::test
