// Speed of the chain from synthesis to capture, compared with its parts. All parts are measured
// alternately in one run, in processor time, so that other load on the machine has little
// influence. Exit code 1 if a figure misses its limit.
#include "fake_station.hpp"
#include "measuring.hpp"

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <app/application.hpp>
#include <models/noise.hpp>
#include <profile/load.hpp>
#include <station/run.hpp>

namespace gsbench::performance {
namespace {

constexpr int kRounds = 7;
constexpr double kPlayed_s = 60.0;
constexpr std::size_t kBlock = 4096;

double wall_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Work {
  std::string name;
  std::function<void()> run;
  double (*clock)() = own_processor_s;
  std::vector<double> seconds = {};

  double median() const { return performance::median(seconds); }
};

profile::Plan plan_for(std::size_t outlets) {
  profile::Plan plan = profile::load_profile("paper/loss-500mw");
  plan.stimulus.duration_s = kPlayed_s;
  plan.outlets.resize(outlets, plan.outlets.front());
  return plan;
}

void play_simulated(const profile::Plan& plan) {
  const auto station = station::simulated_station(plan, {});
  station::run(plan, *station, {});
}

// Renders the voltage of the whole plan block by block.
template <class Use>
void for_each_block(const profile::Plan& plan, Use use) {
  const waveform::Synthesizer synthesizer = plan.synthesizer();
  std::vector<float> block(kBlock);
  for (std::int64_t tick = 0; tick < plan.duration_ticks();
       tick += static_cast<std::int64_t>(kBlock)) {
    synthesizer.render(tick, kBlock, block.data());
    use(block);
  }
}

class Discard final : public gs::app::Outbox {
 public:
  void put(const gs::wire::Uplink&) override {}
};

void feed_firmware(const std::vector<std::int16_t>& samples) {
  gs::app::Application node;
  Discard discard;
  node.start({}, {}, nullptr, discard);
  node.feed(samples.data(), samples.size(), discard);
}

int run() {
  const profile::Plan one = plan_for(1);
  const profile::Plan eight = plan_for(8);
  const double samples = kPlayed_s * static_cast<double>(one.stimulus.sample_rate_hz);
  std::vector<std::int16_t> counts;
  for_each_block(one, [&](const std::vector<float>& block) {
    for (const float voltage_pu : block) {
      counts.push_back(static_cast<std::int16_t>(voltage_pu * 20000.0F));
    }
  });
  constexpr int kSteps = 3750;  // kPlayed_s in steps of 16 ms
  const models::Stream stream{1, models::kTest, 0};

  std::vector<Work> works = {
      {"chain, one outlet", [&] { play_simulated(one); }},
      {"chain, eight outlets", [&] { play_simulated(eight); }},
      {"synthesis", [&] { for_each_block(one, [](const std::vector<float>&) {}); }},
      {"noise",
       [&] {
         std::vector<float> block(kBlock);
         for (std::uint64_t n = 0; n < static_cast<std::uint64_t>(samples); n += kBlock) {
           models::add_gaussian(stream, n, kBlock, 0.01F, block.data());
         }
       }},
      {"firmware", [&] { feed_firmware(counts); }},
      {"station, idle drivers, steps of 16 ms",
       [&] {
         station::test::Script idle;
         idle.outlets = 8;
         idle.relay_channels = 0;
         idle.block_s = 0.016;
         station::test::FakeStation station(idle);
         station::run(eight, station, {});
       }},
      {"gsbench --help", [] { run_or_die(GSBENCH_PROGRAM " --help >/dev/null"); }, wall_s},
      {"true", [] { run_or_die("/bin/true >/dev/null"); }, wall_s},
  };
  for (int round = 0; round < kRounds; ++round) {
    for (Work& work : works) {
      const double start = work.clock();
      work.run();
      work.seconds.push_back(work.clock() - start);
    }
  }
  std::printf("median of %d rounds, alternating between the parts; %g s played at %lld Hz\n\n",
              kRounds, kPlayed_s, static_cast<long long>(one.stimulus.sample_rate_hz));
  for (const Work& work : works) {
    std::printf("  %-40s %10.3f ms", work.name.c_str(), 1e3 * work.median());
    if (work.clock == own_processor_s) {
      std::printf("  %8.2f ns/sample", 1e9 * work.median() / samples);
    }
    std::putchar('\n');
  }
  const double parts_s = works[2].median() + works[3].median() + works[4].median();
  std::printf("\n  the chain takes %.2f times the sum of synthesis, noise and firmware\n\n",
              works[0].median() / parts_s);
  judge_at_least("chain, one outlet, one core", kPlayed_s / works[0].median(), "x real time", 1000);
  judge_at_least("chain, eight outlets, per outlet, one core", 8.0 * kPlayed_s / works[1].median(),
                 "x real time", 1000);
  judge_at_most("one step of the station, eight outlets", 1e3 * works[5].median() / kSteps, "ms",
                0.1);
  judge_at_most("gsbench --help, minus an empty process",
                1e3 * (works[6].median() - works[7].median()), "ms", 50);
  return exit_code();
}

}  // namespace
}  // namespace gsbench::performance

int main() {
  return gsbench::performance::run();
}
