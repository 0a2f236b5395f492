// Station files of emulated outlets.
#pragma once

#include <emulation/hardware.hpp>
#include <station/station_file.hpp>

namespace gsbench::station {

class EmulatedFile final : public StationFile {
 public:
  std::optional<std::size_t> outlets() const override { return hardware.size(); }
  std::unique_ptr<Station> make_station(const profile::Plan& plan,
                                        const SimulatedOptions& simulated) const override;

  std::vector<emulation::HardwareOutlet> hardware;
  std::string image;  // of the boards in qemu; empty: those that were built
};

}  // namespace gsbench::station
