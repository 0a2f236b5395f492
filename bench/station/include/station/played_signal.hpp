// The signal that a source plays in a run: the plan's signal, with or without markers. Markers are
// voltage dips at nominal frequency, before and after the plan's signal. They are needed if outlets
// have their own sample clocks, and serve to align these clocks (capture/clock.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include <capture/clock.hpp>
#include <profile/plan.hpp>
#include <source/stimulus.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::station {

class PlayedSignal final : public source::Stimulus {
 public:
  PlayedSignal(const profile::Plan& plan, bool with_markers);

  // Number of source ticks before tick 0 of the run.
  std::int64_t lead_ticks() const { return lead_ticks_; }
  // In ticks of the run; negative before tick 0.
  const capture::Markers& markers() const { return markers_; }

  std::int64_t sample_rate_hz() const override {
    return parts_.front().synthesizer.sample_rate_hz();
  }
  std::int64_t total_ticks() const override { return lead_ticks_ + run_ticks_ + tail_ticks_; }
  int nominal_hz() const override;
  source::Noise noise() const override { return noise_; }
  double frequency_hz(std::int64_t tick) const override;
  double amplitude_pu(std::int64_t tick) const override;
  void render(std::int64_t first_tick, std::size_t count, float* out) const override;

 private:
  struct Part {
    std::int64_t first_tick;
    waveform::Synthesizer synthesizer;
  };

  const Part& part_at(std::int64_t tick) const;
  // Cumulative sum of squared samples, p.u.²: element i covers i samples from first_tick on.
  std::vector<double> square_sum(std::int64_t first_tick, std::size_t count) const;

  std::int64_t lead_ticks_ = 0;
  std::int64_t run_ticks_;
  source::Noise noise_;
  std::int64_t tail_ticks_ = 0;
  capture::Markers markers_;
  std::vector<Part> parts_;  // ascending
};

}  // namespace gsbench::station
