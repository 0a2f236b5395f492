#include "commands.hpp"
#include "live_output.hpp"
#include "output_file.hpp"
#include "trace_arguments.hpp"
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
  print_recording(plan);
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
      "waveform", "Write the frequency and voltage that a profile plays as CSV", write_waveform);
  add_profile(command, arguments.profile);
  command.add_option("-o,--output", arguments.output, "CSV file to write; - is standard output")
      ->type_name("FILE")
      ->required();
  add_seed(command, arguments.overrides.seed, "Seed of the noise, in place of the profile's");
  add_trace(command, arguments.overrides);
  command.footer(
      "Columns: t_s, frequency_hz, rocof_hz_s, voltage_pu; one row per sample.\n"
      "\n"
      "Example:\n  gsbench waveform paper/loss-500mw -o loss.csv");
}

}  // namespace gsbench::cli
