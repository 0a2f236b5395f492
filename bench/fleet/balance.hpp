// The grid with all that has happened to its power so far.
#pragma once

#include <limits>
#include <vector>

#include <fleet/scenario.hpp>
#include <grid/sfr_model.hpp>
#include <models/relay_model.hpp>

namespace gsbench::fleet {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kRelay_s = 1e-3 * models::RelayParameters{}.operate_ms;
constexpr double kLook_s = 0.002;  // of relays, and for the nadir

class Balance {
 public:
  Balance(const grid::SfrModel& model, double loss_mw)
      : model_(model), changes_({{0.0, loss_mw}}) {}

  void shed(double at_s, double power_mw);  // nothing for 0 MW

  double deviation_hz(double t_s) const;
  double excess_cycles(double t_s) const;  // ∫ of that

  // Course, nadir and what was done, up to duration_s. `shed`: by whom; its power is set here.
  ScenarioResult result(const grid::Grid& grid, double duration_s, Shed shed) const;

 private:
  const grid::SfrModel& model_;
  std::vector<grid::PowerChange> changes_;
  double shed_mw_ = 0.0;
  double first_s_ = kNone;
  double last_s_ = kNone;
};

}  // namespace gsbench::fleet
