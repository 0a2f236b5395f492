// Speed of campaigns: compared with the same work in vectorised NumPy, with the peak arithmetic
// throughput of the processor, and for several numbers of threads and trajectories. All parts are
// measured alternately in one run. Exit code 1 if a figure misses its limit.
#include "measuring.hpp"
#include <sys/resource.h>
#include <test_support/output_of.hpp>

#include <array>
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include <campaign/estimates.hpp>
#include <campaign/kernel.hpp>
#include <models/targets.hpp>
#include <profile/load.hpp>

namespace gsbench::performance {
namespace {

using campaign::kLanes;
using campaign::Lanes;
using std::chrono::steady_clock;

constexpr int kRounds = 3;
constexpr std::uint64_t kTrajectories = 1000000;
// Operations in one update of the EKF, including comparisons and selections, counted in
// response.hpp, arithmetic.hpp and loss_ekf.hpp: 92 of them in u and u', of which 20 are in the
// exponential function.
constexpr double kOperations = 146.0;

double numpy_s(int seed) {
  const std::string command = "/usr/bin/python3 " GSBENCH_SOURCE_DIR
                              "/tests/performance/peers/estimates.py " +
                              std::to_string(kTrajectories) + ' ' + std::to_string(seed);
  const test::Output output = test::output_of(command);
  if (output.exit_code != 0) {
    die("the NumPy program failed; is python3-numpy installed?");
  }
  char* rest = nullptr;
  const double seconds = std::strtod(output.text.c_str(), &rest);
  if (std::strtod(rest, nullptr) < 0.999) {
    die("the NumPy program gives other results than the campaign");
  }
  return seconds;
}

double campaign_s(const grid::Grid& grid, std::size_t threads,
                  std::uint64_t trajectories = kTrajectories) {
  campaign::EstimateOptions options;
  options.trajectories = trajectories;
  campaign::Execution execution;
  execution.threads = threads;
  const auto begin = steady_clock::now();
  const auto result = estimate(grid, options, execution);
  const double seconds = seconds_since(begin);
  if (result.ekf_mw.share_between(480.0, 520.0) < 0.999) {
    die("the results of the campaign are wrong");
  }
  return seconds;
}

// Time of one EKF update on one thread, without the generation of noise.
double step_ns(const grid::Grid& grid) {
  constexpr int kBatches = 4000;
  const auto settings = campaign::estimate_settings(grid);
  std::vector<float> deviations_hz;
  const auto one = campaign::trajectory(grid, {}, 1);
  for (const float deviation_hz : one) {
    deviations_hz.insert(deviations_hz.end(), kLanes, deviation_hz);
  }
  float sum_mw = 0.0F;
  const auto begin = steady_clock::now();
  for (int batch = 0; batch < kBatches; ++batch) {
    sum_mw +=
        campaign::estimate_as_outlet(settings, settings.response, deviations_hz.data()).ekf_mw[0];
  }
  const double seconds = seconds_since(begin);
  if (sum_mw <= 0.0F) {
    die("the results of the kernel are wrong");
  }
  return 1e9 * seconds /
         (kBatches * static_cast<double>(kLanes) * static_cast<double>(campaign::kEkfSamples + 4));
}

// Independent multiplications and additions, on as many lanes as the kernel uses.
inline float multiply_and_add(int rounds) {
  constexpr std::size_t kChains = 3;  // of kLanes each: all AVX2 registers but four
  std::array<Lanes, kChains> chains{};
  for (int i = 0; i < rounds; ++i) {
    for (Lanes& chain : chains) {
      chain = chain * 0.999F + 1.0F;
    }
  }
  float values[kLanes];
  store(chains[0] + chains[1] + chains[2], values);
  return values[0];
}
// Peak throughput in operations per ns.
double peak_per_ns() {
  constexpr int kMany = 3000000;
  const auto begin = steady_clock::now();
  float result = 0.0F;
  models::run_on_this_machine([&] { result = multiply_and_add(kMany); });
  const double seconds = seconds_since(begin);
  if (!(result > 0.0F)) {
    die("the peak was not computed");
  }
  return 3.0 * 2.0 * static_cast<double>(kLanes) * kMany / (1e9 * seconds);
}

double largest_memory_mb() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0;
}

double reproduce_s() {
  const auto begin = steady_clock::now();
  run_or_die(GSBENCH_PROGRAM " reproduce --n 1000000 >/dev/null");
  return seconds_since(begin);
}

int run() {
  const grid::Grid grid = profile::load_grid("ieee24");
  std::vector<double> numpy;
  std::vector<double> two_threads;
  std::vector<double> one_thread;
  std::vector<double> step;
  std::vector<double> peak;
  for (int round = 0; round < kRounds; ++round) {
    numpy.push_back(numpy_s(round + 1));
    two_threads.push_back(campaign_s(grid, 2));
    one_thread.push_back(campaign_s(grid, 1));
    step.push_back(step_ns(grid));
    peak.push_back(peak_per_ns());
  }
  print("1e6 trajectories of LSE and EKF in NumPy", median(numpy), "s");
  print("the same in gsbench, one thread", median(one_thread), "s");
  print("the same in gsbench, two threads", median(two_threads), "s");
  judge_at_least("  speed-up over NumPy", median(numpy) / median(two_threads), "x", 10.0);
  print("  speed-up over one thread", median(one_thread) / median(two_threads), "x");
  print("one update of the EKF, one thread", median(step), "ns");
  print("  its operations", kOperations / median(step), "1/ns");
  print("  peak multiplications and additions", median(peak), "1/ns");
  print("  share of the peak", kOperations / median(step) / median(peak), "");
  const double before_mb = largest_memory_mb();
  const double long_s = campaign_s(grid, 2, 100 * kTrajectories);
  print("1e8 trajectories in gsbench, two threads", long_s, "s");
  judge_at_most("  additional memory over 1e6 trajectories", largest_memory_mb() - before_mb, "MB",
                1.0);
  judge_at_most("gsbench reproduce --n 1000000", reproduce_s(), "s", 30.0);
  return exit_code();
}

}  // namespace
}  // namespace gsbench::performance

int main() {
  return gsbench::performance::run();
}
