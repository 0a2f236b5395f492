// The grid of a profile with load shed during the run: its frequency and the mains voltage.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <fleet/grid_state.hpp>
#include <profile/plan.hpp>
#include <waveform/reference_signal.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::fleet {

class PlayedGrid {
 public:
  explicit PlayedGrid(const profile::Plan& plan);

  // Load switched off, or on again if negative. In the order of time.
  void switch_off(double at_s, double power_mw);

  // Of the grid model, without oscillations that are laid over it: deviation, slope (right-hand
  // limit) and lost power less the load that is off.
  GridState state(double t_s) const;

  const std::vector<grid::PowerChange>& losses() const { return plan_.stimulus.losses; }
  const grid::SfrModel& model() const { return shed_->model(); }

  // Samples of the voltage. Load that is switched off before first_tick + count must be known.
  void render(std::int64_t first_tick, std::size_t count, float* out) const;

 private:
  const profile::Plan& plan_;
  std::shared_ptr<const waveform::ReferenceSignal> of_model_;
  std::shared_ptr<const waveform::ReferenceSignal> played_;
  std::shared_ptr<GridResponse> shed_;
  std::vector<double> corners_s_;  // of the profile
  waveform::Synthesizer synthesizer_;
};

}  // namespace gsbench::fleet
