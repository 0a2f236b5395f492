#include "commands.hpp"
#include "interrupt.hpp"
#include "output_file.hpp"
#include "progress.hpp"

#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include <models/noise.hpp>
#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

struct WaveformArguments {
  std::string profile;
  profile::Overrides overrides;
  std::string output;
};

// As the first outlet of a simulated station gets it. False where it was interrupted.
bool write_samples(const profile::Plan& plan, const std::atomic<bool>& interrupted,
                   OutputFile& file) {
  const waveform::Synthesizer synthesizer = plan.synthesizer();
  const waveform::Truth& truth = synthesizer.truth();
  const models::Stream stream{plan.seed, models::kSourceNoise, 0};
  const std::int64_t end = plan.duration_ticks();
  constexpr std::int64_t kBlock = 4096;
  Progress progress(plan.name);
  std::vector<float> voltage_pu(kBlock);
  fmt::memory_buffer text;
  file.append("t_s,frequency_hz,rocof_hz_s,voltage_pu\n");
  for (std::int64_t first = 0; first < end; first += kBlock) {
    if (interrupted) {
      return false;
    }
    const auto count = static_cast<std::size_t>(std::min(kBlock, end - first));
    synthesizer.render(first, count, voltage_pu.data());
    models::add_gaussian(stream, static_cast<std::uint64_t>(first), count,
                         plan.stimulus.noise_rms_pu(), voltage_pu.data());
    text.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const double t_s = static_cast<double>(first + static_cast<std::int64_t>(i)) /
                         static_cast<double>(plan.stimulus.sample_rate_hz);
      fmt::format_to(std::back_inserter(text), "{:.6f},{:.9f},{:.9f},{:.7f}\n", t_s,
                     truth.frequency_hz(t_s), truth.rocof_hz_s(t_s), voltage_pu[i]);
    }
    file.append({text.data(), text.size()});
    progress.show(static_cast<double>(first) / static_cast<double>(end));
  }
  return true;
}

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
  auto arguments = std::make_shared<WaveformArguments>();
  const Command command = line.command(
      "waveform", "Write what a profile plays as CSV: t_s, frequency_hz, rocof_hz_s, voltage_pu");
  command.option("profile", arguments->profile, "A shipped profile, or a .toml file").required();
  command.option("-o,--output", arguments->output, "The CSV file; -: standard output").required();
  command.option("--seed", arguments->overrides.seed, "Seed of the noise")
      .range(std::uint64_t{0}, profile::kLargestSeed);
  command.footer("Example:\n  gsbench waveform paper/loss-500mw -o loss.csv");
  command.callback([arguments] { return write_waveform(*arguments); });
}

}  // namespace gsbench::cli
