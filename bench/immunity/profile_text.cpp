#include <cmath>

#include <fmt/format.h>

#include <immunity/profile_text.hpp>
#include <keys/document.hpp>

namespace gsbench::immunity {
namespace {

std::string span(double at_s, double duration_s) {
  return fmt::format("at_s={}, duration_s={}", at_s, duration_s);
}

// An array of inline tables, one a line, short enough for a line of a terminal. Empty without any.
template <class Item, class Text>
std::string array(const char* key, const std::vector<Item>& items, const Text& text) {
  std::string lines;
  for (const Item& item : items) {
    lines += fmt::format("{{{}}},\n", text(item));
  }
  return lines.empty() ? "" : fmt::format("{} = [\n{}]\n", key, lines);
}

}  // namespace

std::string signal_keys(const Disturbance& disturbance, double noise_pct) {
  // Past the last change, so that it is within the run in spite of rounding.
  const double duration_s = std::ceil(disturbance.end_s + kAfter_s);
  std::string text = fmt::format("duration_s = {}\nsample_rate_hz = {}\nnoise_pct = {}\n",
                                 duration_s, kSampleRate_hz, noise_pct);
  const waveform::SignalSpec& signal = disturbance.signal;
  text += array("amplitude_step", signal.amplitude_steps, [](const waveform::AmplitudeStep& step) {
    return fmt::format("{}, level_pct={}", span(step.at_s, step.duration_s), step.level_pct);
  });
  text += array("phase_jump", signal.phase_jumps, [](const waveform::PhaseJump& jump) {
    return fmt::format("at_s={}, degrees={}", jump.at_s, jump.degrees);
  });
  text += array("tone", signal.tones, [](const waveform::Tone& tone) {
    return fmt::format("{}, frequency_hz={}, amplitude_pct={}, phase_deg={}",
                       span(tone.at_s, tone.duration_s), tone.frequency_hz, tone.amplitude_pct,
                       tone.phase_deg);
  });
  text += array("oscillation", disturbance.oscillations, [](const waveform::Oscillation& o) {
    return fmt::format("{}, frequency_hz={}, amplitude_mhz={}, phase_deg={}",
                       span(o.at_s, o.duration_s), o.frequency_hz,
                       std::round(1e4 * o.amplitude_hz) / 10.0, o.phase_deg);
  });
  return text;
}

std::string profile_text(const Disturbance& disturbance, std::uint32_t number,
                         const std::string& grid, const Options& options) {
  return fmt::format(
      "title = \"Case {} of gsbench immunity, seed {}: {}\"\n"
      "source = \"gsbench immunity\"\n"
      "\n"
      "[grid]\n"
      "system = {}\n"
      "\n"
      "[signal]\n"
      "{}"
      "\n"
      "[[outlet]]\n"
      "count = 8\n"
      "accumulated_mw = {}\n"
      "\n"
      "[[expect]]\n"
      "measure = \"relay.edges\"\n"
      "max = 0\n",
      number, options.seed, kKinds[static_cast<std::size_t>(disturbance.kind)].name,
      keys::quoted(grid), signal_keys(disturbance, options.noise_pct), options.accumulated_mw);
}

}  // namespace gsbench::immunity
