#include "station_kind.hpp"

#include <simulated/bench.hpp>

namespace gsbench::station {
namespace {

simulated::BenchParameters parameters_of(const profile::Plan& plan,
                                         const SimulatedOptions& options) {
  simulated::BenchParameters parameters;
  for (const profile::Outlet& outlet : plan.outlets) {
    parameters.outlet_ids.push_back(outlet.id);
  }
  parameters.pace = options.real_time ? simulated::Pace::kRealTime : simulated::Pace::kVirtual;
  parameters.threads = options.threads;
  return parameters;
}

class SimulatedStation final : public Station {
 public:
  SimulatedStation(const profile::Plan& plan, const SimulatedOptions& options)
      : bench_(parameters_of(plan, options)),
        block_s_(options.block_s > 0.0 ? options.block_s : (options.real_time ? 0.016 : 0.512)) {
    for (const profile::Outlet& outlet : plan.outlets) {
      slots_.push_back({outlet.id, outlet.id, outlet.id, slots_.size()});
    }
  }

  std::string name() const override { return "simulated"; }
  source::Source& source() override { return bench_.source(); }
  link::Link& link() override { return bench_.link(); }
  relay::RelaySense& relay_sense() override { return bench_.relay_sense(); }
  std::vector<Slot> slots() const override { return slots_; }
  bool outlets_count_ticks() const override { return true; }
  double block_s() const override { return block_s_; }

 private:
  simulated::Bench bench_;
  std::vector<Slot> slots_;
  double block_s_;
};

}  // namespace

StationKind simulated_kind() {
  return {"simulated",
          "outlets inside the bench's process",
          {},
          [](const keys::Table&, StationFile& file) { file.make_station = simulated_station; }};
}

std::unique_ptr<Station> simulated_station(const profile::Plan& plan,
                                           const SimulatedOptions& options) {
  return std::make_unique<SimulatedStation>(plan, options);
}

}  // namespace gsbench::station
