// Outlets with the whole firmware that have measured undisturbed mains for kSettled_s.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <campaign/work.hpp>
#include <grid/grid.hpp>
#include <immunity/disturbance.hpp>
#include <outlet/outlet.hpp>

namespace gsbench::immunity {

constexpr std::uint32_t kMostCases = 10'000'000;
// With this noise, 84 % of the reports of undisturbed mains are measured, and outlets shed after
// every loss; with twice as much, 4 %, and half of the losses are missed.
constexpr double kMostNoise_pct = 10.0;

struct Options {
  std::uint32_t cases = 100'000;  // 1 … kMostCases
  std::uint64_t seed = 1;
  double noise_pct = 1.0;  // white, RMS, % of the nominal peak amplitude; 0 … kMostNoise_pct
  // P^A, 0 … control_centre::largest_accumulated_mw(); the outlet with the least trips first.
  double accumulated_mw = 0.0;
};

// Throws std::invalid_argument, with the range, if an option is out of range.
void check(const grid::Grid& grid, const Options& options);

constexpr double kAfter_s = 3.0;  // a case is played for so long after the disturbance

struct Outcome {
  std::optional<double> event_s;  // of the report with the first event
  std::optional<double> trip_s;   // of the report that opens the relay; the case ends there
};

class SettledOutlets {
 public:
  // Throws std::invalid_argument for an invalid grid or option.
  SettledOutlets(const grid::Grid& grid, const Options& options,
                 const campaign::Execution& execution);

  // Plays a disturbance to an outlet with the settings that the control centre sends for P^A. The
  // case's number selects the outlet, whose reports begin at an instant of its own, and the noise.
  // Thread-safe.
  Outcome play(const Disturbance& disturbance, std::uint32_t number) const;

  const grid::Grid& grid() const { return grid_; }
  const Options& options() const { return options_; }

 private:
  const gs::outlet::State& outlet_of(std::uint32_t number) const;

  grid::Grid grid_;
  Options options_;
  gs::outlet::Config config_;
  std::vector<gs::outlet::State> settled_;  // one for each instant of the reports
};

}  // namespace gsbench::immunity
