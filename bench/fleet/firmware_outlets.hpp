// Outlets that run the whole firmware, each behind an ADC of its own.
#pragma once

#include "balance.hpp"

#include <cstdint>
#include <vector>

#include <drivers/workers.hpp>
#include <fleet/closed_loop.hpp>
#include <outlet/outlet.hpp>

namespace gsbench::fleet {

constexpr std::int64_t kRelay_ms = 8;
static_assert(kRelay_s == 1e-3 * static_cast<double>(kRelay_ms));

// Load that relays switch off, or on again if negative.
struct Switched {
  std::int64_t tick;
  double power_mw;
};

class FirmwareOutlets {
 public:
  // first_loss_tick: claims of an event before are false. When the profile sends settings again,
  // each outlet gets its own again; the profile's changes are for its own outlets. Throws
  // std::invalid_argument for settings that the firmware rejects.
  FirmwareOutlets(const profile::Plan& plan, const Fleet& fleet, Strategy strategy,
                  const Controls& controls, std::int64_t first_loss_tick, std::size_t threads);

  // Takes the voltage of at most kRelay_ms from first_tick on, in the order of time. Returns what
  // switches kRelay_ms after an outlet's report, in the order of time: after these samples, and
  // within as many that follow.
  std::vector<Switched> take(std::int64_t first_tick, const std::vector<float>& voltage_pu);

  OutletActions actions() const;

 private:
  struct Outlet {
    gs::outlet::Config config;
    gs::outlet::State state;
    std::size_t skipped = 0;  // samples before its first report: they report at different instants
    std::int64_t event_tick = -1;  // the first after the loss
    bool false_event = false;
    bool was_off = false;
    std::optional<double> loss_mw;  // at the first decision
  };

  gs::outlet::Settings settings_of(std::size_t outlet) const;
  void configure();
  void send_settings_again(std::int64_t before_tick);
  void feed(std::size_t chunk, std::int64_t first_tick, const std::vector<float>& voltage_pu);
  void note(std::size_t number, const gs::outlet::Report& report, std::int64_t tick);

  const profile::Plan& plan_;
  const Fleet& fleet_;
  std::int64_t first_loss_tick_;
  gs::outlet::Settings settings_;      // that are the same for all outlets
  std::vector<double> switch_off_hz_;  // of each group
  std::size_t updates_ = 0;            // that were sent
  gs::outlet::Hardware hardware_;
  std::vector<Outlet> outlets_;
  std::vector<std::vector<Switched>> switched_;  // by chunk, in the present samples
  drivers::Workers workers_;
};

}  // namespace gsbench::fleet
