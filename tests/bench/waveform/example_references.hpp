// Reference signals for several tests.
#pragma once

#include <memory>
#include <vector>

#include <grid/sfr_model.hpp>
#include <waveform/reference_signal.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::waveform {

// The modified IEEE 24-bus system of Xiang et al. as one plant.
inline grid::SfrModel ieee24() {
  grid::Grid grid;
  grid.base_mw = 2745.0;
  grid.load_mw = 2745.0;
  grid.damping_pu = 2.5;
  grid.plants = {{"all", 2745.0, 9.2161, 1.0 / 21.8601}};
  return grid::SfrModel(grid);
}

inline std::shared_ptr<const ReferenceSignal> loss_of_500_mw(double at_s) {
  return reference_from_losses(ieee24(), {{at_s, 500.0}});
}

inline std::shared_ptr<const ReferenceSignal> constant(double nominal_hz, double frequency_hz) {
  return reference_from_points(nominal_hz, {{0.0, frequency_hz}});
}

inline std::vector<float> render(const Synthesizer& synthesizer, std::int64_t first_tick,
                                 std::size_t count) {
  std::vector<float> samples(count);
  synthesizer.render(first_tick, count, samples.data());
  return samples;
}

// Orders and amplitudes of EN 50160, in %, each with a different phase.
inline std::vector<Harmonic> en50160_harmonics() {
  std::vector<Harmonic> harmonics = {{3, 5.0, 0},  {5, 6.0, 0},  {7, 5.0, 0},  {9, 1.5, 0},
                                     {11, 3.5, 0}, {13, 3.0, 0}, {15, 0.5, 0}, {17, 2.0, 0},
                                     {19, 1.5, 0}, {21, 0.5, 0}, {23, 1.5, 0}, {25, 1.5, 0},
                                     {2, 2.0, 0},  {4, 1.0, 0}};
  for (int order = 6; order <= 24; order += 2) {
    harmonics.push_back({static_cast<double>(order), 0.5, 0});
  }
  for (Harmonic& harmonic : harmonics) {
    harmonic.phase_deg = 37.0 * harmonic.order;
  }
  return harmonics;
}

}  // namespace gsbench::waveform
