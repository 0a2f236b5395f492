// The state of a grid's frequency, and its exact response to any number of changes of power.
// Between two changes the deviation y from nominal obeys, with the constants of SfrModel,
//   y'' + 2·sigma·y' + omega_n²·y = −K·omega_n²·p
// where p is the lost power. A change of p by Δp changes y' by −K·g0·Δp, and not y. The effort of a
// change therefore does not depend on how many came before.
#pragma once

#include <vector>

#include <grid/sfr_model.hpp>

namespace gsbench::fleet {

struct GridState {
  double deviation_hz = 0.0;
  double slope_hz_s = 0.0;  // ROCOF
  double power_mw = 0.0;    // lost; negative: more is shed than was lost
  double cycles = 0.0;      // ∫ deviation_hz dt
};

// The state duration_s later without a further change of power. duration_s >= 0.
GridState later(const grid::SfrModel& model, const GridState& state, double duration_s);

// The state just after the lost power has changed to power_mw.
GridState with_power(const grid::SfrModel& model, const GridState& state, double power_mw);

// Lowest deviation from now on without a further change of power, Hz, in closed form. If the
// deviation falls towards its final value without a minimum, it is that value.
double lowest_deviation_hz(const grid::SfrModel& model, const GridState& state);

// Response to changes of power that are added in the order of time. It starts at a steady nominal
// frequency.
class GridResponse {
 public:
  explicit GridResponse(const grid::SfrModel& model) : model_(model) {}

  // Adds power_mw to the lost power: positive is lost, negative is shed. Throws
  // std::invalid_argument for a time before the latest change, and for values that are not finite.
  void change(double at_s, double power_mw);

  GridState at(double t_s) const;  // right-hand limit; the time may be before the latest change
  // Times of the changes in [from_s, end_s), ascending.
  std::vector<double> changes_s(double from_s, double end_s) const;
  const grid::SfrModel& model() const { return model_; }

 private:
  struct Change {
    double at_s;
    GridState state;  // just after it
  };

  grid::SfrModel model_;
  std::vector<Change> changes_;  // ascending, each time once
};

}  // namespace gsbench::fleet
