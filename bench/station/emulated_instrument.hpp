// The emulated instrument of an emulated station, and the driver that plays on it. The driver is
// the one of physical stations, connected to the emulator's TCP port. The wire brings the
// instrument's output to the terminals of the emulated outlets (emulation/wire.hpp).
#pragma once

#include "source_kind.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <emulation/generator.hpp>
#include <emulation/hardware.hpp>
#include <emulation/terminal_sense.hpp>
#include <emulation/wire.hpp>
#include <keys/table.hpp>
#include <profile/plan.hpp>
#include <relay/relay_sense.hpp>
#include <station/played_signal.hpp>

namespace gsbench::station {

enum class EmulatedSense { kTerminals, kHead, kModemLine };

struct InstrumentOptions {
  std::optional<emulation::GeneratorModel> generator;  // none: a DAC head
  double clock_ppm = 0.0;                              // true error, positive: fast
  SourceSettings settings;
  SourceFactory make_source;
  EmulatedSense sense = EmulatedSense::kTerminals;
};

// Keys of an emulated station: [source] and [relay].
std::vector<keys::Key> instrument_station_keys();
// nullopt: the station has no [source], so its outlets are fed directly.
std::optional<InstrumentOptions> read_instrument_options(
    const keys::Table& top, const std::string& file_path,
    const std::vector<emulation::HardwareOutlet>& outlets);

class EmulatedInstrument {
 public:
  // `hardware` must outlive this object. Throws std::runtime_error if the set-up fails.
  // `signal`: as the source will be given it.
  EmulatedInstrument(const InstrumentOptions& options, const profile::Plan& plan,
                     const PlayedSignal& signal, emulation::Hardware& hardware);
  ~EmulatedInstrument();
  EmulatedInstrument(const EmulatedInstrument&) = delete;
  EmulatedInstrument& operator=(const EmulatedInstrument&) = delete;

  source::Source& source() { return *driver_.source; }
  relay::RelaySense& relay_sense() { return *sense_; }
  // How the relay sense is aligned with the source, for reports.
  const std::string& relay_aligned_by() const { return relay_aligned_by_; }
  const emulation::Wire& wire() const { return *wire_; }

 private:
  InstrumentOptions options_;
  emulation::TrueTime time_;
  std::unique_ptr<emulation::Output> emulator_;
  std::string port_;
  BuiltSource driver_;
  std::unique_ptr<emulation::Wire> wire_;
  std::shared_ptr<relay::RelaySense> sense_;
  std::string relay_aligned_by_;
};

}  // namespace gsbench::station
