#include "run_steps.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <waveform/synthesizer.hpp>

namespace gsbench::station {
namespace {

// "500 MW", "-20°", "40 %": at most four digits.
std::string figure(double value, const char* unit) {
  return fmt::format("{:.4g}{}", value, unit);
}

}  // namespace

std::vector<record::Mark> stimulus_marks(const profile::Plan& plan) {
  const auto tick = [&plan](double at_s) {
    return waveform::tick_at(at_s, plan.stimulus.sample_rate_hz);
  };
  std::vector<record::Mark> marks;
  for (const grid::PowerChange& loss : plan.stimulus.losses) {
    const bool lost = loss.power_mw > 0.0;
    marks.push_back({tick(loss.at_s), lost ? "loss" : "shed", loss.power_mw,
                     figure(std::fabs(loss.power_mw), " MW") + (lost ? " lost" : " shed")});
  }
  for (const waveform::PhaseJump& jump : plan.stimulus.signal.phase_jumps) {
    marks.push_back(
        {tick(jump.at_s), "phase jump", jump.degrees, figure(jump.degrees, "° phase jump")});
  }
  for (const waveform::AmplitudeStep& step : plan.stimulus.signal.amplitude_steps) {
    marks.push_back(
        {tick(step.at_s), "amplitude", step.level_pct, "voltage " + figure(step.level_pct, " %")});
    if (std::isfinite(step.duration_s)) {
      marks.push_back({tick(step.at_s + step.duration_s), "amplitude", 100.0, "voltage restored"});
    }
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const record::Mark& a, const record::Mark& b) { return a.tick < b.tick; });
  return marks;
}

}  // namespace gsbench::station
