// Speed of the closed loop: a thousand outlets for 20 s, compared with its parts. All parts are
// measured alternately in one run, in processor time, so that other load on the machine has little
// influence. Exit code 1 if a figure misses its limit.
#include "measuring.hpp"
#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <fleet/closed_loop.hpp>
#include <models/adc.hpp>
#include <models/noise.hpp>
#include <outlet/outlet.hpp>
#include <profile/load.hpp>

namespace gsbench::performance {
namespace {

constexpr int kRounds = 3;
constexpr double kPlayed_s = 20.0;
constexpr double kLoss_s = 3.0;
constexpr std::size_t kOutlets = 1000;
constexpr std::size_t kPartOutlets = 20;  // in the measurement of the parts
constexpr std::size_t kPiece = 64;        // samples, as in the closed loop

struct Work {
  std::string name;
  std::function<void()> run;
  double outlets;
  std::vector<double> seconds = {};

  // For kOutlets.
  double all_s() const { return median(seconds) * static_cast<double>(kOutlets) / outlets; }
};

void play(const profile::Plan& plan, const fleet::Fleet& fleet, fleet::Strategy strategy) {
  fleet::ClosedLoopOptions options;
  options.after_loss_s = kPlayed_s - kLoss_s;
  campaign::Execution execution;
  execution.threads = 2;
  const auto result = fleet::simulate_closed_loop(plan, fleet, strategy, options, execution);
  if (!(result->nadir_hz > 49.0 && result->nadir_hz < 50.0)) {
    die("the closed loop gives a wrong nadir");
  }
}

// Noise and ADC of one outlet, for all pieces of the signal.
void digitise(const std::vector<float>& voltage_pu, std::uint32_t outlet,
              std::vector<std::int16_t>& counts) {
  std::vector<float> noisy(kPiece);
  for (std::size_t at = 0; at < voltage_pu.size(); at += kPiece) {
    std::copy_n(voltage_pu.data() + at, kPiece, noisy.data());
    models::add_gaussian({1, models::kSourceNoise, outlet}, at, kPiece, 0.01F, noisy.data());
    std::transform(noisy.begin(), noisy.end(), counts.data() + at,
                   [](float pu) { return models::adc_counts(pu, models::kCounts_per_pu); });
  }
}

// The firmware of one outlet, with settings of the grid.
void run_firmware(const gs::outlet::Config& config, const std::vector<std::int16_t>& counts) {
  gs::outlet::State state;
  gs::outlet::Report report;
  for (std::size_t at = 0; at < counts.size();) {
    bool ready = false;
    at += step(config, state, counts.data() + at, counts.size() - at, report, ready);
  }
}

gs::outlet::Config config_of(const grid::Grid& grid) {
  gs::outlet::Hardware hardware;
  hardware.counts_per_pu = models::kCounts_per_pu;
  gs::outlet::Config config;
  gs::outlet::State state;
  control_centre::RequestedSettings requested;
  requested.accumulated_mw = 100.0;
  if (!configure(hardware, config) ||
      apply(config, state, control_centre::outlet_settings(grid, requested, 1)) !=
          gs::outlet::SettingsError::kNone) {
    die("the firmware rejects the settings");
  }
  return config;
}

int run() {
  profile::Plan plan = profile::load_profile("paper/loss-500mw");
  plan.stimulus.duration_s = kPlayed_s;
  const fleet::Fleet fleet = make_fleet(fleet::in_fewer_outlets({}, kOutlets));
  const gs::outlet::Config config = config_of(plan.grid);
  const auto samples =
      static_cast<std::size_t>(kPlayed_s * static_cast<double>(plan.stimulus.sample_rate_hz));
  std::vector<float> voltage_pu(samples);
  plan.synthesizer().render(0, samples, voltage_pu.data());
  std::vector<std::int16_t> counts(samples);
  constexpr auto kAll = static_cast<double>(kOutlets);
  constexpr auto kPart = static_cast<double>(kPartOutlets);

  std::vector<Work> works = {
      {"outlets by the grid's state", [&] { play(plan, fleet, fleet::Strategy::kGsbench); }, kAll},
      {"outlets by the paper", [&] { play(plan, fleet, fleet::Strategy::kPaper); }, kAll},
      {"a clairvoyant", [&] { play(plan, fleet, fleet::Strategy::kClairvoyant500ms); }, kAll},
      {"part: noise and ADC",
       [&] {
         for (std::uint32_t outlet = 0; outlet < kPartOutlets; ++outlet) {
           digitise(voltage_pu, outlet, counts);
         }
       },
       kPart},
      {"part: firmware",
       [&] {
         for (std::size_t outlet = 0; outlet < kPartOutlets; ++outlet) {
           run_firmware(config, counts);
         }
       },
       kPart}};
  digitise(voltage_pu, 0, counts);
  for (int round = 0; round < kRounds; ++round) {
    for (Work& work : works) {
      const double start = own_processor_s();
      work.run();
      work.seconds.push_back(own_processor_s() - start);
    }
  }
  std::printf("median of %d rounds, alternating; processor time for %zu outlets and %g s\n\n",
              kRounds, kOutlets, kPlayed_s);
  for (const Work& work : works) {
    std::printf("  %-40s %10.3f s\n", work.name.c_str(), work.all_s());
  }
  std::putchar('\n');
  const double parts_s = works[3].all_s() + works[4].all_s();
  judge_at_most("the closed loop, compared with noise, ADC and firmware",
                works[0].all_s() / parts_s, "x", 1.8);
  // 5 s on two cores for 20 s.
  judge_at_least("by the grid's state, per outlet, one core", kAll * kPlayed_s / works[0].all_s(),
                 "x real time", 2000.0);
  judge_at_least("by the paper, per outlet, one core", kAll * kPlayed_s / works[1].all_s(),
                 "x real time", 2000.0);
  judge_at_most("a clairvoyant, compared with outlets", works[2].all_s() / works[0].all_s(), "x",
                0.1);
  return exit_code();
}

}  // namespace
}  // namespace gsbench::performance

int main() {
  return gsbench::performance::run();
}
