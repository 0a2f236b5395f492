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
        sample_rate_hz_(static_cast<double>(plan.stimulus.sample_rate_hz)),
        block_s_(options.block_s > 0.0 ? options.block_s : (options.real_time ? 0.016 : 0.512)) {
    for (const profile::Outlet& outlet : plan.outlets) {
      slots_.push_back({outlet.id, outlet.id, outlet.id, slots_.size()});
    }
  }

  std::string name() const override { return "simulated"; }
  source::Source& source() override { return bench_.source(); }
  link::Link& link() override { return bench_.link(); }
  relay::RelaySense& relay_sense() override { return bench_.relay_sense(); }

  record::BenchUncertainty uncertainty() override {
    // Outlets count the very samples that are played.
    record::BenchUncertainty uncertainty;
    uncertainty.relay_sense_ms =
        1e3 * bench_.relay_sense().alignment().uncertainty_ticks / sample_rate_hz_;
    return uncertainty;
  }

  std::vector<Slot> slots() const override { return slots_; }
  bool outlets_count_ticks() const override { return true; }
  double block_s() const override { return block_s_; }

 private:
  simulated::Bench bench_;
  std::vector<Slot> slots_;
  double sample_rate_hz_;
  double block_s_;
};

class SimulatedFile final : public StationFile {
 public:
  std::unique_ptr<Station> make_station(const profile::Plan& plan,
                                        const SimulatedOptions& simulated) const override {
    return simulated_station(plan, simulated);
  }
};

}  // namespace

StationKind simulated_kind() {
  return {"simulated",
          "outlets in the bench's process",
          {},
          [](const keys::Table&, const std::string&) -> std::unique_ptr<StationFile> {
            return std::make_unique<SimulatedFile>();
          }};
}

std::unique_ptr<Station> simulated_station(const profile::Plan& plan,
                                           const SimulatedOptions& options) {
  return std::make_unique<SimulatedStation>(plan, options);
}

}  // namespace gsbench::station
