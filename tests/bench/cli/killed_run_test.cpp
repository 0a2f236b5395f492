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

std::string profile_of(const char* duration_s) {
  return std::string(
             "title = \"A run that is killed\"\nsource = \"none\"\n[grid]\nsystem = \"ieee24\"\n"
             "[[grid.loss]]\nat_s = 1.0\npower_mw = 500.0\n[signal]\nnoise_pct = 1.0\n"
             "duration_s = ") +
         duration_s +
         "\n[[outlet]]\ncount = 2\naccumulated_mw = 100.0\n"
         "[[expect]]\nmeasure = \"event.count\"\nmax = 1\n";
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
    const profile::Plan played = profile::parse_profile(profile_of("4.0"), "killed.toml");
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
  const std::vector<std::int64_t>& tick = outlet.reports.trace.tick;
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

// Of the first outlet of the only run in this folder; 0 if there is none yet.
double kept_until_s(const std::string& output_folder) {
  if (!std::filesystem::exists(output_folder) || std::filesystem::is_empty(output_folder)) {
    return 0.0;
  }
  const std::string run = std::filesystem::directory_iterator(output_folder)->path();
  const Outcome outcome = run_gsbench({"report", run, "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["interrupted"], true);
  EXPECT_EQ(report["verdict"], "ERROR");
  return report["outlets"].empty() || report["outlets"][0]["kept"]["until_s"].is_null()
             ? 0.0
             : report["outlets"][0]["kept"]["until_s"].get<double>();
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

// What `gsbench report` reads while the run is played it also reads once the run is killed.
TEST(KilledRun, OfTheProgramKeepsWhatCouldBeReadBefore) {
  constexpr std::size_t kPrograms = 6;
  constexpr double kLongest_s = 9.0;
  const TemporaryFolder folder;
  const std::string profile = folder.write("killed.toml", profile_of("30.0"));
  std::mt19937 random(4);
  int kept = 0;
  for (const Words& station : {Words{"--real-time"}, Words{"--station", "emulated"}}) {
    std::vector<Started> started;
    std::vector<std::pair<double, std::size_t>> deadlines;
    const auto out = [&](std::size_t i) { return folder.file(station.back() + std::to_string(i)); };
    for (std::size_t i = 0; i < kPrograms; ++i) {
      Words words = {"run", profile, "--out", out(i)};
      words.insert(words.end(), station.begin(), station.end());
      started.push_back(start_gsbench(words));
      deadlines.emplace_back(0.1 + kLongest_s * static_cast<double>(random()) / 4294967296.0, i);
    }
    std::sort(deadlines.begin(), deadlines.end());
    const auto begin = std::chrono::steady_clock::now();
    for (const auto& [at_s, i] : deadlines) {
      SCOPED_TRACE(station.back() + ", killed after " + std::to_string(at_s) + " s");
      std::this_thread::sleep_until(begin + std::chrono::duration<double>(at_s));
      const double before_s = kept_until_s(out(i));
      EXPECT_EQ(stop(started[i], SIGKILL).exit_code, 128 + SIGKILL);
      const std::chrono::duration<double> run = std::chrono::steady_clock::now() - begin;
      const double after_s = kept_until_s(out(i));
      EXPECT_GE(after_s, before_s);
      EXPECT_LT(after_s, run.count());
      kept += after_s > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(kept, static_cast<int>(kPrograms) / 2);
}

}  // namespace
}  // namespace gsbench::test
