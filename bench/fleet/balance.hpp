// Frequency response to the loss and all load shed so far.
#pragma once

#include <limits>

#include <fleet/grid_state.hpp>
#include <fleet/scenario.hpp>
#include <grid/sfr_model.hpp>
#include <models/relay_model.hpp>

namespace gsbench::fleet {

constexpr double kNoTime_s = std::numeric_limits<double>::quiet_NaN();
constexpr double kRelay_s = 1e-3 * models::RelayParameters{}.operate_ms;
constexpr double kStep_s = 0.002;  // step of the relays and of the search for the nadir

class Balance {
 public:
  Balance(const grid::SfrModel& model, double loss_mw) : response_(model), loss_mw_(loss_mw) {
    response_.change(0.0, loss_mw);
  }

  void shed(double at_s, double power_mw);  // in the order of time; 0 MW is ignored

  double deviation_hz(double t_s) const { return response_.at(t_s).deviation_hz; }

  // Frequency, nadir and actions up to duration_s; threshold and required power by eq. (15). `shed`
  // gives the outlets that are off; its power_mw is replaced by the power passed to shed().
  ScenarioResult result(const grid::Grid& grid, double duration_s, Shed shed) const;

 private:
  GridResponse response_;
  double loss_mw_;
  double shed_mw_ = 0.0;
  double first_s_ = kNoTime_s;
  double last_s_ = kNoTime_s;
};

}  // namespace gsbench::fleet
