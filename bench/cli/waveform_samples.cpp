#include "waveform_samples.hpp"

#include "progress.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include <models/noise.hpp>

namespace gsbench::cli {

bool write_samples(const profile::Plan& plan, const std::atomic<bool>& interrupted,
                   OutputFile& file) {
  const waveform::Synthesizer synthesizer = plan.synthesizer();
  const waveform::ReferenceSignal& reference = synthesizer.reference();
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
                     reference.frequency_hz(t_s), reference.rocof_hz_s(t_s), voltage_pu[i]);
    }
    file.append({text.data(), text.size()});
    progress.show(static_cast<double>(first) / static_cast<double>(end));
  }
  return true;
}

}  // namespace gsbench::cli
