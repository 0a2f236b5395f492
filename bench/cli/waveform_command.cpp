#include "commands.hpp"
#include "output_file.hpp"
#include "waveform_samples.hpp"

#include <cstdio>

namespace gsbench::cli {
namespace {

struct WaveformArguments {
  std::string profile;
  profile::Overrides overrides;
  std::string output;
};

int write_waveform(const WaveformArguments& arguments) {
  const profile::Plan plan = profile::load_profile(arguments.profile, arguments.overrides);
  const std::atomic<bool>& interrupted = catch_interrupts();
  OutputFile file(arguments.output, {plan.path, plan.grid.path, plan.stimulus.recording.path});
  if (!write_samples(plan, interrupted, file)) {
    return kInterrupted;
  }
  file.commit();
  if (!file.is_standard_output()) {
    std::printf("%s: %lld samples\n", arguments.output.c_str(),
                static_cast<long long>(plan.duration_ticks()));
  }
  return kPassed;
}

}  // namespace

void add_waveform(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "waveform", "Write what a profile plays as CSV: t_s, frequency_hz, rocof_hz_s, voltage_pu",
      write_waveform);
  command.add_option("profile", arguments.profile, "A shipped profile, or a .toml file")
      ->required();
  command.add_option("-o,--output", arguments.output, "The CSV file; -: standard output")
      ->required();
  command.add_option("--seed", arguments.overrides.seed, "Seed of the noise")->check(kSeeds);
  command.footer("Example:\n  gsbench waveform paper/loss-500mw -o loss.csv");
}

}  // namespace gsbench::cli
